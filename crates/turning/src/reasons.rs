//! Reasons why something is not made, each with its sentence.

/// An enum of reasons and its `note`: each variant with its sentence, whose figures are its fields; `as` says how a field is told. At
/// the end stand reasons of other rooms, which have notes of their own.
macro_rules! reasons {
    (
        $(#[$outer:meta])*
        pub enum $name:ident {
            $(
                $(#[$doc:meta])*
                $variant:ident $({ $($(#[$of:meta])* $field:ident: $type:ty $(as $figure:expr)?),+ $(,)? })? = note!($code:literal),
            )+
        }
        $(of others { $($(#[$other_doc:meta])* $other:ident($inner:ty),)+ })?
    ) => {
        $(#[$outer])*
        pub enum $name {
            $($(#[$doc])* $variant $({ $($(#[$of])* $field: $type),+ })?,)+
            $($($(#[$other_doc])* $other($inner),)+)?
        }

        impl $name {
            /// The sentence.
            pub fn note(&self) -> $crate::note::Note {
                match self {
                    $(Self::$variant $({ $($field),+ })? => {
                        $crate::note::Note::new($code)
                            $($(.with(stringify!($field), $crate::turning::reasons::figure!($field $(as $figure)?)))+)?
                    })+
                    $($(Self::$other(why) => why.note(),)+)?
                }
            }
        }
    };
}

/// A field as the figure of a sentence.
macro_rules! figure {
    ($field:ident) => {
        $field
    };
    ($field:ident as $figure:expr) => {
        $figure
    };
}

pub(crate) use {figure, reasons};
