//! Row types: cutting.

use technolog_knowledge::rows;
use technolog_knowledge::units::{
    Brinell, Kilowatts, Megapascals, MetresPerMinute, Micrometres, MillimetresPerRev, MillimetresPerTooth, Minutes,
    Newtons, Roughness,
};
use technolog_knowledge::vocabulary::{Operation, ToolMaterial};

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
    pub struct BoringParameters of One("boring-parameters") {
        name: &'t str,
        time: Option<Minutes>,
        factor: Option<f64>,
        stock_min: Option<Micrometres>,
        stock_max: Option<Micrometres>,
    }

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
    pub struct CardCalibration of One("card-calibration") {
        name: &'t str,
        factor: f64,
    }

    /// Speed corrections of the worked example.
    pub struct CardCorrections of One("card-corrections") {
        name: &'t str,
        symbol: &'t str,
        material_group: &'t str,
        factor: f64,
    }

    /// Card points of the worked example.
    pub struct CardPoints of One("card-points") {
        operation: Operation,
        diameter: Micrometres,
        drill_from: Option<Micrometres>,
        depth_of_cut: Micrometres,
        feed: MillimetresPerRev,
        speed: MetresPerMinute,
        thrust: Newtons,
        power: Kilowatts,
    }

    /// Core-drilling feed.
    pub struct CoreDrillingFeed of One("core-drilling-feed") asked by CoreDrillingFeedFor<'t> {
        material_group: &'t str,
        hardness: Brinell,
        diameter: Micrometres,
    } {
        feed_min: MillimetresPerRev,
        feed_max: MillimetresPerRev,
    }

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
        operation: &'t str,
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
    pub struct DepthSpeedFactor of One("depth-speed-factor") asked by DepthSpeedFactorFor<'t> {
        operation: &'t str,
        depth_ratio: f64,
    } {
        factor: f64,
    }

    /// Torsional strength of thin drills.
    pub struct DrillStrength of One("drill-strength") {
        tool_material: &'t str,
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
        feed_min: MillimetresPerRev,
        feed_max: MillimetresPerRev,
    }

    /// Feed per tooth of HSS end mills.
    pub struct EndMillFeed of One("end-mill-feed") asked by EndMillFeedFor<'t> {
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed_per_tooth: MillimetresPerTooth,
    }

    /// Feed factors Kos, Kjs, Kis.
    pub struct FeedFactor of One("feed-factor") {
        name: &'t str,
        condition: &'t str,
        factor: f64,
    }

    /// Drill-out feed over drilling feed.
    pub struct FeedStep of One("feed-step") {
        name: &'t str,
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
        process: &'t str,
        tool_material: ToolMaterial,
        material_group: &'t str,
        strength: Megapascals,
    } {
        exponent: f64,
        reference: &'t str,
    }

    /// Feed of grooving and parting.
    pub struct GroovingFeed of One("grooving-feed") asked by GroovingFeedFor<'t> {
        material_group: &'t str,
        diameter: Micrometres,
    } {
        feed_min: MillimetresPerRev,
        feed_max: MillimetresPerRev,
        width_max: Micrometres,
    }

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
    pub struct MillingDepth of One("milling-depth") {
        name: &'t str,
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
        mill: &'t str,
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
        mill: &'t str,
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
    pub struct MillingToolLife of One("milling-tool-life") asked by MillingToolLifeFor<'t> {
        mill: &'t str,
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
    pub struct ReamingFeedFactor of One("reaming-feed-factor") asked by ReamingFeedFactorFor<'t> {
        condition: &'t str,
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
    pub struct SkinFactor of One("skin-factor") asked by SkinFactorFor<'t> {
        surface: &'t str,
    } {
        factor: f64,
        factor_max: Option<f64>,
    }

    /// Material factor Kmv of copper and aluminium alloys on speed.
    pub struct SpeedAlloyFactor of One("speed-alloy-factor") asked by SpeedAlloyFactorFor<'t> {
        alloy_class: &'t str,
    } {
        factor: f64,
    }

    /// Exponent nv of the material factor on speed.
    pub struct SpeedMaterialExponent of One("speed-material-exponent") asked by SpeedMaterialExponentFor<'t> {
        process: &'t str,
        tool_material: ToolMaterial,
        material_group: &'t str,
        strength: Megapascals,
    } {
        exponent: f64,
        reference: &'t str,
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
        operation: &'t str,
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
        operation: Operation,
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
        feed_max: MillimetresPerRev,
    }

    /// Force formula coefficients: turning, components Py and Px, and grooving.
    pub struct TurningForce of One("turning-force") asked by TurningForceFor<'t> {
        process: &'t str,
        component: &'t str,
        material_group: &'t str,
        tool_material: ToolMaterial,
    } {
        cp: f64,
        x: f64,
        y: f64,
        n: f64,
        material_exponent: f64,
        reference: &'t str,
    }

    /// Feed of rough turning.
    pub struct TurningRoughFeed of One("turning-rough-feed") asked by TurningRoughFeedFor<'t> {
        material_group: &'t str,
        shank_height: Micrometres,
        diameter: Micrometres,
        depth: Micrometres,
    } {
        feed_min: MillimetresPerRev,
        feed_max: MillimetresPerRev,
    }
}
