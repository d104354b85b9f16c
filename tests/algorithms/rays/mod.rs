//! Ray casting and ray tracing.

mod closed_forms;
mod contract;
mod limits;
mod random_scenes;
mod reference;
pub mod scenes;
mod touching;

use crate::common::{TEAPOT, setup};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::primary::Settings;
use lightwalk::algorithms::ray_casting::{RayCaster, ray_casting};
use lightwalk::algorithms::ray_tracing::{RayTracer, ray_tracing};
use lightwalk::algorithms::visible::{BruteForce, Bvh, Search};
use lightwalk::methods::Setup;
use lightwalk::record::Unrecorded;
use lightwalk::scene::Needs;
use std::num::NonZeroU32;

fn blank(setup: &Setup) -> Frame {
    setup.prepared.empty_frame()
}

fn traced(setup: &Setup, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(setup);
    let tracer = RayTracer::new(&setup.prepared, setup.settings.get(), needs, search);
    ray_tracing(&tracer, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn cast(setup: &Setup, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(setup);
    let caster = RayCaster::new(&setup.prepared, setup.settings.get(), needs, search);
    ray_casting(&caster, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn picture(setup: &Setup) -> Frame {
    traced(setup, setup.needs(), Bvh)
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
    let setup = setup(&glass, 60, 45);
    assert!(setup.needs().transmission);
    assert!(traced(&setup, setup.needs(), BruteForce) == picture(&setup));
    assert!(cast(&setup, setup.needs(), BruteForce) == cast(&setup, setup.needs(), Bvh));
}
