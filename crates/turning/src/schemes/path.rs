//! A toolpath: points in order, each with the motion that leads to it.

use serde::Serialize;

use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::{Purpose, Toolpath};

/// The motion of the tool to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Motion {
    /// Through air, as fast as the axes move.
    Rapid,
    /// At the working feed along the axis.
    Along,
    /// At the working feed across the axis, outwards: up a face of the contour.
    Across,
}

/// The role of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum VertexRole {
    /// A: off the corner of the blank by δ.
    Home,
    /// On the vertical in front of a pass, δ before the metal.
    Start,
    /// Where a motion at the working feed ends on a vertical.
    End,
    /// The outer corner of a face, after it was cleaned.
    Corner,
    /// Retracted from the metal.
    Retracted,
    /// Back on the vertical of the start, before going to the depth.
    Returned,
}

/// A point of the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Vertex {
    /// Its position.
    #[serde(flatten)]
    pub at: Point,
    /// The motion to it.
    pub motion: Motion,
    /// Its role.
    pub role: VertexRole,
    /// The part of the feed motion before the metal: δ, or zero.
    #[serde(skip)]
    pub air: Half,
}

/// A path under construction.
#[derive(Clone, Debug)]
pub struct SchemePath {
    vertices: Vec<Vertex>,
    approach: Half,
    retract: Half,
}

impl SchemePath {
    /// Begins at the home point, off the free end and off the largest radius of the blank by the approach δ.
    pub fn new(largest: Half, approach: Half, retract: Half) -> Self {
        let at = Point { radius: largest + approach, z: Half::ZERO - approach };
        let home = Vertex { at, motion: Motion::Rapid, role: VertexRole::Home, air: Half::ZERO };
        Self { vertices: vec![home], approach, retract }
    }

    /// Moves to where the metal of a pass begins, in the order of the lecture (l. 691, 712-716).
    ///
    /// 1. The tool retracts, off the surface and off the face where it is.
    /// 2. It returns at this radius to the vertical of the start, δ before the metal.
    /// 3. It moves across to the depth of the pass.
    ///
    /// To a start farther out, in the next section of a stepped blank, it moves across first: between the two points
    /// the blank may be as large as the part.
    pub fn start(&mut self, metal: Point) {
        self.draw_back();
        let start = Point { radius: metal.radius, z: metal.z - self.approach };
        let here = self.here();
        let corner = if start.radius > here.radius {
            Point { radius: start.radius, z: here.z }
        } else {
            Point { radius: here.radius, z: start.z }
        };
        if corner != here && corner != start {
            self.put(corner, Motion::Rapid, VertexRole::Returned, Half::ZERO);
        }
        self.put(start, Motion::Rapid, VertexRole::Start, Half::ZERO);
    }

    /// Cuts along the axis to a Z.
    pub fn along(&mut self, z: Half) {
        let at = Point { radius: self.here().radius, z };
        let started = self.vertices.last().is_some_and(|last| last.role == VertexRole::Start);
        let air = if started { self.approach } else { Half::ZERO };
        self.put(at, Motion::Along, VertexRole::End, air);
    }

    /// Goes up a face to its corner.
    pub fn corner(&mut self, radius: Half) {
        self.across(radius, VertexRole::Corner);
    }

    /// Goes up along the face of stock that is still there, to where the next pass begins.
    pub fn rise(&mut self, radius: Half) {
        self.across(radius, VertexRole::End);
    }

    /// All points, the return to home included.
    pub fn home(mut self) -> Vec<Vertex> {
        self.draw_back();
        if let Some(&home) = self.vertices.first().filter(|_| self.vertices.len() > 1) {
            self.vertices.push(home);
        }
        self.vertices
    }

    fn across(&mut self, radius: Half, role: VertexRole) {
        let here = self.here();
        if radius > here.radius {
            self.put(Point { radius, z: here.z }, Motion::Across, role, Half::ZERO);
        }
    }

    fn draw_back(&mut self) {
        if self.vertices.len() > 1 {
            let here = self.here();
            let at = Point { radius: here.radius + self.retract, z: here.z - self.retract };
            self.put(at, Motion::Rapid, VertexRole::Retracted, Half::ZERO);
        }
    }

    fn here(&self) -> Point {
        self.vertices.last().map(|last| last.at).unwrap_or_default()
    }

    fn put(&mut self, at: Point, motion: Motion, role: VertexRole, air: Half) {
        self.vertices.push(Vertex { at, motion, role, air });
    }
}

/// A path as a toolpath. Up a face the tool cuts what passes left there.
pub fn toolpath(path: &[Vertex]) -> Toolpath {
    let mut points = path.iter();
    let mut toolpath = points.next().map(|home| Toolpath::at(home.at)).unwrap_or_default();
    for vertex in points {
        let purpose = match vertex.motion {
            Motion::Rapid => Purpose::Rapid,
            Motion::Along => Purpose::Cut,
            Motion::Across => Purpose::PickUp,
        };
        toolpath.go(vertex.at, purpose);
    }
    toolpath
}
