//! The language of 2C42-65.

use technolog_knowledge::contract::Named;
use technolog_knowledge::{rows, vocabulary};

use super::{Acts, Letter};

vocabulary! {
    /// The action of the control for an M function.
    pub enum Action {
        Stop = "stop",
        OptionalStop = "optional-stop",
        End = "end",
        Return = "return",
        SpindleClockwise = "spindle-clockwise",
        SpindleCounterclockwise = "spindle-counterclockwise",
        SpindleStop = "spindle-stop",
        ToolChange = "tool-change",
        CoolantOn = "coolant-on",
        CoolantOff = "coolant-off",
    }

    /// The unit of the number after an address.
    pub enum AddressUnit {
        Ones = "1",
        Millimetres = "mm",
        Degrees = "deg",
        MillimetresPerMinute = "mm/min",
        RevsPerMinute = "1/min",
        /// Limits in seconds; the number itself counts tenths.
        Seconds = "s",
    }

    /// The plane of circular interpolation and radius correction.
    pub enum PlaneName {
        Xy = "XY",
        Zx = "ZX",
        Yz = "YZ",
    }

    /// An axis of the machine.
    pub enum AxisName {
        X = "X",
        Y = "Y",
        Z = "Z",
    }

    /// The motion of a cycle to point 2.
    pub enum Inwards {
        /// At feed.
        Feed = "feed",
        /// At feed, in steps.
        FeedInSteps = "feed-in-steps",
    }

    /// The motion of a cycle to point 3.
    pub enum Outwards {
        Rapid = "rapid",
        Feed = "feed",
    }

    /// What the interpreter asks of the record of the control. Its other rows are for people.
    pub enum Characteristic {
        /// Characters of a block.
        BlockLengthMax = "block-length-max",
        /// Memory for programs, kB.
        Memory = "memory",
        /// Programs and subprograms together.
        ProgramsMax = "programs-max",
        /// The deepest nesting of subprogram calls.
        SubprogramDepthMax = "subprogram-depth-max",
        MFunctionsPerBlockMax = "m-functions-per-block-max",
        /// The unit of a dwell, s.
        DwellStep = "dwell-step",
        /// The number of offset registers.
        Correctors = "correctors",
        /// The largest value of an offset register, mm; a zero has the same limit.
        CorrectorValueMax = "corrector-value-max",
        /// Steps of the switch, %.
        FeedOverride = "feed-override",
        /// Steps of the switch, %.
        SpindleOverride = "spindle-override",
        /// What a tape begins with.
        TapeStart = "tape-start",
        /// The machine of its description, as the catalogs name it.
        DescribedOn = "described-on",
    }
}

impl Characteristic {
    /// The unit of its value, as the record writes it.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Memory => "kB",
            Self::DwellStep => "s",
            Self::CorrectorValueMax => "mm",
            Self::FeedOverride | Self::SpindleOverride => "%",
            _ => "1",
        }
    }
}

rows! {
    /// Addresses of 2C42-65 and the limits of their numbers, in the unit of the row.
    pub struct Addresses of One("2c42-65-addresses") {
        address: Letter,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        minimum: Option<f64>,
        maximum: Option<f64>,
        unit: Option<AddressUnit>,
    } shown { format }

    /// Further parameters of the boring cycles of 2C42-65.
    pub struct BoringParameters of One("2c42-65-boring-parameters") {}
        shown { cycle, word, given_uk, given_en, absent_uk, absent_en }

    /// Circular interpolation of 2C42-65.
    pub struct CircularInterpolation of One("2c42-65-circular-interpolation") {}
        shown { part, code, words, format, meaning_uk, meaning_en }

    /// Cycle parameters of 2C42-65.
    pub struct CycleParameters of One("2c42-65-cycle-parameters") {
        word: Letter,
        cycles: Vec<&'t str>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        incremental_uk: Option<&'t str>,
        incremental_en: Option<&'t str>,
    } shown { required }

    /// Fixed cycles of 2C42-65. G80 has no motions.
    pub struct Cycles of One("2c42-65-cycles") {
        code: &'t str,
        required: Option<Vec<Letter>>,
        optional_words: Option<Vec<Letter>>,
        motion_1_2: Option<Inwards>,
        motion_2_3: Option<Outwards>,
    } shown { name_uk, name_en, format, motions_uk, motions_en, on_gf2171 }

    /// Dimension words of 2C42-65.
    pub struct DimensionWords of One("2c42-65-dimension-words") {} shown { group, words, meaning_uk, meaning_en }

    /// Types of G functions of 2C42-65.
    pub struct GFunctionTypes of One("2c42-65-g-function-types") {} shown { "type", modal, meaning_uk, meaning_en }

    /// G functions of 2C42-65.
    pub struct GFunctions of One("2c42-65-g-functions") {
        code: &'t str,
        group: &'t str,
        power_on: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    } shown { modal }

    /// Parameters of cycle G81 of 2C42-65.
    pub struct G81Parameters of One("2c42-65-g81-parameters") {}
        shown { word, required, absolute_uk, absolute_en, incremental_uk, incremental_en }

    /// Speeds on the segments of cycle G81 of 2C42-65.
    pub struct G81Speeds of One("2c42-65-g81-speeds") {} shown { segment, given_uk, given_en, absent_uk, absent_en }

    /// Further parameters of cycle G83 of 2C42-65.
    pub struct G83Parameters of One("2c42-65-g83-parameters") {}
        shown { word, required, absolute_uk, absolute_en, incremental_uk, incremental_en }

    /// Further parameters of cycle G84 of 2C42-65.
    pub struct G84Parameters of One("2c42-65-g84-parameters") {}
        shown { word, given_uk, given_en, absent_uk, absent_en }

    /// Further parameters of cycle G86 of 2C42-65.
    pub struct G86Parameters of One("2c42-65-g86-parameters") {}
        shown { word, required, absolute_uk, absolute_en, incremental_uk, incremental_en }

    /// The action of each M function of 2C42-65 in the program check; a meaning where the table of M functions has
    /// none.
    pub struct MActions of One("2c42-65-m-actions") {
        code: &'t str,
        action: Action,
        acts: Acts,
        meaning_uk: Option<&'t str>,
        meaning_en: Option<&'t str>,
    }

    /// M functions of 2C42-65.
    pub struct MFunctions of One("2c42-65-m-functions") {
        code: &'t str,
        exclusive: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    } shown { stops, by_machine }

    /// Choice of the plane in 2C42-65.
    pub struct Planes of One("2c42-65-planes") {
        code: &'t str,
        plane: PlaneName,
        length_axis: AxisName,
        cycle_axis: AxisName,
        pitch_word: Letter,
    } shown { helix_axis, helix_words }

    /// A characteristic of 2C42-65.
    pub struct Record of One("control-2c42-65") complete name {
        name: Named<'t, Characteristic>,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
        text: Option<&'t str>,
    }

    /// Tool offset of 2C42-65: G45...G48 have a factor, G17...G19 the words that they change.
    pub struct ToolOffset of One("2c42-65-tool-offset") {
        code: &'t str,
        factor: Option<f64>,
        words: Option<Vec<Letter>>,
    } shown { meaning_uk, meaning_en }
}
