//! Row types: cutting.

use technolog_knowledge::contract::{Named, Use};
use technolog_knowledge::units::{
    Brinell, Kilowatts, Megapascals, MetresPerMinute, Micrometres, MillimetresPerRev, MillimetresPerTooth, Minutes,
    Newtons, Roughness,
};
pub use technolog_knowledge::vocabulary::Surface;
use technolog_knowledge::vocabulary::{Operation, ToolMaterial};
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// The operation of the coefficients of speed, load and tool life.
    pub enum Coefficients {
        /// Drilling in solid metal.
        Drill = "drill",
        /// Drilling out.
        DrillOut = "drill-out",
        /// Core drilling.
        CoreDrill = "core-drill",
        /// Reaming.
        Ream = "ream",
        /// Milling; only `tool-life-beyond` has it.
        Mill = "mill",
    }

    /// The kind of cutting, where the material's factor depends on it.
    pub enum Process {
        /// Drilling, core drilling, reaming.
        Drilling = "drilling",
        /// Turning and boring.
        Turning = "turning",
        /// Milling.
        Milling = "milling",
    }

    /// The process on a lathe, where the coefficients depend on it.
    pub enum LatheProcess {
        /// Turning.
        Turning = "turning",
        /// Grooving and parting.
        Grooving = "grooving",
    }

    /// A component of the cutting force.
    pub enum Component {
        /// Pz, along the cutting speed.
        Main = "pz",
        /// Py, which pushes the tool out of the cut, perpendicular to the feed.
        Radial = "py",
        /// Px, against the feed.
        Axial = "px",
    }

    /// The reference material for a material factor.
    pub enum Reference {
        /// A strength of 750 MPa: of steel.
        Strength750 = "strength-750",
        /// A hardness of HB 190: of grey iron.
        Hardness190 = "hardness-190",
        /// A hardness of HB 150: of malleable iron.
        Hardness150 = "hardness-150",
        /// Nothing: alloys have a factor by their class.
        None = "none",
    }

    /// The kind of a mill.
    pub enum Mill {
        /// A solid end mill.
        End = "end",
        /// An end mill with brazed inserts.
        EndBrazed = "end-brazed",
        /// An end mill with a carbide crown.
        EndCrown = "end-crown",
        /// A mill for key slots.
        Slot = "slot",
        /// A plain mill.
        Plain = "plain",
        /// A face mill.
        Face = "face",
    }

    /// Constants of boring.
    pub enum BoringConstant {
        /// The tool life of a single-point tool.
        ToolLife = "tool-life",
        /// The factor on the turning speed inside a bore.
        InternalFactor = "internal-factor",
    }

    /// Quantities of the cards given as a ratio to the formulas.
    pub enum CardRatio {
        /// The speed.
        Speed = "speed",
        /// The thrust of drilling.
        Thrust = "thrust",
        /// The power of drilling.
        Power = "power",
    }

    /// The corrections of the card speed in the worked example.
    pub enum CardFactor {
        /// The material: feed, force and power are corrected for it too.
        Material = "material",
        /// How the point is ground.
        PointGrinding = "point-grinding",
        /// Coolant.
        Coolant = "coolant",
        /// The required tool life.
        ToolLife = "tool-life",
        /// The coating.
        Coating = "coating",
        /// The tool material.
        ToolMaterial = "tool-material",
        /// How deep the hole is.
        HoleDepth = "hole-depth",
        /// The surface of the blank.
        SurfaceState = "surface-state",
    }

    /// The condition for a reduced feed of a drill.
    pub enum FeedCondition {
        /// Before accurate finishing or tapping.
        BeforeFinishing = "before-accurate-finishing-or-tapping",
    }

    /// The multiple of the tabulated feed.
    pub enum FeedMultiple {
        /// Once.
        Single = "single",
        /// As the handbook has it for drilling out.
        Handbook = "handbook",
        /// As the worked example has it for drilling out.
        WorkedExample = "worked-example",
    }

    /// The step of milling for which a share of the mill's diameter is given.
    pub enum MillingStep {
        /// The depth of one pass.
        Radial = "radial",
        /// The depth of one level.
        Axial = "axial",
        /// The depth of one level where the whole mill stands in the metal.
        Slot = "slot",
    }

    /// The condition for a correction of a reamer's feed.
    pub enum ReamingCondition {
        /// Nothing.
        AsTabulated = "as-tabulated",
        /// The last pass to a grade of 9 to 11.
        FinalPass = "final-pass-9-11",
        /// The finish pass to grade 7 and finer with Ra 0.8 and finer.
        FinishGrade7 = "finish-grade-7",
        /// Polishing follows.
        BeforePolishing = "before-polishing",
        /// A reamer of carbide.
        Carbide = "carbide",
    }
}

rows! {
    /// Boring feed by stage.
    pub struct BoringFeed of One("boring-feed") asked by BoringFeedFor {
        operation: Operation,
    } {
        feed: MillimetresPerRev,
    }

    /// Finish boring feed by roughness.
    pub struct BoringFinishFeed of One("boring-finish-feed") asked by BoringFinishFeedFor<'t> {
        roughness: Roughness,
        nose_radius: &'t str,
    } {
        feed: MillimetresPerRev,
    }

    /// Main force formula coefficients: boring.
    pub struct BoringForce of One("boring-force") asked by BoringForceFor<'t> {
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cp: f64,
        x: f64,
        y: f64,
        n: f64,
    }

    /// Constants of boring.
    pub struct BoringParameters of One("boring-parameters") complete name {
        name: Named<'t, BoringConstant>,
        time: Option<Minutes>,
        factor: Option<f64>,
        use_ as "use": Use,
    } shown { stock_min, stock_max }

    /// Speed formula coefficients: boring.
    pub struct BoringSpeed of One("boring-speed") asked by BoringSpeedFor<'t> {
        material_group: &'t str,
        feed: MillimetresPerRev,
    } {
        cv: f64,
        x: f64,
        y: f64,
        m: f64,
        tool_grade: &'t str,
    }

    /// Ratios of the cards to the formulas.
    pub struct CardCalibration of One("card-calibration") complete name {
        name: Named<'t, CardRatio>,
        factor: f64,
        use_ as "use": Use,
    }

    /// Speed corrections of the worked example.
    pub struct CardCorrections of One("card-corrections") complete name {
        name: CardFactor,
        material_group: &'t str,
        grade: &'t str,
        factor: f64,
    } shown { symbol }

    /// Card points of the worked example.
    pub struct CardPoints of One("card-points") {
        operation: Operation,
        diameter: Micrometres,
        feed: MillimetresPerRev,
        speed: MetresPerMinute,
        thrust: Newtons,
        power: Kilowatts,
    } shown { drill_from, depth_of_cut }

    /// Feed of centring.
    pub struct CentringFeed of One("centring-feed") asked by CentringFeedFor<'t> {
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed: MillimetresPerRev,
    }

    /// Core-drilling feed.
    pub struct CoreDrillingFeed of One("core-drilling-feed") asked by CoreDrillingFeedFor<'t> {
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
    } {
        feed_max: MillimetresPerRev,
    } shown { feed_min }

    /// Feed of counterboring, countersinking and chamfering.
    pub struct CounterboringFeed of One("counterboring-feed") asked by CounterboringFeedFor<'t> {
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
    } {
        feed: MillimetresPerRev,
    }

    /// Speed formula coefficients: drilling, drilling out, core drilling, reaming.
    pub struct CuttingSpeed of One("cutting-speed") asked by CuttingSpeedFor<'t> {
        operation: Coefficients,
        material_group: &'t str,
        tool_material: ToolMaterial,
        feed: MillimetresPerRev,
    } {
        cv: f64,
        q: f64,
        x: f64,
        y: f64,
        m: f64,
        coolant: Option<bool>,
    }

    /// Hole depth factor Kls on feed.
    pub struct DepthFeedFactor of One("depth-feed-factor") asked by DepthFeedFactorFor {
        depth_ratio: f64,
    } {
        factor: f64,
    }

    /// Hole depth factor Klv on speed.
    pub struct DepthSpeedFactor of One("depth-speed-factor") asked by DepthSpeedFactorFor {
        operation: Coefficients,
        depth_ratio: f64,
    } {
        factor: f64,
    }

    /// Torsional strength of thin drills.
    pub struct DrillStrength of One("drill-strength") {
        tool_material: ToolMaterial,
        modulus_factor: f64,
        shear_stress: Megapascals,
        below_diameter: Micrometres,
    }

    /// Drilling feed of HSS drills.
    pub struct DrillingFeed of One("drilling-feed") asked by DrillingFeedFor<'t> {
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
    } {
        feed_max: MillimetresPerRev,
    } shown { feed_min }

    /// Feed per tooth of HSS end mills.
    pub struct EndMillFeed of One("end-mill-feed") asked by EndMillFeedFor<'t> {
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed_per_tooth: MillimetresPerTooth,
    }

    /// Feed factors Kos, Kjs, Kis.
    pub struct FeedFactor of One("feed-factor") complete condition {
        condition: Named<'t, FeedCondition>,
        factor: f64,
        use_ as "use": Use,
    } shown { name }

    /// Drill-out feed over drilling feed.
    pub struct FeedStep of One("feed-step") complete name {
        name: FeedMultiple,
        factor: f64,
    }

    /// Material factor Kmp of copper and aluminium alloys on force.
    pub struct ForceAlloyFactor of One("force-alloy-factor") asked by ForceAlloyFactorFor<'t> {
        alloy_class: &'t str,
    } {
        factor: f64,
    }

    /// Exponent n of the material factor on force.
    pub struct ForceMaterialExponent of One("force-material-exponent") asked by ForceMaterialExponentFor<'t> {
        process: Process,
        tool_material: ToolMaterial,
        material_group: &'t str,
        strength: Megapascals,
    } {
        exponent: f64,
        reference: Reference,
    }

    /// Feed of grooving and parting.
    pub struct GroovingFeed of One("grooving-feed") asked by GroovingFeedFor<'t> {
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed_min: MillimetresPerRev,
    } shown { feed_max, width_max }

    /// Speed formula coefficients: grooving and parting.
    pub struct GroovingSpeed of One("grooving-speed") asked by GroovingSpeedFor<'t> {
        material_group: &'t str,
    } {
        cv: f64,
        x: f64,
        y: f64,
        m: f64,
        tool_grade: &'t str,
    }

    /// Deepest pass of an end mill.
    pub struct MillingDepth of One("milling-depth") complete name {
        name: MillingStep,
        share: f64,
    }

    /// Factor on the feed per tooth for the roughness asked.
    pub struct MillingFinishFeed of One("milling-finish-feed") asked by MillingFinishFeedFor {
        roughness: Roughness,
    } {
        factor: f64,
    }

    /// Main force formula coefficients: milling.
    pub struct MillingForce of One("milling-force") asked by MillingForceFor<'t> {
        mill: Mill,
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cp: f64,
        x: f64,
        y: f64,
        u: f64,
        q: f64,
        w: f64,
    }

    /// Speed formula coefficients: milling.
    pub struct MillingSpeed of One("milling-speed") asked by MillingSpeedFor<'t> {
        mill: Mill,
        material_group: &'t str,
        tool_material: ToolMaterial,
        feed_per_tooth: MillimetresPerTooth,
    } {
        cv: f64,
        q: f64,
        x: f64,
        y: f64,
        u: f64,
        p: f64,
        m: f64,
    }

    /// Tool life of mills.
    pub struct MillingToolLife of One("milling-tool-life") asked by MillingToolLifeFor {
        mill: Mill,
        diameter: Micrometres,
    } {
        life: Minutes,
    }

    /// Teeth of reamers.
    pub struct ReamerTeeth of One("reamer-teeth") asked by ReamerTeethFor {
        diameter: Micrometres,
    } {
        teeth: f64,
    }

    /// Factors on the reaming feed.
    pub struct ReamingFeedFactor of One("reaming-feed-factor") asked by ReamingFeedFactorFor {
        condition: ReamingCondition,
    } {
        factor: f64,
        blind_feed_min: MillimetresPerRev,
        blind_feed_max: MillimetresPerRev,
    }

    /// Reaming feed of HSS reamers.
    pub struct ReamingFeed of One("reaming-feed") asked by ReamingFeedFor<'t> {
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
    } {
        feed: MillimetresPerRev,
    }

    /// Skin factor Kpv.
    pub struct SkinFactor of One("skin-factor") asked by SkinFactorFor {
        surface: Surface,
    } {
        factor: f64,
    } shown { factor_max }

    /// Material factor Kmv of copper and aluminium alloys on speed.
    pub struct SpeedAlloyFactor of One("speed-alloy-factor") asked by SpeedAlloyFactorFor<'t> {
        alloy_class: &'t str,
    } {
        factor: f64,
    }

    /// Exponent nv of the material factor on speed.
    pub struct SpeedMaterialExponent of One("speed-material-exponent") asked by SpeedMaterialExponentFor<'t> {
        process: Process,
        tool_material: ToolMaterial,
        material_group: &'t str,
        strength: Megapascals,
    } {
        exponent: f64,
        reference: Reference,
    }

    /// Steel class factor Kg on speed.
    pub struct SpeedSteelClass of One("speed-steel-class") asked by SpeedSteelClassFor<'t> {
        steel_class: &'t str,
        tool_material: ToolMaterial,
    } {
        factor: f64,
        milling_exponent: Option<f64>,
    }

    /// Speed formula coefficients: machine taps.
    pub struct TappingSpeed of One("tapping-speed") asked by TappingSpeedFor<'t> {
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cv: f64,
        q: f64,
        y: f64,
        m: f64,
        life: Minutes,
    }

    /// Torque formula coefficients: taps.
    pub struct TappingTorque of One("tapping-torque") asked by TappingTorqueFor<'t> {
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cm: f64,
        q: f64,
        y: f64,
    }

    /// Tool life of drills, core drills and reamers.
    pub struct ToolLife of One("tool-life") asked by ToolLifeFor<'t> {
        operation: Coefficients,
        material_group: &'t str,
        tool_material: ToolMaterial,
        diameter: Micrometres,
    } {
        life: Minutes,
    }

    /// Tool material factor Kiv.
    pub struct ToolMaterialFactor of One("tool-material-factor") asked by ToolMaterialFactorFor<'t> {
        material_group: &'t str,
        grade: &'t str,
    } {
        factor: f64,
    }

    /// Torque and thrust formula coefficients.
    pub struct TorqueAndThrust of One("torque-and-thrust") asked by TorqueAndThrustFor<'t> {
        operation: Coefficients,
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cm: f64,
        qm: f64,
        xm: f64,
        ym: f64,
        cp: f64,
        qp: f64,
        xp: f64,
        yp: f64,
    }

    /// Feed of rough boring on a lathe.
    pub struct TurningBoringFeed of One("turning-boring-feed") asked by TurningBoringFeedFor<'t> {
        material_group: &'t str,
        bar_diameter: Micrometres,
        depth: Micrometres,
    } {
        feed_min: MillimetresPerRev,
    } shown { feed_max }

    /// Force formula coefficients: turning, components Py and Px, and grooving.
    pub struct TurningForce of One("turning-force") asked by TurningForceFor<'t> {
        process: LatheProcess,
        component: Component,
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cp: f64,
        x: f64,
        y: f64,
        n: f64,
        material_exponent: f64,
        reference: Reference,
    }

    /// Components of the cutting force as shares of the main one.
    pub struct TurningForceShare of One("turning-force-share") asked by TurningForceShareFor {
        process: LatheProcess,
        component: Component,
    } {
        share: f64,
    }

    /// Feed of rough turning.
    pub struct TurningRoughFeed of One("turning-rough-feed") asked by TurningRoughFeedFor<'t> {
        material_group: &'t str,
        shank_height: Micrometres,
        diameter: Micrometres,
        depth: Micrometres,
    } {
        feed_min: MillimetresPerRev,
    } shown { feed_max }
}
