//! Words of the rules that code uses.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_knowledge::vocabulary;

vocabulary! {
    /// The state of the entry face.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Entry {
        /// Machined beforehand.
        #[default]
        Machined = "machined",
        /// As cast, forged or rolled.
        Rough = "rough",
    }

    /// The state of the blank at the place of a hole.
    pub enum BlankState {
        Solid = "solid",
        WithHole = "cast-or-pre-machined",
    }

    /// Whether the position of the axis requires boring.
    pub enum BoringAsked {
        Asked = "asked",
        NotAsked = "not-asked",
    }

    /// The width of the centring spot.
    pub enum Spot {
        Chamfer = "chamfer",
        ShareOfDrill = "share-of-drill",
    }

    /// The replacement for an empty cell of A.8 or A.9.
    pub enum CellTaken {
        Own = "own-cell",
        FinerRoughness = "finer-roughness",
        FinerGrade = "finer-grade",
        TighterCentres = "tighter-centres",
        Nothing = "nothing",
    }

    /// The method of opening a large hole.
    pub enum MillInstead {
        Same = "same",
        Mill = "mill",
    }

    /// The replacement where no boring bar enters.
    pub enum BoringInstead {
        Same = "same",
        CoreDrill = "core-drill",
        Nothing = "nothing",
    }

    /// The last work on a hole, or its state in the blank.
    pub enum HoleState {
        Solid = "solid",
        Centred = "centred",
        Drilled = "drilled",
        CoreDrilled = "core-drilled",
        RoughBored = "rough-bored",
        BoredOnce = "bored-once",
        BoredTwice = "bored-twice",
        Milled = "milled",
        Counterbored = "counterbored",
        ReamedAfterDrill = "reamed-after-drill",
        ReamedAfterCoreDrill = "reamed-after-core-drill",
        ReamedAfterBoring = "reamed-after-boring",
        ReamedAfterTwoBorings = "reamed-after-two-borings",
        CastHole = "cast-hole",
        PreMachinedHole = "pre-machined-hole",
        OwnCylinder = "own-cylinder",
        Finished = "finished",
    }

    /// Lead angle of a reamer.
    pub enum Lead {
        Deg5 = "5deg",
        Deg15 = "15deg",
    }

    /// The grade that a table of schemes is queried with.
    pub enum GradeAsked {
        Own = "own",
        It13 = "13",
    }

    /// The column of centre tolerances that a table of schemes is queried with.
    pub enum CentreColumn {
        Own = "own",
        UpTo03 = "0.05-0.3",
    }

    /// The method of visiting the holes of a group (textbook 1.3.1).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum VisitingMethod {
        /// Each tool visits all holes.
        Parallel = "parallel",
        /// Each hole is made with all tools before the next.
        Sequential = "sequential",
        /// The first transitions in parallel, the finishing ones one after the other at each hole.
        FirstParallelFinishSequential = "first-parallel-finish-sequential",
    }

    /// The choice between two schemes.
    pub enum SchemeTaken {
        First = "first",
        Second = "second",
    }

    /// The tables of feeds.
    pub enum FeedTable {
        /// Of centring tools.
        Centring = "centring-feed",
        /// Of drills.
        Drilling = "drilling-feed",
        /// Of core drills.
        CoreDrilling = "core-drilling-feed",
        /// Of reamers.
        Reaming = "reaming-feed",
        /// Of boring bars; this table is queried separately.
        Boring = "boring-feed",
        /// Of tools that widen the mouth of a hole.
        Counterboring = "counterboring-feed",
    }

    /// The choice between two neighbours.
    pub enum Neighbour {
        /// The one above.
        Above = "above",
        /// The one below.
        Below = "below",
    }

    /// A machining cycle.
    pub enum HoleCycle {
        /// Down at feed, out at rapid.
        Drill = "drill",
        /// Down and out at feed.
        FeedOut = "feed-out",
        /// Down at feed, out at rapid with the spindle stopped.
        BoreStop = "bore-stop",
        /// In steps; after each step out of the hole.
        Peck = "peck",
        /// In steps; after each step a small retract.
        ChipBreak = "chip-break",
        /// A thread.
        Tap = "tap",
        /// A mill on circles.
        Circles = "circles",
    }

    /// How a mill cuts.
    pub enum MillingDirection {
        /// With the feed.
        Climb = "climb",
        /// Against it.
        Conventional = "conventional",
    }

    /// With what a transition moves the part under its clamps.
    pub enum PartLoad {
        /// By its torque alone.
        Turns = "turns",
        /// By the side force of edges on one side.
        Pushes = "pushes",
    }

    /// Kinds of pins that locate a part by a hole of it.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum PinKind {
        /// Round: it takes the part along X and Y.
        Round = "round",
        /// Cut away to two lands: it takes the part across them.
        Cut = "cut",
    }

    /// What holds a part on the table.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum HeldBy {
        /// Straps on its face.
        Straps = "straps",
        /// A vice.
        Vice = "vice",
        /// A three-jaw chuck on the table.
        Chuck = "chuck",
        /// Nothing that the tables have.
        Nothing = "nothing",
        /// A fixture of the shop's own, which the file names.
        Own = "own",
    }

    /// A kind of fixture (textbook 1.6).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum FixtureKind {
        /// A vice, straps, a coordinate plate.
        Universal = "universal",
        /// For a group of parts with bases of one type.
        Specialised = "specialised",
        /// Made for the one part.
        Special = "special",
    }

    /// Whether a chain of dimensions closes.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum ChainClosing {
        /// Whatever the errors are.
        AtWorst = "at-worst",
        /// Statistically.
        Ordinarily = "ordinarily",
        /// Not by figures that nothing confirms, and by the others it does.
        Unconfirmed = "unconfirmed",
        /// Not even by the confirmed figures.
        Fails = "fails",
    }

    /// How grave it is that a chain closes as it does.
    pub enum ChainSeverity {
        None = "none",
        Doubtful = "doubtful",
        Wrong = "wrong",
    }

    /// How many zeros a part gets.
    pub enum ChainZeros {
        One = "one",
        Each = "each",
    }

    /// How a fixture is keyed to the table (textbook 1.7).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum TableKeying {
        /// Two keys in a slot, trued along it.
        TwoKeys = "two-keys",
        /// Pins in the holes of a plate that lies on the table.
        CoordinatePlate = "coordinate-plate",
        /// The cross slot or the central hole of the table.
        CrossElements = "cross-elements",
    }

    /// How a part is located (textbook 1.9).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum PartLocating {
        /// A plane and two fine holes.
        PlaneAndTwoHoles = "plane-and-two-holes",
        /// Two planes and a hole.
        TwoPlanesAndHole = "two-planes-and-hole",
        /// Three planes.
        ThreePlanes = "three-planes",
        /// The face of a round part and its axis.
        PlaneAndAxis = "plane-and-axis",
    }

    /// A load on the machine.
    pub enum Load {
        /// Along the axis.
        Thrust = "thrust",
        /// About it.
        Torque = "torque",
        /// Of the main drive.
        Power = "power",
    }

    /// How a hole was made before a transition.
    pub enum MadeBy {
        /// There is no hole.
        Solid = "solid",
        /// The blank has it; to the proof only a cast one.
        BlankHole = "blank-hole",
        /// A tool made it before this work.
        PreMachined = "pre-machined",
        Drill = "drill",
        CoreDrill = "core-drill",
        Bore = "bore",
        Mill = "mill",
        Ream = "ream",
        Counterbore = "counterbore",
    }

    /// The figure for the worst-case size.
    pub enum Worst {
        /// The best value of the method.
        Best = "best",
        /// The ordinary value of the method.
        Ordinary = "ordinary",
    }

    /// The kind of reamer and the tool before it.
    pub enum ReamingCase {
        OneAfterDrill = "one-after-drill",
        OneAfterCoreDrill = "one-after-core-drill",
        RoughAfterDrill = "rough-after-drill",
        RoughAfterCoreDrill = "rough-after-core-drill",
        FinishAfterRough = "finish-after-rough",
    }

    /// The kind of cut on a lathe, for speeds.
    pub enum LatheCut {
        Rough = "rough",
        Finish = "finish",
        Groove = "groove",
    }

    /// Whether the handbook has a formula with figures for the material.
    pub enum Formula {
        Own = "own",
        None = "none",
    }

    /// The choice of a speed.
    pub enum Taken {
        Formula = "formula",
        PracticeLow = "practice-low",
        PracticeUsual = "practice-usual",
        PracticeHigh = "practice-high",
    }

    /// The figure of practice that a feed does not exceed.
    pub enum HeldTo {
        Unheld = "unheld",
        Least = "least",
        Usual = "usual",
        Most = "most",
    }

    /// The limit of a tolerance field that its fundamental deviation gives.
    pub enum FieldBegins {
        Upper = "upper",
        Lower = "lower",
        /// Evenly about the nominal size.
        About = "about",
    }
}
