//! The camera, and places on the picture in front of it.

use super::{Given, Recorded, SceneValue, number, one, value};
use crate::scene::Camera;
use glam::DVec2;

pub(super) const VALUES: &[SceneValue] = &[
    value("eye", "eye", |given, _| one(given.prepared.view.eye)),
    value("target", "target", |given, _| one(camera(given)?.target)),
    value("camera_up", "up", |given, _| one(camera(given)?.up)),
    value("half_fov", "½ fov_x", |given, _| {
        one(0.5 * camera(given)?.fov_x.to_degrees())
    }),
    value("forward", "forward", |given, _| {
        one(given.prepared.view.forward)
    }),
    value("right", "right", |given, _| one(given.prepared.view.right)),
    value("up", "up′", |given, _| one(given.prepared.view.up)),
    value("focal", "f", |given, _| one(given.prepared.view.focal)),
    value("near", "near", |given, _| one(given.prepared.view.near)),
    value("screen_point", "P_s", |given, recorded| {
        let view = &given.prepared.view;
        one(view.from_screen(place(recorded)?, view.focal))
    }),
    value("middle_point", "P_s", |given, recorded| {
        let view = &given.prepared.view;
        let middle = DVec2::new(number(recorded, "x_0")?, number(recorded, "y_0")?);
        one(view.from_screen(middle, view.focal))
    }),
];

fn camera<'a>(given: Given<'a>) -> Option<&'a Camera> {
    given.prepared.scene.camera.as_ref()
}

/// Where the step is on the screen; a pixel of a span at the centre of its row.
fn place(recorded: Recorded) -> Option<DVec2> {
    let y = number(recorded, "y_P").or_else(|| Some(number(recorded, "y")? + 0.5));
    Some(DVec2::new(number(recorded, "x_P")?, y?))
}
