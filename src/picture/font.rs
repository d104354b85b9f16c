//! The bundled fonts: which glyph shows a character, and its coverage mask at a size, kept for the next time.

use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use tiny_skia::{FillRule, Mask, Path, PathBuilder, Transform};
use ttf_parser::{GlyphId, OutlineBuilder};

/// A bundled font.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Face {
    Sans,
    Bold,
    Mono,
    MonoBold,
    SerifItalic,
}

/// In the order of [`Face`]. Of DejaVu 2.37 they have what is written in Latin, Greek and Cyrillic letters, and the signs of
/// mathematics, as the page sends them over the wire: `pyftsubset FILE --no-hinting --layout-features= --notdef-outline
/// --unicodes=U+0-4FF,U+1D00-1DBF,U+1E00-1EFF,U+2000-23FF,U+2500-27EF,U+2A00-2AFF,U+2C60-2C7F,U+FFFD`.
const FILES: [&[u8]; 5] = [
    include_bytes!("fonts/DejaVuSans.ttf"),
    include_bytes!("fonts/DejaVuSans-Bold.ttf"),
    include_bytes!("fonts/DejaVuSansMono.ttf"),
    include_bytes!("fonts/DejaVuSansMono-Bold.ttf"),
    include_bytes!("fonts/DejaVuSerif-Italic.ttf"),
];

static FACES: LazyLock<[ttf_parser::Face<'static>; 5]> = LazyLock::new(|| {
    FILES.map(|file| ttf_parser::Face::parse(file, 0).expect("the bundled fonts are sound"))
});

/// Memory for coverage masks, in bytes; when it is spent, all are dropped and made anew as needed.
const MASK_MEMORY: usize = 16 << 20;
/// Glyphs start at quarters of a pixel, so that spacing stays even without hinting.
pub(super) const OFFSETS: i32 = 4;
/// Sizes are distinguished to an eighth of a pixel.
const SIZES_A_PIXEL: f32 = 8.0;
/// Larger text than this is drawn at this size.
const LARGEST_SIZE: f32 = 1024.0;

impl Face {
    /// The font file, as it is bundled.
    pub(super) fn file(self) -> &'static [u8] {
        FILES[self as usize]
    }

    fn parsed(self) -> &'static ttf_parser::Face<'static> {
        &FACES[self as usize]
    }

    /// Height above and depth below the baseline that a line of this face needs, in ems; both positive.
    pub(super) fn extent(self) -> (f32, f32) {
        let face = self.parsed();
        let em = f32::from(face.units_per_em());
        (
            f32::from(face.ascender()) / em,
            -f32::from(face.descender()) / em,
        )
    }

    /// Height of a capital letter, in ems.
    pub(super) fn cap_height(self) -> f32 {
        let face = self.parsed();
        let em = f32::from(face.units_per_em());
        face.capital_height()
            .map_or(0.73, |height| f32::from(height) / em)
    }
}

/// A character's glyph: the face that has it, and how far it moves the pen, in ems.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Glyph {
    pub face: Face,
    pub id: GlyphId,
    pub advance: f32,
}

/// The coverage of a glyph or of any shape, 0 to 255, row by row; `left` and `top` lead from the pen's pixel on the baseline
/// to its first pixel.
#[derive(Default)]
pub(super) struct Coverage {
    pub left: i32,
    pub top: i32,
    pub width: usize,
    pub bytes: Box<[u8]>,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct MaskKey {
    face: Face,
    id: GlyphId,
    size: u16,
    offset: u8,
}

/// What is known of the fonts so far.
pub(super) struct Glyphs {
    /// Those of ASCII, by face: most text is, and much of it is measured again and again.
    ascii: [[Option<Glyph>; 128]; FILES.len()],
    by_character: HashMap<(Face, char), Glyph>,
    masks: HashMap<MaskKey, Coverage>,
    mask_memory: usize,
}

static GLYPHS: LazyLock<Mutex<Glyphs>> = LazyLock::new(Mutex::default);

/// The glyphs of this process. It only ever holds what can be computed again, so a panic elsewhere does not spoil it.
pub(super) fn glyphs() -> MutexGuard<'static, Glyphs> {
    GLYPHS.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Default for Glyphs {
    fn default() -> Self {
        Glyphs {
            ascii: [[None; 128]; FILES.len()],
            by_character: HashMap::new(),
            masks: HashMap::new(),
            mask_memory: 0,
        }
    }
}

impl Glyphs {
    /// As [`first_with`], of what was found before.
    pub(super) fn find(&mut self, face: Face, character: char) -> Glyph {
        match self.ascii[face as usize].get_mut(character as usize) {
            Some(known) => *known.get_or_insert_with(|| first_with(face, character)),
            None => *self
                .by_character
                .entry((face, character))
                .or_insert_with(|| first_with(face, character)),
        }
    }

    /// The coverage of a glyph `size` pixels to the em, its pen `offset` quarters of a pixel right of a pixel's edge.
    pub(super) fn coverage(&mut self, glyph: Glyph, size: f32, offset: i32) -> &Coverage {
        let eighths = (size.clamp(0.0, LARGEST_SIZE) * SIZES_A_PIXEL).round();
        let key = MaskKey {
            face: glyph.face,
            id: glyph.id,
            size: eighths as u16,
            offset: offset as u8,
        };
        if !self.masks.contains_key(&key) {
            let mask = rasterize(glyph, eighths / SIZES_A_PIXEL, offset);
            self.mask_memory += mask.bytes.len() + size_of::<(MaskKey, Coverage)>();
            if self.mask_memory > MASK_MEMORY {
                self.masks.clear();
                self.mask_memory = mask.bytes.len();
            }
            self.masks.insert(key, mask);
        }
        &self.masks[&key]
    }
}

/// The glyph of a character in `face`, or in the first face that has one, or else the empty box of `face`.
fn first_with(face: Face, character: char) -> Glyph {
    let (face, id) = face_with(face, character).unwrap_or((face, GlyphId(0)));
    let parsed = face.parsed();
    let advance = parsed.glyph_hor_advance(id).unwrap_or(0);
    Glyph {
        face,
        id,
        advance: f32::from(advance) / f32::from(parsed.units_per_em()),
    }
}

/// The face, `first` if it can, that has a glyph for `character`. Small digits are too wide apart in cells of one width: there
/// they come from the proportional faces.
fn face_with(first: Face, character: char) -> Option<(Face, GlyphId)> {
    use Face::*;
    let small = matches!(character, '¹' | '²' | '³' | '⁰'..='ₜ');
    let first = match first {
        Mono if small => Sans,
        MonoBold if small => Bold,
        face => face,
    };
    [first, Sans, Bold, Mono, MonoBold, SerifItalic]
        .into_iter()
        .find_map(|face| Some((face, face.parsed().glyph_index(character)?)))
}

/// Draws the outline several times too large and averages: finer steps of coverage than the rasteriser's own.
fn rasterize(glyph: Glyph, size: f32, offset: i32) -> Coverage {
    draw_outline(glyph, size, offset).unwrap_or_default()
}

/// None where there is nothing to draw, as in a space.
fn draw_outline(glyph: Glyph, size: f32, offset: i32) -> Option<Coverage> {
    let face = glyph.face.parsed();
    let path = outline(face, glyph.id)?;
    let zoom = size / f32::from(face.units_per_em());
    let shift = offset as f32 / OFFSETS as f32;
    let bounds = path.bounds();
    let left = (bounds.left() * zoom + shift).floor();
    let top = (-bounds.bottom() * zoom).floor();
    let width = (bounds.right() * zoom + shift).ceil() - left;
    let height = (-bounds.top() * zoom).ceil() - top;
    let (width, height) = (width as usize, height as usize);

    let finer = if size <= 64.0 { 4 } else { 1 };
    let mut fine = Mask::new((width * finer) as u32, (height * finer) as u32)?;
    // Fonts have y upward, pictures downward.
    let scale = zoom * finer as f32;
    let to_mask = Transform::from_row(
        scale,
        0.0,
        0.0,
        -scale,
        (shift - left) * finer as f32,
        -top * finer as f32,
    );
    fine.fill_path(&path, FillRule::Winding, true, to_mask);

    let samples = finer * finer;
    let mut bytes = vec![0; width * height];
    for (i, byte) in bytes.iter_mut().enumerate() {
        let (x, y) = (i % width * finer, i / width * finer);
        let sum: usize = (y..y + finer)
            .flat_map(|y| &fine.data()[y * width * finer + x..][..finer])
            .map(|&coverage| usize::from(coverage))
            .sum();
        *byte = ((sum + samples / 2) / samples) as u8;
    }
    Some(Coverage {
        left: left as i32,
        top: top as i32,
        width,
        bytes: bytes.into_boxed_slice(),
    })
}

fn outline(face: &ttf_parser::Face, id: GlyphId) -> Option<Path> {
    let mut outline = Outline(PathBuilder::new());
    face.outline_glyph(id, &mut outline)?;
    outline.0.finish()
}

/// A glyph's outline as a path, in font units.
struct Outline(PathBuilder);

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.0.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_symbol_that_the_lessons_need_has_a_glyph() {
        let symbols = "→←↑↓‖∇⟨⟩ᵢⱼ₁₂₄₅ₚΔηρθ≤≥−·×✓✗▶◀⁻⁰¹²³⁴⁵⁶⁷⁸⁹√∞Σ∫…⌊⌋";
        for character in symbols.chars() {
            for face in [Face::Sans, Face::Mono, Face::SerifItalic] {
                let glyph = glyphs().find(face, character);
                assert_ne!(glyph.id, GlyphId(0), "{character}");
            }
        }
        // The serif has no check mark, and borrows it.
        assert_eq!(glyphs().find(Face::SerifItalic, '✓').face, Face::Sans);
        assert_eq!(glyphs().find(Face::Sans, '\u{e000}').id, GlyphId(0));
    }

    #[test]
    fn coverage_adds_up_to_the_area_of_the_outline() {
        // A full block in DejaVu Sans Mono fills its cell: 1233 × (1556 + 483) units of 2048.
        let mut glyphs = glyphs();
        let block = glyphs.find(Face::Mono, '█');
        let size = 40.0;
        let mask = glyphs.coverage(block, size, 0);
        let area: f32 = mask.bytes.iter().map(|&byte| f32::from(byte) / 255.0).sum();
        let bounds = outline(Face::Mono.parsed(), block.id).unwrap().bounds();
        let exact = bounds.width() * bounds.height() * (size / 2048.0).powi(2);
        assert!((area - exact).abs() < 0.01 * exact, "{area} {exact}");
    }

    #[test]
    fn the_mask_memory_is_bounded() {
        let mut glyphs = Glyphs::default();
        let letter = glyphs.find(Face::Bold, 'W');
        for eighths in 0..1200 {
            glyphs.coverage(letter, eighths as f32 / 8.0, eighths % OFFSETS);
        }
        let held: usize = glyphs.masks.values().map(|mask| mask.bytes.len()).sum();
        assert!(held <= MASK_MEMORY && !glyphs.masks.is_empty());
    }
}
