//! Words of the rules that code goes by.

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

    /// What stands where a hole is to be.
    pub enum BlankState {
        Solid = "solid",
        WithHole = "cast-or-pre-machined",
    }

    /// Whether the position of the axis requires boring.
    pub enum BoringAsked {
        Asked = "asked",
        NotAsked = "not-asked",
    }

    /// What the centring spot is as wide as.
    pub enum Spot {
        Chamfer = "chamfer",
        ShareOfDrill = "share-of-drill",
    }

    /// What stands for an empty cell of A.8 or A.9.
    pub enum CellTaken {
        Own = "own-cell",
        FinerRoughness = "finer-roughness",
        FinerGrade = "finer-grade",
        Nothing = "nothing",
    }

    /// What opens a large hole.
    pub enum MillInstead {
        Same = "same",
        Mill = "mill",
    }

    /// What stands in where no boring bar enters.
    pub enum BoringInstead {
        Same = "same",
        CoreDrill = "core-drill",
        Nothing = "nothing",
    }

    /// What was done to a hole last, or what the blank has there.
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

    /// How the holes of a group are visited (textbook 1.3.1).
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum VisitingMethod {
        /// Each tool goes round all holes.
        Parallel = "parallel",
        /// Each hole is made with all tools before the next.
        Sequential = "sequential",
        /// The first transitions in parallel, the finishing ones one after the other at each hole.
        FirstParallelFinishSequential = "first-parallel-finish-sequential",
    }

    /// Which of two schemes.
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
        /// Of boring bars, which is asked in a way of its own.
        Boring = "boring-feed",
        /// Of what widens the mouth of a hole.
        Counterboring = "counterboring-feed",
    }

    /// Which of two neighbours is taken.
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
        /// Down at feed, out at rapid with the spindle at rest.
        BoreStop = "bore-stop",
        /// In steps, after each out of the hole.
        Peck = "peck",
        /// In steps, after each back a little.
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

    /// A load that the machine bears.
    pub enum Load {
        /// Along the axis.
        Thrust = "thrust",
        /// About it.
        Torque = "torque",
        /// Of the main drive.
        Power = "power",
    }

    /// What a hole was made by before a transition.
    pub enum MadeBy {
        /// Nothing: there is none.
        Solid = "solid",
        /// The blank has it.
        BlankHole = "blank-hole",
        Drill = "drill",
        CoreDrill = "core-drill",
        Bore = "bore",
        Mill = "mill",
        Ream = "ream",
        Counterbore = "counterbore",
    }

    /// By which figure a size at worst is calculated.
    pub enum Worst {
        /// What the way reaches at best.
        Best = "best",
        /// What it reaches ordinarily.
        Ordinary = "ordinary",
    }

    /// Which reamer follows what.
    pub enum ReamingCase {
        OneAfterDrill = "one-after-drill",
        OneAfterCoreDrill = "one-after-core-drill",
        RoughAfterDrill = "rough-after-drill",
        RoughAfterCoreDrill = "rough-after-core-drill",
        FinishAfterRough = "finish-after-rough",
    }

    /// What a lathe tool does, as far as speeds tell it apart.
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

    /// Which speed is taken.
    pub enum Taken {
        Formula = "formula",
        PracticeLow = "practice-low",
        PracticeUsual = "practice-usual",
        PracticeHigh = "practice-high",
    }
}
