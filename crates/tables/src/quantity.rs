//! The figures a plan can state: their keys, their units and their names.

use serde::Serialize;
use technolog_knowledge::contract::Word;

/// Makes the list of quantities: key of the plan file, symbol, unit in Ukrainian and English, name in both.
macro_rules! quantities {
    ($($name:ident: $key:literal, $symbol:literal, $unit:expr, $uk:literal, $en:literal;)*) => {
        /// A figure of a plan.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Quantity { $(#[doc = $en] $name),* }

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

            /// Its unit, in Ukrainian and in English; empty for plain numbers.
            pub const fn unit(self) -> (&'static str, &'static str) {
                match self { $(Self::$name => $unit),* }
            }

            /// Its name, in Ukrainian and in English.
            pub const fn name(self) -> (&'static str, &'static str) {
                match self { $(Self::$name => ($uk, $en)),* }
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

const MM: (&str, &str) = ("мм", "mm");
const RPM: (&str, &str) = ("об/хв", "1/min");
const PER_REV: (&str, &str) = ("мм/об", "mm/rev");
const V: (&str, &str) = ("м/хв", "m/min");
const N: (&str, &str) = ("Н", "N");
const KW: (&str, &str) = ("кВт", "kW");
const NM: (&str, &str) = ("Н·м", "N·m");
const MIN: (&str, &str) = ("хв", "min");
const DEG: (&str, &str) = ("°", "°");
const ONE: (&str, &str) = ("", "");

quantities! {
    Count: "count", "z", ONE, "кількість отворів", "number of holes";
    Diameter: "diameter", "D", MM, "діаметр", "diameter";
    Also: "also", "D", MM, "діаметр, який відкриває той самий хід", "diameter that the same stroke opens";
    From: "from", "D0", MM, "діаметр до переходу", "diameter before";
    Depth: "depth", "l", MM, "глибина", "depth";
    Passes: "passes", "i", ONE, "кількість проходів", "passes";
    DepthOfCut: "depth_of_cut", "t", MM, "глибина різання", "depth of cut";
    CardFeed: "card.feed", "Sт", PER_REV, "таблична подача", "feed of the card";
    CardSpeed: "card.speed", "Vт", V, "таблична швидкість", "speed of the card";
    CardForce: "card.force", "Pт", N, "таблична сила", "force of the card";
    CardPower: "card.power", "Nт", KW, "таблична потужність", "power of the card";
    FactorFeed: "factors.feed", "Ks", ONE, "коефіцієнт подачі", "factor of the feed";
    FactorSpeed: "factors.speed", "Kv", ONE, "коефіцієнт швидкості", "factor of the speed";
    FactorForce: "factors.force", "Kp", ONE, "коефіцієнт сили", "factor of the force";
    FactorPower: "factors.power", "KN", ONE, "коефіцієнт потужності", "factor of the power";
    Feed: "feed", "S", PER_REV, "подача", "feed";
    FeedTaken: "feed_taken", "S", PER_REV, "прийнята подача", "feed taken";
    Speed: "speed", "V", V, "швидкість різання", "cutting speed";
    RpmComputed: "rpm_computed", "n", RPM, "розрахункова частота обертання", "computed spindle speed";
    Rpm: "rpm", "nпр", RPM, "прийнята частота обертання", "spindle speed taken";
    SpeedTaken: "speed_taken", "Vд", V, "дійсна швидкість", "speed at the spindle speed taken";
    MinuteFeed: "minute_feed", "Sхв", ("мм/хв", "mm/min"), "хвилинна подача", "feed per minute";
    Force: "force", "P", N, "осьова сила", "axial force";
    Power: "power", "N", KW, "потужність різання", "cutting power";
    Torque: "torque", "M", NM, "крутний момент", "torque";
    Travel: "travel", "L", MM, "робочий хід", "working travel";
    Time: "time", "Tм", MIN, "машинний час одного отвору", "machine time of one hole";
    ToolLife: "tool_life", "T", MIN, "стійкість", "tool life";
    Length: "length", "L", MM, "довжина інструмента", "length of the tool";
    FluteLength: "flute_length", "l0", MM, "довжина робочої частини", "flute length";
    Projection: "projection", "l", MM, "довжина без конуса хвостовика", "length outside the taper";
    PointAngle: "point_angle", "2φ", DEG, "кут при вершині", "point angle";
    ShankDiameter: "shank_diameter", "d", MM, "діаметр хвостовика", "shank diameter";
    Morse: "morse", "КМ", ONE, "номер конуса Морзе", "Morse taper";
    HolderMorse: "holder.morse", "КМ", ONE, "конус Морзе оправки", "Morse taper of the holder";
    ClampMin: "holder.clamp_min", "d", MM, "найменший затискний діаметр", "smallest diameter clamped";
    ClampMax: "holder.clamp_max", "d", MM, "найбільший затискний діаметр", "largest diameter clamped";
    HolderLength: "holder.length", "lопр", MM, "довжина допоміжного інструмента", "length of the holder";
    Overhang: "overhang", "lв", MM, "виліт інструмента", "overhang";
    HolderUsed: "holder_used", "lопр", MM, "довжина допоміжного інструмента у комплекті", "holder length counted with";
    Assembly: "assembly", "Lк", MM, "довжина комплекту", "length of the assembly";
    LongestAssembly: "reference_length", "Lет", MM, "довжина еталонного комплекту", "length of the reference tool";
    Corrector: "corrector", "H", ONE, "номер коректора", "corrector";
    Correction: "correction", "K", MM, "корекція на довжину", "length correction";
    BookCorrection: "book_correction", "K", MM, "корекція за посібником", "correction as the book writes it";
    Safety: "safety", "k", ONE, "коефіцієнт запасу", "safety factor";
    Friction: "friction", "f", ONE, "коефіцієнт тертя", "coefficient of friction";
    Distance: "distance", "d", MM, "плече", "distance to the clamp";
    ClampForce: "clamp_force", "W", N, "зусилля закріплення", "clamping force";
    Clamps: "clamps", "zп", ONE, "кількість притискачів", "number of clamps";
    ForcePerClamp: "force_per_clamp", "Q", N, "зусилля на один притискач", "force per clamp";
    MachineTime: "machine", "ΣTм", MIN, "машинний час", "machine time";
    RapidTime: "rapid", "Tх", MIN, "час холостих ходів", "time of rapids";
    ChangeTime: "tool_change", "Tзм", MIN, "час замін інструмента", "time of tool changes";
    TotalTime: "total", "T", MIN, "загальний час", "total time";
    Pi: "pi", "π", ONE, "число π", "π";
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
