use super::super::crowd::{SIZES, assert_legible, crowd, nothing, texts};
use super::super::sample::{BALL, FLOOR, SKY, SPARK, Sample};
use super::super::words::Language;
use super::*;
use crate::picture::{Theme, rasterize, to_png};
use crate::render::Method;

fn all_words(picture: &Picture) -> String {
    let words: Vec<&str> = texts(picture).into_iter().map(|(text, _)| text).collect();
    words.join("\n")
}

/// A tree of 200 rays and more: between the faces of the glass cube.
fn large() -> Sample {
    let mut sample = Sample::rays(Method::RayTracing, (150, 260), 10);
    let last = sample.walk().len() - 1;
    sample.seek(last);
    sample
}

#[test]
fn look() {
    let save = |name: &str, sample: &Sample, size: Vec2, theme: Theme| {
        let picture = draw(&sample.show(), size);
        let pixels = rasterize(&picture, theme, 1.0).unwrap();
        std::fs::write(format!("/tmp/t/{name}.png"), to_png(&pixels)).unwrap();
    };
    let mut sample = Sample::rays(Method::RayTracing, BALL, 5);
    let (s, m, l) = (
        Vec2::new(420.0, 260.0),
        Vec2::new(690.0, 620.0),
        Vec2::new(1400.0, 900.0),
    );
    sample.go_to("BranchAdded", 4);
    save("a", &sample, m, Theme::Light);
    save("a-s", &sample, s, Theme::Light);
    save("a-l", &sample, l, Theme::Dark);
    sample.go_to("TotalInternalReflection", 0);
    save("b", &sample, m, Theme::Projector);
    sample.go_to("Shadow", 0);
    save("c", &sample, m, Theme::Light);
    let large = large();
    println!("large {}", state(&large.show()).unwrap().rays.len());
    save("d", &large, m, Theme::Light);
    save("d-l", &large, l, Theme::Light);
    save("d-s", &large, s, Theme::Light);
    let mut sample = Sample::rays(Method::RayCasting, FLOOR, 5);
    let last = sample.walk().len() - 2;
    sample.seek(last);
    save("e", &sample, m, Theme::Light);
}

#[test]
fn nothing_overlaps_or_is_cut_at_any_step_and_size() {
    let mut samples = [
        Sample::rays(Method::RayTracing, BALL, 5),
        Sample::rays(Method::RayTracing, SPARK, 3),
        Sample::rays(Method::RayTracing, SKY, 5),
        Sample::rays(Method::RayCasting, FLOOR, 5),
        crowd(Method::Gouraud),
        nothing(),
        large(),
    ];
    for (i, sample) in samples.iter_mut().enumerate() {
        for step in sample.some_steps(97) {
            sample.seek(step);
            for language in Language::ALL {
                for size in SIZES {
                    let picture = draw(&sample.show_in(language), size);
                    assert_legible(&picture, &format!("sample {i}, step {step}, {size}"));
                }
            }
        }
    }
}
