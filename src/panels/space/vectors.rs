//! The vectors at the point that is lit, and the normals at the current vertex.

use super::super::vectors::point::vectors;
use super::sketch::Sketch;
use crate::picture::{Ink, Tag};
use crate::replay::Run;
use crate::replay::shading::State;
use glam::DVec3;

/// Length of a unit vector, in sizes of the scene.
const LENGTH: f64 = 0.16;

impl Sketch<'_> {
    /// N, V, L, and H or R, as far as they are recorded.
    pub fn vectors(&mut self) {
        let (_, Some(point)) = self.input.run.lit() else {
            return;
        };
        let walk = self.input.run.walk();
        let kind = walk.kind(walk.position());
        let eye = self.input.run.prepared().view.eye;
        for named in vectors(point, eye) {
            let here = named.recorded_by == kind;
            let ink = if here { Ink::This } else { named.ink };
            self.vector(named.tag, point.position, named.vector, &named.name, ink);
        }
        let disc = Ink::Surface.fill().outlined(Ink::Text.stroke(1.5));
        self.disc(point.position, 3.0, disc);
    }

    /// The arrows that a question asks for: the one that was turned, and the right one once it is revealed.
    pub fn asked(&mut self) {
        for arrow in self.input.answered.arrows() {
            let tag = Tag::Field(arrow.field);
            self.vector(tag, arrow.point, arrow.direction, &arrow.name, arrow.ink);
        }
    }

    fn vector(&mut self, tag: Tag, from: DVec3, vector: DVec3, name: &str, ink: Ink) {
        let to = from + LENGTH * self.extent * vector;
        if let Some([from, to]) = self.arrow(tag, from, to, ink.stroke(2.5)) {
            let ink = if ink == Ink::This { ink } else { Ink::Text };
            self.name(to, 2.0, to - from, name, ink);
        }
    }

    /// The polygon that is being drawn, and at its current vertex the normals of the faces around it and their mean.
    pub fn polygon(&mut self, state: &State) {
        let prepared = state.prepared.clone();
        let polygon = state
            .polygon
            .as_ref()
            .map(|current| current.polygon as usize);
        if let Some((object, face)) =
            polygon.and_then(|number| prepared.tessellation.locate(number))
        {
            let corners = super::surfaces::places(&prepared.tessellation.meshes[object], face);
            self.outline(&corners, Ink::This.stroke(2.0));
        }
        let Some(vertex) = &state.vertex else { return };
        let (at, length) = (vertex.position, 0.6);
        for &(_, normal, step) in &vertex.faces {
            let to = at + length * LENGTH * self.extent * normal;
            self.arrow(Tag::Step(step), at, to, Ink::Muted.stroke(1.5));
        }
        if let Some(normal) = vertex.normal {
            self.vector(Tag::Vertex(vertex.vertex), at, normal, "N_v", Ink::Text);
        }
    }
}

/// Whether the run draws polygons.
pub(super) fn shading(run: &Run) -> Option<&State> {
    match run {
        Run::Shading(_, replay) => Some(replay.state()),
        _ => None,
    }
}
