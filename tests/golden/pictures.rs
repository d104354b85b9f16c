//! About a hundred pictures, a handful of each panel, chosen for what they show, in both languages, all themes, and for plain
//! and dense screens: what a display list cannot say, the rasteriser's work above all.

use crate::files::{self, golden, updating};
use crate::walk::Walk;
use lightwalk::color::png_rgba8;
use lightwalk::panels::Panel;
use lightwalk::panels::strings::Language::{self, English, Indonesian};
use lightwalk::picture::Theme::{self, Dark, Light, Projector};
use lightwalk::picture::{rasterize, to_png};
use std::fs;
use std::path::PathBuf;

/// Lesson, narrated step, panel, language, theme, scale.
const CHOSEN: &[(&str, usize, Panel, Language, Theme, f32)] = &[
    ("assumptions", 0, Panel::Code, Indonesian, Light, 1.0),
    ("assumptions", 0, Panel::Formula, English, Light, 1.0),
    ("assumptions", 0, Panel::Matrix, English, Light, 1.0),
    ("assumptions", 1, Panel::Inspector, Indonesian, Light, 1.0),
    ("assumptions", 1, Panel::Radiosity, Indonesian, Light, 1.0),
    ("assumptions", 1, Panel::TimeLine, Indonesian, Light, 1.0),
    ("assumptions", 12, Panel::Matrix, English, Dark, 1.0),
    ("color-bleeding", 0, Panel::Image, English, Light, 1.0),
    ("color-bleeding", 4, Panel::Matrix, Indonesian, Dark, 2.0),
    (
        "color-bleeding",
        4,
        Panel::Radiosity,
        English,
        Projector,
        2.0,
    ),
    ("cornell-box", 0, Panel::Convergence, Indonesian, Light, 1.0),
    ("depth-attenuation", 0, Panel::RayTree, English, Light, 1.0),
    ("depth-attenuation", 1, Panel::Rays, Indonesian, Light, 1.0),
    ("distance", 0, Panel::Illumination, Indonesian, Light, 1.0),
    ("distance", 1, Panel::Vectors, English, Light, 1.0),
    ("distance", 6, Panel::Illumination, Indonesian, Dark, 1.0),
    (
        "distance",
        10,
        Panel::Illumination,
        Indonesian,
        Projector,
        1.0,
    ),
    ("error-against-time", 1, Panel::Race, English, Light, 1.0),
    (
        "error-against-time",
        2,
        Panel::Code,
        English,
        Projector,
        2.0,
    ),
    (
        "error-against-time",
        2,
        Panel::Convergence,
        English,
        Projector,
        2.0,
    ),
    (
        "error-against-time",
        3,
        Panel::Formula,
        Indonesian,
        Dark,
        2.0,
    ),
    (
        "error-against-time",
        3,
        Panel::TimeLine,
        English,
        Projector,
        2.0,
    ),
    (
        "error-against-time",
        5,
        Panel::Radiosity,
        Indonesian,
        Dark,
        1.0,
    ),
    ("error-against-time", 10, Panel::Race, English, Dark, 1.0),
    ("extremes", 1, Panel::Vertex, Indonesian, Light, 1.0),
    ("extremes", 2, Panel::Comparison, English, Light, 1.0),
    ("extremes", 2, Panel::ScanLine, English, Light, 1.0),
    ("extremes", 5, Panel::Image, Indonesian, Dark, 2.0),
    ("extremes", 11, Panel::Vertex, English, Light, 2.0),
    ("fast-phong", 0, Panel::Difference, English, Light, 1.0),
    ("fast-phong", 1, Panel::Profile, Indonesian, Light, 1.0),
    ("fast-phong", 5, Panel::Comparison, Indonesian, Dark, 2.0),
    ("fast-phong", 12, Panel::Difference, English, Dark, 1.0),
    ("fast-phong", 13, Panel::Profile, Indonesian, Projector, 1.0),
    ("flat-shading", 3, Panel::Difference, Indonesian, Dark, 2.0),
    ("flat-shading", 3, Panel::Vectors, Indonesian, Dark, 2.0),
    ("flat-shading", 3, Panel::Vertex, English, Projector, 2.0),
    ("flat-shading", 9, Panel::Vertex, Indonesian, Projector, 1.0),
    ("form-factors", 0, Panel::FormFactor, Indonesian, Light, 1.0),
    ("form-factors", 3, Panel::Inspector, English, Projector, 2.0),
    (
        "form-factors",
        4,
        Panel::FormFactor,
        English,
        Projector,
        2.0,
    ),
    ("form-factors", 7, Panel::FormFactor, Indonesian, Dark, 1.0),
    ("form-factors", 10, Panel::FormFactor, English, Light, 2.0),
    (
        "form-factors",
        13,
        Panel::FormFactor,
        Indonesian,
        Projector,
        1.0,
    ),
    ("gathering", 3, Panel::Race, Indonesian, Dark, 2.0),
    ("gathering", 6, Panel::Convergence, Indonesian, Dark, 1.0),
    ("gathering", 6, Panel::Matrix, English, Projector, 1.0),
    ("gathering", 10, Panel::Radiosity, English, Light, 2.0),
    ("gouraud-teapot", 1, Panel::ActiveEdges, English, Light, 1.0),
    ("gouraud-teapot", 2, Panel::ScanLine, Indonesian, Dark, 2.0),
    ("gouraud-teapot", 5, Panel::Formula, English, Projector, 1.0),
    ("gouraud-teapot", 5, Panel::TimeLine, Indonesian, Dark, 1.0),
    ("gouraud-teapot", 6, Panel::Code, Indonesian, Dark, 1.0),
    ("gouraud-teapot", 6, Panel::Vertex, Indonesian, Dark, 1.0),
    (
        "gouraud-teapot",
        10,
        Panel::ActiveEdges,
        Indonesian,
        Light,
        2.0,
    ),
    (
        "gouraud-triangle",
        3,
        Panel::ActiveEdges,
        Indonesian,
        Dark,
        2.0,
    ),
    ("gouraud-triangle", 6, Panel::Image, English, Projector, 1.0),
    (
        "gouraud-triangle",
        7,
        Panel::ScanLine,
        English,
        Projector,
        1.0,
    ),
    (
        "gouraud-triangle",
        12,
        Panel::ActiveEdges,
        English,
        Dark,
        1.0,
    ),
    (
        "illumination-model",
        3,
        Panel::Illumination,
        English,
        Projector,
        2.0,
    ),
    (
        "illumination-model",
        7,
        Panel::Illumination,
        English,
        Light,
        2.0,
    ),
    (
        "incremental-drift",
        7,
        Panel::ActiveEdges,
        English,
        Projector,
        1.0,
    ),
    (
        "incremental-drift",
        8,
        Panel::Inspector,
        Indonesian,
        Dark,
        1.0,
    ),
    (
        "incremental-drift",
        10,
        Panel::ScanLine,
        Indonesian,
        Light,
        2.0,
    ),
    ("linear-system", 9, Panel::Inspector, English, Light, 2.0),
    ("linear-system", 9, Panel::Matrix, Indonesian, Light, 2.0),
    ("linear-system", 10, Panel::Convergence, English, Light, 2.0),
    ("mach-bands", 5, Panel::Profile, English, Projector, 2.0),
    ("mach-bands", 6, Panel::Comparison, English, Projector, 1.0),
    ("mach-bands", 8, Panel::Difference, English, Projector, 1.0),
    ("mach-bands", 9, Panel::Formula, Indonesian, Light, 2.0),
    ("mach-bands", 10, Panel::Code, English, Light, 2.0),
    ("mach-bands", 11, Panel::TimeLine, English, Light, 2.0),
    ("mach-bands", 13, Panel::ScanLine, English, Dark, 1.0),
    ("needs", 3, Panel::Rays, English, Projector, 2.0),
    ("phong-highlight", 7, Panel::Profile, Indonesian, Dark, 1.0),
    (
        "phong-highlight",
        9,
        Panel::Comparison,
        Indonesian,
        Light,
        2.0,
    ),
    (
        "phong-highlight",
        12,
        Panel::Inspector,
        Indonesian,
        Projector,
        1.0,
    ),
    ("ray-casting", 9, Panel::Image, Indonesian, Light, 2.0),
    ("ray-tree", 4, Panel::RayTree, Indonesian, Dark, 2.0),
    ("ray-tree", 6, Panel::Vectors, English, Projector, 1.0),
    ("ray-tree", 9, Panel::Rays, Indonesian, Dark, 1.0),
    ("reflection", 7, Panel::RayTree, English, Projector, 1.0),
    ("reflection", 11, Panel::Rays, English, Light, 2.0),
    ("reflection", 11, Panel::Vectors, Indonesian, Light, 2.0),
    ("refraction", 10, Panel::RayTree, Indonesian, Light, 2.0),
    (
        "refraction",
        12,
        Panel::TimeLine,
        Indonesian,
        Projector,
        1.0,
    ),
    ("refraction", 13, Panel::Formula, English, Dark, 1.0),
    ("refraction", 14, Panel::Code, Indonesian, Projector, 1.0),
    ("shadows", 12, Panel::Vectors, English, Dark, 1.0),
    ("shadows", 13, Panel::Image, English, Dark, 1.0),
    ("shadows", 13, Panel::RayTree, English, Dark, 1.0),
    ("shadows", 13, Panel::Rays, Indonesian, Projector, 1.0),
    ("shooting", 7, Panel::Race, English, Projector, 1.0),
    ("shooting", 11, Panel::Radiosity, Indonesian, Projector, 1.0),
    (
        "shooting",
        13,
        Panel::Convergence,
        Indonesian,
        Projector,
        1.0,
    ),
    ("side-by-side", 9, Panel::Difference, Indonesian, Light, 2.0),
    ("side-by-side", 9, Panel::Profile, English, Light, 2.0),
    ("side-by-side", 11, Panel::Comparison, English, Dark, 1.0),
    ("stiff-room", 9, Panel::Race, Indonesian, Light, 2.0),
];

/// How the chosen pictures of a lesson differ from the golden ones. New ones and differences are kept where builds go.
pub fn differences(lesson: &str, walk: &mut Walk) -> Vec<String> {
    let chosen = CHOSEN.iter().filter(|chosen| chosen.0 == lesson);
    let new = |&(_, index, panel, language, theme, scale): &(_, _, Panel, Language, Theme, f32)| {
        let larger = theme.text_scale();
        let picture = walk.panel(index, panel, language, larger);
        let pixmap = rasterize(&picture, theme, scale * larger).unwrap();
        let name = format!(
            "pictures/{lesson}-{index:02}-{}-{}-{}-{scale}.png",
            panel.name(),
            language.code(),
            format!("{theme:?}").to_lowercase()
        );
        difference(&name, &to_png(&pixmap))
    };
    chosen.filter_map(new).collect()
}

/// Pixels of a PNG, RGBA.
fn decode(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    if info.color_type == png::ColorType::Rgb {
        pixels = pixels
            .chunks(3)
            .flat_map(|rgb| [rgb[0], rgb[1], rgb[2], 255])
            .collect();
    }
    (info.width, info.height, pixels)
}

/// The same pixels in fewer bytes, for the repository: no alpha, and the slowest compression.
fn small(png: &[u8]) -> Vec<u8> {
    let (width, height, pixels) = decode(png);
    let rgb: Vec<u8> = pixels
        .chunks(4)
        .flat_map(|pixel| pixel[..3].to_vec())
        .collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&rgb)
        .unwrap();
    file
}

fn difference(name: &str, new: &[u8]) -> Option<String> {
    if updating() {
        files::write(&golden(name), &small(new));
        return None;
    }
    let Ok(old) = fs::read(golden(name)) else {
        return Some(format!("{name}: there is no golden picture"));
    };
    let (width, height, old) = decode(&old);
    let (new_width, new_height, pixels) = decode(new);
    let kept = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    if (width, height) != (new_width, new_height) {
        files::write(&kept, new);
        return Some(format!(
            "{name}: {new_width}×{new_height} instead of {width}×{height}"
        ));
    }
    let changed: Vec<bool> = old
        .chunks(4)
        .zip(pixels.chunks(4))
        .map(|(old, new)| old != new)
        .collect();
    let count = changed.iter().filter(|&&changed| changed).count();
    if count == 0 {
        return None;
    }
    let marks: Vec<u8> = changed
        .iter()
        .flat_map(|&changed| if changed { [255, 0, 0, 255] } else { [255; 4] })
        .collect();
    files::write(
        &kept.with_extension("difference.png"),
        &png_rgba8(width, height, &marks),
    );
    files::write(&kept, new);
    Some(format!(
        "{name}: {count} pixels differ; see {}",
        kept.display()
    ))
}
