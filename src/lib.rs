//! Lightwalk: walk through classic rendering, step by step, forward and back.
//!
//! Each algorithm is written once, in the textbook's words, generic over a [`record::Recorder`]. Unrecorded, the calls compile
//! away; recorded, the same code keeps every step. What is shown is what ran. A *focus* (a pixel, a scan line, a polygon, the
//! frame) says what is recorded. The state at a step is the fold of the events up to it, so going back is seeking. A panel
//! turns that state into a display list, which is the same on the screen, in files and in tests.
//!
//! # Map
//!
//! A floor may use only what stands above it; `tests/floors` fails on an import down the list.
//!
//! | floor | what lives there |
//! | --- | --- |
//! | [`color`], [`numeric`] | linear RGB and the one place of clamping and sRGB; kernels that several algorithms share: interpolation, forward differences, Taylor series, roots, elimination |
//! | [`language`] | the languages, a catalogue of all text in each, and how numbers are written |
//! | [`picture`] | display lists with tags, text, formulas, themes, and their rasteriser; uses [`color`] alone |
//! | [`figure`] | what panels and studies are made of: scales, plots, legends, colour strips, cells, arrows, labels, views; knows no algorithm |
//! | [`record`] | recorders of an algorithm's events, and the tree of scopes over them; knows no algorithm |
//! | [`scene`] | scene files and their checks, camera, lights, materials, meshes, division into polygons; where rays meet them ([`scene::primitives`]), what a scene needs, and the patches of radiosity ([`scene::patches`]) |
//! | [`algorithms`] | one file an algorithm: illumination, scan conversion, wireframe, flat, Gouraud, Phong, Fast Phong, textures, ray casting, ray tracing; [`algorithms::form_factor`], [`algorithms::radiosity`] and [`algorithms::hierarchical`] with a file a method, solver or procedure |
//! | [`vocabulary`] | what each kind of event means, declared once: values with their symbols, pseudocode line, sentence, formulas |
//! | [`methods`] | a method as one value: its name, its panels, what it needs, how it is drawn, recorded and counted; and a scene set up for all of them, with their settings |
//! | [`render`] | a whole frame or a whole matrix of form factors, unrecorded, on all cores; frames all at once or coarse first; what panels show beside the steps of a run ([`render::Finished`]) |
//! | [`replay`] | timelines with checkpoints, walking, searching; the state of each algorithm at a step |
//! | [`panels`] | one file a panel: how it lays out a run at its step; values come in computed, which `tests/floors` checks |
//! | [`lesson`] | lesson files, tied to the steps of their run |
//! | [`study`] | error against run time, how work grows, and how the algorithms cope with stiff, extreme and wrong input; pictures, traces and matrices of other programs, and the mistakes that explain them |
//! | [`export`] | what one takes away of a lesson: its explanations as a handout, as slides, as pictures of an animation |
//! | `app` | the window (feature `gui`) |
//! | [`commands`] | the command line, one file a command |
//!
//! Only `app` knows the window, and only `app` and [`commands`] touch files.
//!
//! # The cost of recording
//!
//! Measured on a virtual machine with 2 cores of an x86-64 server (AMD EPYC), rustc 1.95, November 2026. Absolute
//! times on such a machine vary by a factor of two from run to run; ratios are of alternating runs.
//!
//! | what | goal | measured |
//! | --- | --- | --- |
//! | Gouraud frame of the teapot, 640×480: unrecorded body against the same body without recorder calls, time | 1.00 | 1.04 (quartiles 0.98 to 1.09: within noise) |
//! | the same, instructions (callgrind) | 1.00 | 1.03: an edge carries its ends, which only an event needs |
//! | recording an event of 32 / 64 bytes, in the memory of an earlier recording | 2 ns | 2.2 / 3.5 ns; 1.6 / 3.4 ns in a plain vector |
//! | recorded frame against unrecorded frame: 1.05 million events of 64 bytes in 10.8 ms against 2.9 ms | 1.3 | 3.8 |
//! | a new focus (pixel, scan line, polygon), recorded and folded | 50 ms | 0.6 to 0.9 ms |
//! | seek among 10 million events, 640×480 canvas | 99 % under 1 ms | median 0.10 ms, 99th percentile 0.21 ms, 100 % under 1 ms |
//!
//! `cargo bench --no-default-features --bench recorded_frames` and `--bench recording` print them. The recorded frame misses its
//! goal: a pixel takes 7 ns to draw and records four events of 8 ns each. That is why a part of the frame is recorded, and a whole
//! frame on demand. The memory of a recording that is dropped goes to the next one with events of the same type.
//!
//! # Speed
//!
//! On the same machine, one thread unless said otherwise; others in the same run.
//!
//! | what | goal | measured |
//! | --- | --- | --- |
//! | nearest hits in f64, mesh of 70 thousand triangles: primary, incoherent rays | `obvhs`'s best layout in f32 | 5.3 and 2.9 million a second: 1.21 and 0.99 of it |
//! | the same, 1 million triangles | – | 2.7 and 1.0 million a second: 1.02 and about 0.8 of it |
//! | a lesson's scene at 640×480, 2 threads: first coarse picture, whole picture | 100 ms, – | 2 to 7 ms, 81 to 343 ms |
//! | form factors of a cube of 384 patches, largest error 8.2e-4 | 20 million entries a second | 21 million |
//! | radiosity of 6144 patches, ρ = 0.5, to 1e-6, against LU | 10 times as fast | 16 times |
//! | any of a million exchanges of light | 20 ms | 4 ms at most |
//! | the Cornell box, 3539 patches, 2 threads | seconds | 7 s |
//!
//! `cargo bench --no-default-features --features parallel` with `--bench rays`, `lesson_frames`, `form_factors` or `radiosity`.

#[macro_use]
mod named;

#[macro_use]
pub mod algorithms;
#[cfg(feature = "gui")]
pub mod app;
pub mod color;
#[cfg(not(target_arch = "wasm32"))]
pub mod commands;
pub mod export;
pub mod figure;
pub mod language;
pub mod lesson;
pub mod methods;
pub mod numeric;
pub mod panels;
pub mod picture;
pub mod record;
pub mod render;
pub mod replay;
pub mod scene;
pub mod study;
pub mod vocabulary;
