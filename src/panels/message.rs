//! What a panel says instead of a picture.

use super::strings::{Language, Words};
use crate::picture::{Ink, Picture, Style, wrap};
use glam::Vec2;

/// Where nothing was recorded.
pub const NO_STEPS: Words = Words::new(
    "Nothing is recorded here: no polygon lies in the focus. Click the image to look at another place.",
    "Tidak ada yang direkam di sini: tidak ada poligon dalam fokus. Klik gambar untuk melihat tempat lain.",
);

/// Where rays are followed, and no polygons converted.
pub const NO_POLYGONS: Words = Words::new(
    "This method follows rays and converts no polygons. Look at the ray tree.",
    "Metode ini mengikuti sinar dan tidak mengolah poligon. Lihatlah pohon sinar.",
);

/// Where polygons are converted, and no rays followed.
pub const NO_RAYS: Words = Words::new(
    "This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing.",
    "Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran tentang ray casting atau ray tracing.",
);

/// Where no light is exchanged between patches.
pub const NO_PATCHES: Words = Words::new(
    "This run exchanges no light between patches. Open a lesson on radiosity.",
    "Proses ini tidak mempertukarkan cahaya antar-patch. Buka pelajaran tentang radiositas.",
);

/// Where no other method is beside the run's, or not yet.
pub const NOT_COMPARED: Words = Words::new(
    "The pictures to be compared are being made, or this lesson compares none.",
    "Gambar-gambar yang dibandingkan sedang dibuat, atau pelajaran ini tidak membandingkan apa pun.",
);

/// A picture of one friendly sentence, centred.
pub fn message(strings: Words, language: Language, size: Vec2) -> Picture {
    const LINE: f32 = 18.0;
    let text = strings.in_language(language);
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = text.to_string();
    let style = Style::Body.size(13.0).ink(Ink::Muted).middle();
    let lines = wrap(text, style.style, style.size, (size.x - 32.0).min(420.0));
    let top = 0.5 * (size.y - LINE * lines.len() as f32);
    for (i, line) in lines.into_iter().enumerate() {
        let y = top + LINE * (i as f32 + 0.5) + style.baseline_below_middle();
        picture.text((0.5 * size.x, y), line, style);
    }
    picture
}
