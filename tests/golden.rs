//! Golden pictures: every lesson × panel × narrated step; and the whole trace of a tiny run, as text.
//! `UPDATE_GOLDEN=1 cargo test --test golden` renews them; look at old and new before you keep them.

use lightwalk::color::png_rgba8;
use lightwalk::lesson::builtins;
use lightwalk::panels::strings::Language;
use lightwalk::panels::{Panel, PanelInput, TreeView, draw};
use lightwalk::picture::{Theme, rasterize, to_png};
use lightwalk::render::compare::compare_on;
use lightwalk::render::render;
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

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

/// How a picture differs from the golden one, if it does. The new one and the difference are kept where builds go.
fn difference(name: &str, new: &[u8]) -> Option<String> {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::create_dir_all(golden.parent().unwrap()).unwrap();
        fs::write(&golden, small(new)).unwrap();
        return None;
    }
    let Ok(old) = fs::read(&golden) else {
        return Some(format!("{name}: there is no golden picture"));
    };
    let (width, height, old) = decode(&old);
    let (new_width, new_height, pixels) = decode(new);
    let kept = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let keep = |path: PathBuf, bytes: &[u8]| {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    };
    if (width, height) != (new_width, new_height) {
        keep(kept, new);
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
    keep(
        kept.with_extension("difference.png"),
        &png_rgba8(width, height, &marks),
    );
    keep(kept.clone(), new);
    Some(format!(
        "{name}: {count} pixels differ; see {}",
        kept.display()
    ))
}

#[test]
fn every_panel_of_every_narrated_step_looks_as_before() {
    let mut differences = Vec::new();
    for builtin in builtins() {
        let mut open = builtin.read().unwrap().open().unwrap();
        let finished = render(
            &open.prepared,
            open.lesson.method,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        // Who is faster is told by a clock that ticks each time it is looked at: the same everywhere.
        let mut ticks = 0.0;
        let mut clock = || {
            ticks += 1e-5;
            ticks
        };
        if open.lesson.panels.contains(&Panel::Race) {
            let enclosure = open.prepared.enclosure().unwrap();
            enclosure
                .race_or(enclosure.matrix().unwrap(), &mut clock)
                .unwrap();
        }
        let methods = open.lesson.compare.iter();
        let compared: Vec<_> = methods
            .map(|&method| compare_on(&open.prepared, method, &mut clock))
            .collect();
        let narrated: Vec<usize> = open.narrated.iter().map(|narrated| narrated.step).collect();
        let mut panels = open.lesson.panels.clone();
        panels.extend([Panel::Code, Panel::Formula, Panel::TimeLine]);
        for (index, &step) in narrated.iter().enumerate() {
            open.run.walk_mut().seek(step);
            let show = PanelInput {
                run: &open.run,
                finished: &finished,
                compared: &compared,
                focus: open.lesson.focus,
                // Both languages have their turn.
                language: Language::ALL[index % 2],
                narrated: &narrated,
                breakpoints: &[],
                tree: TreeView::whole(),
                smooth: open.prepared.radiosity.smooth,
            };
            for &panel in &panels {
                let size = if panel == Panel::TimeLine {
                    (800.0, 130.0)
                } else {
                    (380.0, 280.0)
                };
                let picture = draw(panel, &show, size.into());
                assert!(
                    !picture.alt.is_empty(),
                    "{}: {} has no alternative text",
                    builtin.id,
                    panel.name()
                );
                let pixmap = rasterize(&picture, Theme::Light, 1.0).unwrap();
                let name = format!("{}/{index:02}-{}.png", builtin.id, panel.name());
                differences.extend(difference(&name, &to_png(&pixmap)));
            }
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// A triangle in a picture of 3×3 pixels. Its numbers are sums and products of short ones: the same on every machine.
const TINY: &str = r#"{ "schema": 1, "background": [0, 0, 0],
  "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 90 },
  "materials": { "paper": { "diffuse": [1, 0.5, 0.25] } },
  "objects": [ { "name": "sheet", "material": "paper", "polygon": { "vertices": [[-3, 3, 0], [-3, -3, 0], [3, -3, 0]] } } ],
  "lights": [ { "directional": { "toward": [0, 0, -1] } } ] }"#;

#[test]
fn the_trace_of_a_tiny_triangle_reads_as_before() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("tiny.json"), TINY).unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder.path())
        .args(["steps", "tiny.json", "--method", "gouraud", "--size", "3x3"])
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/gouraud-3x3.jsonl");
    let trace = String::from_utf8(output.stdout).unwrap();
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&golden, &trace).unwrap();
    }
    let old = fs::read_to_string(&golden).unwrap();
    for (line, (old, new)) in old.lines().zip(trace.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(trace.lines().count(), old.lines().count());
}
