//! The row of the system that is gathered, written out where it is short.

use super::Layout;
use super::draw::{LINE, SMALL, small};
use crate::algorithms::radiosity::SolverEvent;
use crate::picture::{Ink, Picture, Rect, Style, Tag};

/// The most patches whose row of the system is written out.
const MOST_WRITTEN: usize = 8;
/// Height of what is written, with the line above it.
pub const HEIGHT: f32 = 2.0 * LINE + 4.0;

impl Layout<'_> {
    /// ρ_i and E_i of the patch that gathers, where its row of the system is short enough to be written.
    pub fn written(&self) -> Option<(f64, f64)> {
        match self.hand?.recorded {
            SolverEvent::Gathering { rho_i, e_i, .. } if self.n <= MOST_WRITTEN => {
                Some((rho_i, e_i))
            }
            _ => None,
        }
    }
}

/// The row of I − ρF, and E_i.
pub fn draw(picture: &mut Picture, layout: &Layout, rho: f64, emission: f64, place: Rect) {
    let Some(hand) = layout.hand else { return };
    let head = 40.0;
    let width = (place.width - head) / (layout.n + 1) as f32;
    let column = hand.entry.map(|(_, column, _)| column);
    let cell = |at: usize, line: usize| {
        let x = place.x + head + at as f32 * width;
        Rect::new(x, place.y + line as f32 * LINE, width, LINE)
    };
    picture.line(
        (place.x, place.y - 2.0),
        (place.right(), place.y - 2.0),
        Ink::Rule.stroke(1.0),
    );
    let first = Rect {
        width: head,
        height: LINE,
        ..place
    };
    picture.text_in(first, "j", small());
    let second = first.shifted([0.0, LINE].into());
    picture.text_in(second, format!("i = {}", hand.i), small());
    for (j, f) in layout.row(hand.i).iter().enumerate() {
        let diagonal = j == hand.i;
        let symbol = match diagonal {
            _ if width < 84.0 => format!("{j}"),
            true => "1 − ρ_i F_i_i".to_string(),
            false => format!("−ρ_i F_i_{j}"),
        };
        let value = f64::from(u8::from(diagonal)) - rho * f;
        let (style, ink) = if column == Some(j) {
            (Style::LabelBold, Ink::This)
        } else {
            (Style::Label, Ink::Text)
        };
        picture.tagged(Tag::FormFactor { i: hand.i, j }, |picture| {
            picture.text_in(cell(j, 0), symbol, small().end());
            picture.text_in(
                cell(j, 1),
                layout.known(value, |language, value| language.fixed(value, 3)),
                style.size(SMALL).ink(ink).end(),
            );
        });
    }
    let last = cell(layout.n, 0);
    picture.line(
        (last.x + 5.0, place.y),
        (last.x + 5.0, place.bottom()),
        Ink::Muted.stroke(1.0),
    );
    picture.text_in(last, "E_i", small().end());
    let set = Style::Label.size(SMALL).end();
    picture.text_in(cell(layout.n, 1), layout.language.fixed(emission, 3), set);
}
