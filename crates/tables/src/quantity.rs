//! The figures that a plan can state: keys, units and symbols. Their names are in the message catalogue.

use serde::Serialize;
use technolog_knowledge::contract::Word;
use technolog_knowledge::units::Unit;

/// Makes the list of quantities: key in plan files, symbol, unit, description.
macro_rules! quantities {
    ($($name:ident: $key:literal, $symbol:literal, $unit:ident, $doc:literal;)*) => {
        /// A figure of a plan.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Quantity { $(#[doc = $doc] $name),* }

        impl Quantity {
            /// Every quantity.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Its key in plan files and in tables.
            pub const fn key(self) -> &'static str {
                match self { $(Self::$name => $key),* }
            }

            /// Its symbol in formulas.
            pub const fn symbol(self) -> &'static str {
                match self { $(Self::$name => $symbol),* }
            }

            /// Its unit.
            pub const fn unit(self) -> Unit {
                match self { $(Self::$name => Unit::$unit),* }
            }
        }

        impl Word for Quantity {
            const WORDS: &'static [&'static str] = &[$($key),*];

            fn word(self) -> &'static str {
                self.key()
            }

            fn from_word(key: &str) -> Option<Self> {
                match key { $($key => Some(Self::$name),)* _ => None }
            }
        }
    };
}

quantities! {
    Count: "count", "z", None, "number of holes";
    Diameter: "diameter", "D", Millimetre, "diameter";
    Also: "also", "D", Millimetre, "diameter that the same stroke opens";
    From: "from", "D0", Millimetre, "diameter before";
    Depth: "depth", "l", Millimetre, "depth";
    Passes: "passes", "i", None, "passes";
    DepthOfCut: "depth_of_cut", "t", Millimetre, "depth of cut";
    CardFeed: "card.feed", "Sт", MillimetrePerRev, "feed of the card";
    CardSpeed: "card.speed", "Vт", MetrePerMinute, "speed of the card";
    CardForce: "card.force", "Pт", Newton, "force of the card";
    CardPower: "card.power", "Nт", Kilowatt, "power of the card";
    FactorFeed: "factors.feed", "Ks", None, "factor of the feed";
    FactorSpeed: "factors.speed", "Kv", None, "factor of the speed";
    FactorForce: "factors.force", "Kp", None, "factor of the force";
    FactorPower: "factors.power", "KN", None, "factor of the power";
    Feed: "feed", "S", MillimetrePerRev, "feed";
    FeedTaken: "feed_taken", "S", MillimetrePerRev, "feed taken";
    Speed: "speed", "V", MetrePerMinute, "cutting speed";
    RpmComputed: "rpm_computed", "n", RevPerMinute, "computed spindle speed";
    Rpm: "rpm", "nпр", RevPerMinute, "spindle speed taken";
    SpeedTaken: "speed_taken", "Vд", MetrePerMinute, "speed at the spindle speed taken";
    MinuteFeed: "minute_feed", "Sхв", MillimetrePerMinute, "feed per minute";
    Force: "force", "P", Newton, "axial force";
    Power: "power", "N", Kilowatt, "cutting power";
    Torque: "torque", "M", NewtonMetre, "torque";
    Travel: "travel", "L", Millimetre, "working travel";
    Time: "time", "Tм", Minute, "machine time of one hole";
    ToolLife: "tool_life", "T", Minute, "tool life";
    Length: "length", "L", Millimetre, "length of the tool";
    FluteLength: "flute_length", "l0", Millimetre, "flute length";
    Projection: "projection", "l", Millimetre, "length outside the taper";
    PointAngle: "point_angle", "2φ", Degree, "point angle";
    ShankDiameter: "shank_diameter", "d", Millimetre, "shank diameter";
    Morse: "morse", "КМ", None, "Morse taper";
    HolderMorse: "holder.morse", "КМ", None, "Morse taper of the holder";
    ClampMin: "holder.clamp_min", "d", Millimetre, "smallest diameter clamped";
    ClampMax: "holder.clamp_max", "d", Millimetre, "largest diameter clamped";
    HolderLength: "holder.length", "lопр", Millimetre, "length of the holder";
    Overhang: "overhang", "lв", Millimetre, "overhang";
    HolderUsed: "holder_used", "lопр", Millimetre, "holder length counted with";
    Assembly: "assembly", "Lк", Millimetre, "length of the assembly";
    LongestAssembly: "reference_length", "Lет", Millimetre, "length of the reference tool";
    Corrector: "corrector", "H", None, "offset register";
    Correction: "correction", "K", Millimetre, "length offset";
    BookCorrection: "book_correction", "K", Millimetre, "correction as the book writes it";
    Safety: "safety", "k", None, "safety factor";
    Friction: "friction", "f", None, "coefficient of friction";
    SupportFriction: "support_friction", "f2", None, "coefficient of friction on the support";
    SideForce: "side_force", "P", Newton, "side force of the cut";
    Distance: "distance", "d", Millimetre, "distance to the clamp";
    ClampForce: "clamp_force", "W", Newton, "clamping force";
    Clamps: "clamps", "zп", None, "number of clamps";
    ForcePerClamp: "force_per_clamp", "Q", Newton, "force per clamp";
    MachineTime: "machine", "ΣTм", Minute, "machine time";
    RapidTime: "rapid", "Tх", Minute, "time of rapids";
    FeedOutTime: "feed_out", "Tвв", Minute, "time at feed out of the holes";
    DwellTime: "dwell", "Tвт", Minute, "time of dwells";
    HandTime: "hand", "Tр", Minute, "time of the operator's hands";
    ChangeTime: "tool_change", "Tзм", Minute, "time of tool changes";
    TotalTime: "total", "T", Minute, "total time";
    Pi: "pi", "π", None, "π";
}

impl Quantity {
    /// The quantity of that key.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::from_word(key)
    }
}

impl Serialize for Quantity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.key())
    }
}
