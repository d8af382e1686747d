//! Row types: controls.

use technolog_knowledge::rows;

rows! {
    /// Addresses of 2C42-65 and the limits of their numbers.
    pub struct Control2cAddresses of One("2c42-65-addresses") {
        address: &'t str,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        format: Option<&'t str>,
        minimum: Option<f64>,
        maximum: Option<f64>,
        unit: Option<&'t str>,
    }

    /// Further parameters of the boring cycles of 2C42-65.
    pub struct Control2cBoringParameters of One("2c42-65-boring-parameters") {
        cycle: &'t str,
        word: &'t str,
        given_uk: &'t str,
        given_en: &'t str,
        absent_uk: &'t str,
        absent_en: &'t str,
    }

    /// Circular interpolation of 2C42-65.
    pub struct Control2cCircularInterpolation of One("2c42-65-circular-interpolation") {
        part: &'t str,
        code: &'t str,
        words: Option<Vec<&'t str>>,
        format: Option<&'t str>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Cycle parameters of 2C42-65.
    pub struct Control2cCycleParameters of One("2c42-65-cycle-parameters") {
        word: &'t str,
        cycles: Vec<&'t str>,
        required: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        incremental_uk: Option<&'t str>,
        incremental_en: Option<&'t str>,
    }

    /// Fixed cycles of 2C42-65.
    pub struct Control2cCycles of One("2c42-65-cycles") {
        code: &'t str,
        name_uk: &'t str,
        name_en: &'t str,
        required: Option<Vec<&'t str>>,
        optional_words: Option<Vec<&'t str>>,
        format: Option<&'t str>,
        motion_1_2: Option<&'t str>,
        motion_2_3: Option<&'t str>,
        motions_uk: &'t str,
        motions_en: &'t str,
        on_gf2171: bool,
    }

    /// Dimension words of 2C42-65.
    pub struct Control2cDimensionWords of One("2c42-65-dimension-words") {
        group: &'t str,
        words: Vec<&'t str>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Types of G functions of 2C42-65.
    pub struct Control2cGFunctionTypes of One("2c42-65-g-function-types") {
        type_ as "type": &'t str,
        modal: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// G functions of 2C42-65.
    pub struct Control2cGFunctions of One("2c42-65-g-functions") {
        code: &'t str,
        group: &'t str,
        modal: bool,
        power_on: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Parameters of cycle G81 of 2C42-65.
    pub struct Control2cG81Parameters of One("2c42-65-g81-parameters") {
        word: &'t str,
        required: bool,
        absolute_uk: &'t str,
        absolute_en: &'t str,
        incremental_uk: &'t str,
        incremental_en: &'t str,
    }

    /// Speeds on the segments of cycle G81 of 2C42-65.
    pub struct Control2cG81Speeds of One("2c42-65-g81-speeds") {
        segment: &'t str,
        given_uk: &'t str,
        given_en: &'t str,
        absent_uk: &'t str,
        absent_en: &'t str,
    }

    /// Further parameters of cycle G83 of 2C42-65.
    pub struct Control2cG83Parameters of One("2c42-65-g83-parameters") {
        word: &'t str,
        required: bool,
        absolute_uk: &'t str,
        absolute_en: &'t str,
        incremental_uk: &'t str,
        incremental_en: &'t str,
    }

    /// Further parameters of cycle G84 of 2C42-65.
    pub struct Control2cG84Parameters of One("2c42-65-g84-parameters") {
        word: &'t str,
        given_uk: &'t str,
        given_en: &'t str,
        absent_uk: &'t str,
        absent_en: &'t str,
    }

    /// Further parameters of cycle G86 of 2C42-65.
    pub struct Control2cG86Parameters of One("2c42-65-g86-parameters") {
        word: &'t str,
        required: bool,
        absolute_uk: &'t str,
        absolute_en: &'t str,
        incremental_uk: &'t str,
        incremental_en: &'t str,
    }

    /// What the check of programs does at the M functions of 2C42-65.
    pub struct Control2cMActions of One("2c42-65-m-actions") {
        code: &'t str,
        action: &'t str,
        acts: &'t str,
        meaning_uk: Option<&'t str>,
        meaning_en: Option<&'t str>,
    }

    /// M functions of 2C42-65.
    pub struct Control2cMFunctions of One("2c42-65-m-functions") {
        code: &'t str,
        stops: bool,
        exclusive: bool,
        by_machine: bool,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Choice of the plane in 2C42-65.
    pub struct Control2cPlanes of One("2c42-65-planes") {
        code: &'t str,
        plane: &'t str,
        length_axis: &'t str,
        cycle_axis: &'t str,
        helix_axis: Vec<&'t str>,
        helix_words: Vec<&'t str>,
        pitch_word: &'t str,
    }

    /// Tool offset G45...G48 of 2C42-65.
    pub struct Control2cToolOffset of One("2c42-65-tool-offset") {
        code: &'t str,
        factor: Option<f64>,
        words: Option<Vec<&'t str>>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Words of Fanuc.
    pub struct FanucWords of One("fanuc-words") {
        word: &'t str,
        cycles: Option<Vec<&'t str>>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        incremental_uk: Option<&'t str>,
        incremental_en: Option<&'t str>,
        unit: Option<&'t str>,
    }

    /// Addresses of LinuxCNC and Fanuc.
    pub struct IsoAddresses of One("iso-addresses") {
        address: &'t str,
        controls: Vec<&'t str>,
        kind: &'t str,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Fixed cycles of LinuxCNC and Fanuc.
    pub struct IsoCycles of One("iso-cycles") {
        code: &'t str,
        controls: Vec<&'t str>,
        required: Vec<&'t str>,
        optional_words: Option<Vec<&'t str>>,
        inwards: &'t str,
        bottom: &'t str,
        outwards: &'t str,
    }

    /// G functions of LinuxCNC and Fanuc.
    pub struct IsoGFunctions of One("iso-g-functions") {
        code: &'t str,
        controls: Vec<&'t str>,
        group: &'t str,
        power_on: Option<Vec<&'t str>>,
        effect: &'t str,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// M functions of LinuxCNC and Fanuc.
    pub struct IsoMFunctions of One("iso-m-functions") {
        code: &'t str,
        controls: Vec<&'t str>,
        action: &'t str,
        group: &'t str,
        acts: &'t str,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Controls of lathes.
    pub struct LatheControls of One("lathe-controls") {
        control: &'t str,
        version: &'t str,
        plain: bool,
        cycles: bool,
        comment: Option<&'t str>,
        known_words: Option<Vec<&'t str>>,
    }

    /// Fields of roughing cycles.
    pub struct LatheCycleFields of One("lathe-cycle-fields") {
        control: &'t str,
        place_in_call: i64,
        field: &'t str,
        holds: &'t str,
        measure: Option<&'t str>,
        unit_of_field: Option<&'t str>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Roughing cycles of lathes.
    pub struct LatheCycles of One("lathe-cycles") {
        control: &'t str,
        direction: &'t str,
        side: &'t str,
        cycle: &'t str,
        machining: Option<i64>,
    }

    /// Words of programs for lathes.
    pub struct LatheWords of One("lathe-words") {
        control: &'t str,
        use_ as "use": &'t str,
        word: &'t str,
        meaning_uk: &'t str,
        meaning_en: &'t str,
    }

    /// Words of LinuxCNC.
    pub struct LinuxcncWords of One("linuxcnc-words") {
        word: &'t str,
        cycles: Option<Vec<&'t str>>,
        meaning_uk: &'t str,
        meaning_en: &'t str,
        incremental_uk: Option<&'t str>,
        incremental_en: Option<&'t str>,
        unit: Option<&'t str>,
    }

    /// Conventions of programs.
    pub struct ProgramConventions of One("program-conventions") {
        name: &'t str,
        value: f64,
        unit: &'t str,
    }

    /// A characteristic of a control.
    pub struct ControlRecord of Each(&["control-2c42-65", "control-fanuc", "control-linuxcnc"]) {
        name: &'t str,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
        text: Option<&'t str>,
    }
}
