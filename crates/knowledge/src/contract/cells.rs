//! Conversions between table values and Rust types, for cells and for inputs of questions.

use super::{AsInput, CellShape, FromCell, FromValue, Holds, Named, Word};
use crate::query::Input;
use crate::table::Cell;
use crate::units::{
    Brinell, Decimal, Degrees, ItGrade, Kilograms, Kilowatts, Megapascals, MetresPerMinute, Micrometres, Microns,
    MillimetresPerMinute, MillimetresPerRev, MillimetresPerSecondSquared, MillimetresPerTooth, Minutes, NewtonMetres,
    Newtons, Percent, RevsPerMinute, Roughness, Seconds, Unit,
};
use crate::value::Value;

impl<'t, T: FromValue<'t>> FromCell<'t> for T {
    const SHAPE: CellShape = CellShape::single(T::HOLDS);

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Value(value) => T::from_value(value),
            _ => None,
        }
    }
}

impl<'t, T: FromValue<'t>> FromCell<'t> for Vec<T> {
    const SHAPE: CellShape = CellShape { list: true, ..CellShape::single(T::HOLDS) };

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Value(Value::List(items)) => items.iter().map(T::from_value).collect(),
            _ => None,
        }
    }
}

impl<'t, T: FromCell<'t>> FromCell<'t> for Option<T> {
    const SHAPE: CellShape = CellShape { optional: true, ..T::SHAPE };

    fn from_cell(cell: &'t Cell) -> Option<Self> {
        match cell {
            Cell::Empty => Some(None),
            cell => T::from_cell(cell).map(Some),
        }
    }
}

impl<T: AsInput> AsInput for Option<T> {
    const SHAPE: CellShape = CellShape { optional: true, ..T::SHAPE };

    fn as_input(&self) -> Option<Input<'_>> {
        self.as_ref().and_then(T::as_input)
    }
}

impl<'t, W: Word> FromValue<'t> for Named<'t, W> {
    const HOLDS: Holds = Holds::Name(W::WORDS);

    fn from_value(value: &'t Value) -> Option<Self> {
        let name = value.as_text()?;
        Some(W::from_word(name).map_or(Self::Other(name), Self::Read))
    }
}

impl<W: Word> FromValue<'_> for W {
    const HOLDS: Holds = Holds::Word(W::WORDS);

    fn from_value(value: &Value) -> Option<Self> {
        value.as_text().and_then(W::from_word)
    }
}

impl<W: Word> AsInput for W {
    const SHAPE: CellShape = CellShape::single(Holds::Word(W::WORDS));

    fn as_input(&self) -> Option<Input<'_>> {
        Some(Input::Text(self.word()))
    }
}

impl<'t> FromValue<'t> for &'t Value {
    const HOLDS: Holds = Holds::Anything;

    fn from_value(value: &'t Value) -> Option<Self> {
        Some(value)
    }
}

impl<'t> FromValue<'t> for &'t str {
    const HOLDS: Holds = Holds::Text;

    fn from_value(value: &'t Value) -> Option<Self> {
        value.as_text()
    }
}

impl AsInput for &str {
    const SHAPE: CellShape = CellShape::single(Holds::Text);

    fn as_input(&self) -> Option<Input<'_>> {
        Some(Input::Text(self))
    }
}

/// Both directions for types that a table value holds directly.
macro_rules! plain {
    ($($type:ty: $holds:expr, $variant:ident;)*) => {$(
        impl FromValue<'_> for $type {
            const HOLDS: Holds = $holds;

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::$variant(value) => Some(*value),
                    _ => None,
                }
            }
        }

        impl AsInput for $type {
            const SHAPE: CellShape = CellShape::single($holds);

            fn as_input(&self) -> Option<Input<'_>> {
                Some(Input::$variant(*self))
            }
        }
    )*};
}

plain! {
    bool: Holds::Bool, Bool;
    i64: Holds::Int, Int;
    Micrometres: Holds::Length, Length;
    ItGrade: Holds::Grade, Grade;
    Roughness: Holds::Roughness, Roughness;
}

/// Both directions for decimals: the type says the unit.
macro_rules! decimals {
    ($($type:ty: $unit:ident, $read:expr, $write:expr;)*) => {$(
        impl FromValue<'_> for $type {
            const HOLDS: Holds = Holds::Number(Unit::$unit);

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::Number(number, Unit::$unit) => Some($read(*number)),
                    _ => None,
                }
            }
        }

        impl AsInput for $type {
            const SHAPE: CellShape = CellShape::single(Holds::Number(Unit::$unit));

            fn as_input(&self) -> Option<Input<'_>> {
                Some(Input::Number($write(*self), Unit::$unit))
            }
        }
    )*};
    // Results of formulas are floating-point; a question rounds them to the millionth, as tables have it.
    (floating $($type:ident: $unit:ident;)*) => {
        decimals! { $($type: $unit, |number: Decimal| $type(number.to_f64()), |value: $type| Decimal::from_f64_rounded(value.0);)* }
    };
}

decimals! {
    Decimal: None, |number| number, |number| number;
    f64: None, |number: Decimal| number.to_f64(), Decimal::from_f64_rounded;
    Brinell: Brinell, Brinell, |value: Brinell| value.0;
    Megapascals: Megapascal, Megapascals, |value: Megapascals| value.0;
}

decimals! {
    floating
    Newtons: Newton;
    NewtonMetres: NewtonMetre;
    Kilowatts: Kilowatt;
    MetresPerMinute: MetrePerMinute;
    MillimetresPerRev: MillimetrePerRev;
    MillimetresPerTooth: MillimetrePerTooth;
    MillimetresPerMinute: MillimetrePerMinute;
    RevsPerMinute: RevPerMinute;
    Minutes: Minute;
    Seconds: Second;
    Degrees: Degree;
    Kilograms: Kilogram;
    Percent: Percent;
    Microns: Micrometre;
    MillimetresPerSecondSquared: MillimetrePerSecondSquared;
}
