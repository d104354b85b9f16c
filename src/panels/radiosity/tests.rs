use super::super::crowd::{self, SIZES, assert_legible, texts};
use super::super::sample::{self, Sample};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::picture::{Shape, Theme, rasterize, to_png};
use crate::render::Method;

const WIDE: Vec2 = Vec2::new(800.0, 500.0);

#[test]
fn dump() {
    for (name, mut sample, stops) in [
        (
            "gs",
            Sample::room(Solver::GaussSeidel, Focus::Frame),
            vec![
                ("Room", 0),
                ("Exchanged", 2000),
                ("Exchanged", 30000),
                ("RoomDone", 0),
            ],
        ),
        (
            "sh",
            Sample::room(Solver::Shooting, Focus::Frame),
            vec![("Received", 30), ("Received", 3000), ("RoomDone", 0)],
        ),
        (
            "ff",
            Sample::room(Solver::Auto, Focus::FormFactor { i: 8, j: 50 }),
            vec![("Reference", 0), ("FormFactorFound", 0)],
        ),
    ] {
        for (kind, n) in stops {
            sample.go_to(kind, n);
            for (theme, size) in [
                (Theme::Light, Vec2::new(380.0, 280.0)),
                (Theme::Dark, WIDE),
                (Theme::Light, WIDE),
            ] {
                for (panel, picture) in [
                    ("room", draw(&sample.show(), size)),
                    (
                        "conv",
                        super::super::convergence::draw(&sample.show(), size),
                    ),
                ] {
                    let path =
                        format!("/tmp/p1/{panel}-{name}-{kind}-{n}-{}-{theme:?}.png", size.x);
                    std::fs::write(path, to_png(&rasterize(&picture, theme, 1.0).unwrap()))
                        .unwrap();
                }
            }
        }
    }
}
