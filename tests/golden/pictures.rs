//! About a hundred pictures, a handful of each panel, chosen for what they show, in both languages, all themes, and for plain
//! and dense screens: what a display list cannot say, the rasteriser's work above all.
//!
//! A file's name says what it shows: `lesson_step_panel_language_theme_scale.png`. To choose another picture, put an empty file
//! under its name, and renew.

use crate::files::{self, golden, updating};
use crate::walk::Walk;
use lightwalk::color::png_rgba8;
use lightwalk::panels::Panel;
use lightwalk::panels::strings::Language;
use lightwalk::picture::Theme;
use lightwalk::picture::{rasterize, to_png};
use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

/// A chosen picture.
struct Choice {
    lesson: String,
    /// Among the narrated ones.
    step: usize,
    panel: Panel,
    language: Language,
    theme: Theme,
    scale: f32,
    name: String,
}

/// # Panics
/// At a file that is named otherwise.
fn choice(name: &str) -> Choice {
    let parts: Vec<&str> = name.trim_end_matches(".png").split('_').collect();
    let [lesson, step, panel, language, theme, scale] = parts[..] else {
        panic!("{name}: not named lesson_step_panel_language_theme_scale.png");
    };
    Choice {
        lesson: lesson.to_string(),
        step: step.parse().expect(name),
        panel: Panel::from_name(panel).expect(name),
        language: Language::ALL
            .into_iter()
            .find(|one| one.code() == language)
            .expect(name),
        theme: [Theme::Light, Theme::Dark, Theme::Projector]
            .into_iter()
            .find(|one| format!("{one:?}").to_lowercase() == theme)
            .expect(name),
        scale: scale.parse().expect(name),
        name: format!("pictures/{name}"),
    }
}

static CHOSEN: LazyLock<Vec<Choice>> = LazyLock::new(|| {
    let folder = golden("pictures");
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names.iter().map(|name| choice(name)).collect()
});

#[test]
fn the_pictures_show_every_panel_in_both_languages_all_themes_and_scales() {
    assert!(CHOSEN.len() >= 90);
    for panel in Panel::ALL {
        assert!(
            CHOSEN.iter().any(|choice| choice.panel == panel),
            "{panel:?}"
        );
    }
    for lesson in lightwalk::lesson::builtins() {
        assert!(
            CHOSEN.iter().any(|choice| choice.lesson == lesson.id),
            "{}",
            lesson.id
        );
    }
}

/// How the chosen pictures of a lesson differ from the golden ones. New ones and differences are kept where builds go.
pub fn differences(lesson: &str, walk: &mut Walk) -> Vec<String> {
    let chosen = CHOSEN.iter().filter(|choice| choice.lesson == lesson);
    let new = |choice: &Choice| {
        let larger = choice.theme.text_scale();
        let picture = walk.panel(choice.step, choice.panel, choice.language, larger);
        let pixmap = rasterize(&picture, choice.theme, choice.scale * larger).unwrap();
        difference(&choice.name, &to_png(&pixmap))
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
