//! Ray casting and ray tracing.

mod closed_forms;
mod contract;
mod limits;
mod random_scenes;
mod reference;
mod scenes;

use crate::common::{TEAPOT, prepared};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::primary::Settings;
use lightwalk::algorithms::ray_casting::{RayCaster, ray_casting};
use lightwalk::algorithms::ray_tracing::{RayTracer, ray_tracing};
use lightwalk::algorithms::visible::{BruteForce, Bvh, Search};
use lightwalk::record::Unrecorded;
use lightwalk::scene::Needs;
use std::num::NonZeroU32;

fn blank(prepared: &PreparedScene) -> Frame {
    Frame::new(
        prepared.view.width,
        0..prepared.view.height,
        prepared.scene.background,
    )
}

fn traced(prepared: &PreparedScene, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(prepared);
    let tracer = RayTracer::new(prepared, needs, search);
    ray_tracing(&tracer, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn cast(prepared: &PreparedScene, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(prepared);
    let caster = RayCaster::new(prepared, needs, search);
    ray_casting(&caster, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn picture(prepared: &PreparedScene) -> Frame {
    traced(prepared, prepared.needs(), Bvh)
}

fn settings(depth: u32, samples: u32) -> Settings {
    Settings {
        depth: NonZeroU32::new(depth).expect("not 0"),
        samples: NonZeroU32::new(samples).expect("not 0"),
    }
}

#[test]
fn a_mesh_of_glass_is_the_same_by_hierarchy() {
    let glass = TEAPOT.replace(
        "\"specular\": 0.5,",
        "\"specular\": 0.5, \"transmission\": 0.8, \"reflection\": 0.1, \"ior\": 1.4,",
    );
    let prepared = prepared(&glass, 60, 45);
    assert!(prepared.needs().transmission);
    assert!(traced(&prepared, prepared.needs(), BruteForce) == picture(&prepared));
    assert!(
        cast(&prepared, prepared.needs(), BruteForce) == cast(&prepared, prepared.needs(), Bvh)
    );
}
