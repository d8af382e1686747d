//! The turned part and its blank: surfaces, elements, operations before and after the lathe, allowances.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_knowledge::units::{Degrees, ItGrade, Megapascals, Micrometres, Microns, Roughness};
use technolog_knowledge::vocabulary::Severity as Judged;
pub use technolog_knowledge::vocabulary::{Place, StockKind};
use technolog_knowledge::{rows, vocabulary};

use crate::cutting::Surface;

vocabulary! {
    /// How a thread in a hole is cut.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum InnerThreadWay {
        /// With a tap.
        Tapped = "tapped",
        /// Pass by pass with a bar.
        Turned = "turned",
    }

    /// How a hole on the axis is made.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum AxialWay {
        /// With a boring bar.
        Bored = "bored",
        /// To size with a drill.
        Drilled = "drilled",
        /// With one reamer.
        Reamed = "reamed",
        /// With a rough and a finish reamer.
        ReamedTwice = "reamed-twice",
    }
}

vocabulary! {
    /// The side of a contour where the metal is.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Side {
        /// Towards the axis: the contour is turned from outside.
        Outer = "outer",
        /// Away from the axis: the contour is bored.
        Inner = "inner",
    }

    /// The kind of a surface, as the drawing names it (lecture, fig. 12.1). Whether it is a main or an additional
    /// element of the contour depends on the tool and is not part of the kind.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum SurfaceKind {
        /// Perpendicular to the axis.
        Face = "face",
        /// Parallel to the axis.
        Cylinder = "cylinder",
        /// Inclined to the axis.
        Cone = "cone",
        /// A cone that breaks an edge.
        Chamfer = "chamfer",
        /// A convex arc: a ball, a rounded edge.
        Ball = "ball",
        /// A concave arc: a fillet, a radius face.
        Fillet = "fillet",
        /// A thread, turned first as a cylinder or cone.
        Thread = "thread",
        /// A relief for the grinding wheel.
        GrindingRelief = "grinding-relief",
        /// A relief at the end of a thread.
        ThreadRelief = "thread-relief",
        /// A groove with perpendicular walls.
        RectangularGroove = "rectangular-groove",
        /// A groove with inclined walls.
        TrapezoidGroove = "trapezoid-groove",
        /// A groove in a face.
        FaceGroove = "face-groove",
        /// A groove for a belt.
        PulleyGroove = "pulley-groove",
    }

    /// The reason for the class of an element.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum ElementReason {
        /// Both edges of the tool clear it.
        Reach = "reach",
        /// By its kind, whatever its angles.
        Kind = "kind",
        /// It rises more steeply than φ.
        Rise = "rise",
        /// It falls more steeply than φ1.
        Fall = "fall",
        /// It leads back towards the free end, or lies under an element that does.
        Back = "back",
        /// It is in the shadow of a falling element before it.
        Shadow = "shadow",
        /// It lies before a rise steeper than φ.
        Corner = "corner",
        /// It lies in a valley whose floor is not reached.
        Valley = "valley",
        /// It is behind a falling element that never rises again.
        Beyond = "beyond",
    }

    /// How a part is supported against bending.
    pub enum PartSupport {
        /// In the chuck alone.
        Chuck = "chuck",
        /// Between centres.
        Centres = "centres",
        /// In the chuck and at a centre.
        ChuckAndCentre = "chuck-and-centre",
    }

    /// What a part needs if it deflects too far.
    pub enum SupportAsked {
        /// Another set-up.
        SecondSetUp = "second-set-up",
        /// A centre at its free end.
        Tailstock = "tailstock",
        /// A rest between its ends.
        SteadyRest = "steady-rest",
    }

    /// The class of a contour element for a tool.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Element {
        /// The tool makes it completely.
        Main = "main",
        /// It needs another tool.
        Additional = "additional",
        /// It falls behind the largest radius and never rises again: it belongs to the other set-up.
        OtherSide = "other-side",
    }

    /// The shape of a blank.
    pub enum BlankShape {
        /// As rolled.
        Bar = "bar",
        /// Near the shape of the part.
        NearPart = "near-part",
    }

    /// The number of parts in a blank.
    pub enum PartsOfBlank {
        /// For one.
        One = "one",
        /// For several, cut off one after the other.
        Several = "several",
    }

    /// The clamping of the blank.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Holding {
        /// In the chuck, the free end without a centre.
        #[default]
        Chuck = "chuck",
        /// Between centres.
        Centres = "centres",
        /// In the chuck, the free end of the first set-up at the tailstock centre.
        ChuckAndCentre = "chuck-and-centre",
    }

    /// The jaws that hold the part.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum JawKind {
        /// Three jaws; soft ones on a finished surface.
        #[default]
        Three = "three",
        /// Soft jaws that close nearly all around, for thin walls.
        FullGrip = "full-grip",
    }

    /// Whether and when the blank is heat-treated.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum HeatTreatment {
        /// Not at all.
        #[default]
        None = "none",
        /// Before this lathe.
        Before = "before",
        /// After it.
        After = "after",
    }

    /// The kind of a surface for a later operation.
    pub enum FinishedSurface {
        /// Turned from outside.
        Outer = "outer",
        /// Bored.
        Inner = "inner",
        /// Faced.
        Face = "face",
        /// A groove or a thread.
        Additional = "additional",
    }

    /// The operation that finishes a surface after the lathe.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum LaterOperation {
        /// None: the lathe finishes it.
        None = "none",
        /// Cylindrical grinding.
        OuterGrinding = "outer-grinding",
        /// Internal grinding.
        InnerGrinding = "inner-grinding",
        /// Face grinding.
        FaceGrinding = "face-grinding",
        /// An operation that no rule names.
        Unknown = "unknown",
    }

    /// A pass, by the surface that it leaves.
    pub enum Pass {
        /// Roughing.
        Rough = "rough-turning",
        /// Finishing.
        Finish = "finish-turning",
    }
}

impl SurfaceKind {
    /// Additional by its kind, at any angle: threads and grooves have tools of their own.
    pub const fn is_additional(self) -> bool {
        matches!(
            self,
            Self::Thread
                | Self::GrindingRelief
                | Self::ThreadRelief
                | Self::RectangularGroove
                | Self::TrapezoidGroove
                | Self::FaceGroove
                | Self::PulleyGroove
        )
    }
}

impl BlankShape {
    /// The shape of a kind of blank.
    pub const fn of(kind: StockKind) -> Self {
        match kind {
            StockKind::Bar | StockKind::Tube => Self::Bar,
            StockKind::Forging | StockKind::Casting => Self::NearPart,
        }
    }
}

impl From<Place> for FinishedSurface {
    fn from(place: Place) -> Self {
        match place {
            Place::Outer => Self::Outer,
            Place::Inner => Self::Inner,
            Place::Face => Self::Face,
        }
    }
}

rows! {
    /// The drill before boring of a solid blank; no stock and no step where the bore is too narrow for one.
    pub struct BoreDrill of One("bore-drill") asked by BoreDrillFor {
        diameter: Micrometres,
    } {
        drilled: bool,
        least_stock: Option<Micrometres>,
        stock_for_bar: Option<Micrometres>,
        step: Option<Micrometres>,
        largest: Option<Micrometres>,
        largest_for_bar: Option<Micrometres>,
    }

    /// Whether a thread in a hole is tapped or turned.
    pub struct InnerThread of One("inner-thread") asked by InnerThreadFor {
        diameter: Micrometres,
        tap: bool,
        bar: bool,
    } {
        cut: InnerThreadWay,
    }

    /// Whether a hole on the axis is bored, or how tools on the axis make it to size.
    pub struct AxialHole of One("axial-hole") asked by AxialHoleFor {
        diameter: Micrometres,
        tapped: bool,
        it: Option<ItGrade>,
        roughness: Option<Roughness>,
    } {
        made: AxialWay,
        core_drilled: bool,
    }

    /// Allowances for finish turning after rough turning.
    pub struct FinishTurningAllowance of One("finish-turning-allowance") asked by FinishTurningAllowanceFor {
        place_on: Place,
        diameter: Micrometres,
        length: Micrometres,
    } {
        allowance: Micrometres,
    }

    /// Allowances for grinding after finish turning.
    pub struct GrindingAllowance of One("grinding-allowance") asked by GrindingAllowanceFor {
        place_on: Place,
        diameter: Micrometres,
        length: Micrometres,
    } {
        allowance: Micrometres,
    }

    /// Roughness and damaged layer after a pass.
    pub struct SurfaceAfterPass of One("surface-after-pass") asked by SurfaceAfterPassFor {
        pass: Pass,
    } {
        roughness_height: Microns,
        damaged_layer: Microns,
    }

    /// The blank of a turned part: the number of parts, and the tolerance of its length.
    pub struct TurningBlank of One("turning-blank") asked by TurningBlankFor {
        stock: StockKind,
        diameter: Micrometres,
    } {
        parts: PartsOfBlank,
        length_deviation: Micrometres,
    }

    /// Preparing a blank for an NC lathe: a sentence with the code `blank-ACTION`.
    pub struct TurningBlankPreparation of One("turning-blank-preparation") asked by TurningBlankPreparationFor {
        stock: StockKind,
        holding: Holding,
        heat_treatment: HeatTreatment,
    } {
        action: &'t str,
        contradicts: bool,
    }

    /// Main or additional element of a contour, and by what tool.
    pub struct TurningElement of One("turning-element") asked by TurningElementFor {
        kind: SurfaceKind,
        ground: ElementReason,
        valley_fall: Degrees,
        floor_reached: bool,
    } {
        element: Element,
        tool: &'t str,
    }

    /// Surfaces that are finished on another machine.
    pub struct TurningFinishElsewhere of One("turning-finish-elsewhere") asked by TurningFinishElsewhereFor<'t> {
        surface: FinishedSurface,
        material_group: &'t str,
        grade_held: bool,
        roughness_held: bool,
    } {
        operation: LaterOperation,
    }

    /// Whether a surface of the blank can be what the drawing asks of it.
    pub struct TurningBlankSurface of One("turning-blank-surface") asked by TurningBlankSurfaceFor {
        stock: StockKind,
        it: Option<ItGrade>,
        roughness: Option<Roughness>,
    } {
        severity: Judged,
    }

    /// Least length of a cylinder for the jaws of a chuck.
    pub struct TurningHold of One("turning-hold") asked by TurningHoldFor {
        diameter: Micrometres,
    } {
        least_length: Micrometres,
        shortest: Micrometres,
        least_grip: Micrometres,
    }

    /// Modulus of elasticity of the part.
    pub struct ElasticModulus of One("elastic-modulus") {
        material_group: &'t str,
        modulus: Megapascals,
    }

    /// What a slender part requires.
    pub struct TurningSupport of One("turning-support") asked by TurningSupportFor {
        support: PartSupport,
        slenderness: f64,
    } {
        ask: SupportAsked,
    }

    /// Surface of a turned blank, for the speed factor: a word of the table `skin-factor`.
    pub struct TurningSkin of One("turning-skin") asked by TurningSkinFor<'t> {
        stock: StockKind,
        group: &'t str,
    } {
        surface: Surface,
    }
}
