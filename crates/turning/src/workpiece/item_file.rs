//! The items of a contour as authors write them, for the schema of the file.

use schemars::JsonSchema;
use serde::Deserialize;
use technolog_knowledge::forms;

use super::file::Size;
use crate::knowledge::form::{Form, KeyOf};

use super::file::{Width, Z};

/// What the contour does next.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ItemFile {
    /// Where it begins.
    From(FromItem),
    /// Across the axis.
    Face(FaceItem),
    /// Along the axis.
    Cylinder(CylinderItem),
    /// Straight to a point.
    Cone(ConeItem),
    /// At 45°.
    Chamfer(ChamferItem),
    /// Along an arc.
    Arc(ArcItem),
    /// A cylinder with a thread.
    Thread(ThreadItem),
    /// A groove.
    Groove(GrooveItem),
}

forms! {
    /// A point.
    pub struct PointFile {
        /// Diameter.
        pub d: Width,
        /// Z.
        pub z: Z,
    }

    /// Where a contour begins: the first item.
    pub struct FromItem {
        /// The point.
        pub from: PointFile,
    }

    /// The length of a cylinder.
    pub struct Stretch {
        /// So long.
        pub length: Size,
    }
}

forms! {
    /// The limits of a size, from its nominal value.
    pub struct LimitsFile {
        /// To the largest size.
        pub upper: Deviation,
        /// To the smallest size.
        pub lower: Deviation,
    }
}

/// A deviation, mm.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Deviation(#[schemars(range(min = -10.0, max = 10.0))] pub f64);

/// Where a cylinder ends.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum AlongFile {
    /// At a Z.
    Z(Z),
    /// After a length.
    Stretch(Stretch),
}

/// An accuracy: a grade (`6`), or a field (`h6`, in a bore `H7`).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum GradeFile {
    /// By number.
    Number(#[schemars(range(min = 1, max = 18))] u8),
    /// By field.
    Field(String),
}

/// An item that is a surface, and may say so of itself.
pub trait Surface: Form {
    /// `name`, `grade`, `roughness`, `allowance`.
    const ATTRIBUTES: [KeyOf<Self>; 4];
}

macro_rules! items {
    ($($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),* $(,)? })*) => {$(
        forms! {
            $(#[$doc])*
            pub struct $name {
                $($(#[$field_doc])* pub $field: $kind,)*
                /// A name of its own; its place on the contour unless said.
                pub name: Option<String>,
                /// Its accuracy.
                pub grade: Option<GradeFile>,
                /// Its roughness: `Ra 1.25` or `Rz 20`.
                pub roughness: Option<String>,
                /// Its finishing allowance on one side, instead of that of `allowances`.
                pub allowance: Option<Width>,
            }
        }

        impl Surface for $name {
            const ATTRIBUTES: [KeyOf<Self>; 4] = [Self::name, Self::grade, Self::roughness, Self::allowance];
        }
    )*};
}

items! {
    /// Straight across the axis.
    FaceItem {
        /// To this diameter.
        face: Width,
        /// The limits of its distance from the free end; the program makes the middle.
        limits: Option<LimitsFile>,
    }
    /// Along the axis.
    CylinderItem {
        /// To this Z, or so long.
        cylinder: AlongFile,
        /// The limits of its diameter, in place of a field; the program makes the middle.
        limits: Option<LimitsFile>,
    }
    /// Straight to a point.
    ConeItem {
        /// The point.
        cone: PointFile,
        /// A cone, or a chamfer that breaks an edge; a cone unless said.
        kind: Option<ConeKind>,
    }
    /// At 45°, as far across as along; which way, a face beside it says.
    ChamferItem {
        /// So much across and along.
        chamfer: Size,
    }
    /// An arc of at most half a circle.
    ArcItem {
        /// Where it ends.
        arc: PointFile,
        /// Its radius.
        radius: Size,
        /// Hollow or bulging.
        bulge: Bulge,
    }
    /// A cylinder with a metric thread.
    ThreadItem {
        /// The thread: `M36x2`, `M36x2-6g`.
        thread: String,
        /// It ends at this Z.
        to: Option<Z>,
        /// Or it is so long.
        length: Option<Size>,
    }
    /// A groove: it begins where the contour stands, and its mouth is `width` wide.
    GrooveItem {
        /// Its kind.
        groove: GrooveKind,
        /// Width of its mouth; of a relief that of its standard unless said.
        width: Option<Size>,
        /// Its depth; of a relief that of its standard unless said.
        depth: Option<Size>,
        /// Of a trapezoid or pulley groove: the angle between its walls, degrees.
        angle: Option<Angle>,
        /// Rounding of the corners of its floor.
        radius: Option<Size>,
    }
}

/// An angle, degrees.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Angle(#[schemars(range(min = 0.0, max = 180.0))] pub f64);

technolog_knowledge::vocabulary! {
    /// What a slanting line is.
    #[derive(Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum ConeKind {
        /// A cone.
        Cone = "cone",
        /// It breaks an edge.
        Chamfer = "chamfer",
    }

    /// To which side an arc bends.
    #[derive(Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Bulge {
        /// Into the metal: a fillet.
        In = "in",
        /// Out of it: a ball.
        Out = "out",
    }

    /// Kinds of grooves.
    #[derive(Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum GrooveKind {
        /// For the grinding wheel, in a cylinder.
        GrindingRelief = "grinding-relief",
        /// For the grinding wheel, in the corner of a cylinder and a face.
        Corner = "corner",
        /// At the end of a thread.
        ThreadRelief = "thread-relief",
        /// With upright walls.
        Rectangular = "rectangular",
        /// With slanting walls.
        Trapezoid = "trapezoid",
        /// For a belt.
        Pulley = "pulley",
        /// In a face.
        Face = "face",
    }
}
