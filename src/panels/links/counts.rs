//! How many links there are at each level, and in place of how many pairs of patches.

use super::TEXT;
use crate::figure::{LEGEND_ROW, LEGEND_SAMPLE, Series, elided};
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Style};
use crate::record::Value;
use crate::replay::hierarchical::State;
use glam::Vec2;

const LEVEL: Message = Message("links-level");
const LEVELS_FROM: Message = Message("links-levels-from");
const LINKS: Message = Message("links-links");
const PAIRS: Message = Message("links-pairs");

/// Of the bar with the space around it.
const BAR: f32 = 14.0;
const GAP: f32 = 8.0;
/// The share of a panel's height that levels below the room may take.
const MOST_SHARE: f32 = 0.3;

pub struct Counts {
    /// By level, the coarsest first.
    levels: Vec<usize>,
    links: usize,
    /// Of patches, as recorded when the run began.
    pairs: Option<f64>,
}

impl Counts {
    pub fn of(input: &PanelInput, state: &State) -> Counts {
        let walk = input.run.walk();
        let pairs = match walk.fields(walk.position()).get("pairs") {
            Some(Value::Number(pairs)) => Some(pairs),
            _ => None,
        };
        let levels = state.links_by_level();
        Counts {
            links: levels.iter().sum(),
            levels,
            pairs,
        }
    }

    /// Below a room, in a panel like `place`.
    pub fn height(&self, place: Rect, language: Language) -> f32 {
        let most = (MOST_SHARE * place.height / LEGEND_ROW).floor().max(1.0);
        let columns = self.columns(place.width, language);
        let rows = self.levels.len().div_ceil(columns).min(most as usize);
        2.0 + LEGEND_ROW + BAR + LEGEND_ROW * rows as f32
    }

    fn columns(&self, width: f32, language: Language) -> usize {
        let style = Style::Body.size(TEXT);
        let texts = (0..self.levels.len()).map(|level| style.width(&self.level(level, language)));
        let column = LEGEND_SAMPLE + texts.fold(0.0, f32::max) + GAP;
        ((width / column).floor() as usize).max(1)
    }

    fn level(&self, level: usize, language: Language) -> String {
        self.written(LEVEL, level, self.levels[level], language)
    }

    fn written(&self, message: Message, level: usize, count: usize, language: Language) -> String {
        let count = language.number(count as f64);
        let arguments = [("level", &*level.to_string()), ("links", &count)];
        message.format(language, &arguments)
    }

    fn total(&self, language: Language) -> [String; 2] {
        let links = language.number(self.links as f64);
        let pairs = self.pairs.map(|pairs| language.number(pairs));
        [
            LINKS.format(language, &[("links", &links)]),
            pairs.map_or_else(String::new, |pairs| {
                PAIRS.format(language, &[("pairs", &pairs)])
            }),
        ]
    }

    pub fn in_words(&self, language: Language) -> String {
        let levels = (0..self.levels.len()).map(|level| self.level(level, language));
        let sentences = self.total(language).into_iter().chain(levels);
        sentences
            .filter(|sentence| !sentence.is_empty())
            .map(|sentence| format!("{sentence}."))
            .collect::<Vec<_>>()
            .join(" ")
    }

    /// The bar is as long as all pairs of patches would be.
    pub fn draw(&self, picture: &mut Picture, place: Rect, language: Language) {
        let style = Style::Body.size(TEXT);
        let [links, pairs] = self.total(language);
        let both = format!("{links}  ·  {pairs}");
        let lines = match style.width(&both) <= place.width {
            true => vec![both],
            false if place.height < 2.0 * LEGEND_ROW + BAR + LEGEND_ROW => vec![links],
            false => vec![links, pairs],
        };
        let mut top = place.y + 2.0;
        for line in lines {
            let row = Rect::new(place.x, top, place.width, LEGEND_ROW);
            elided(picture, row, &line, Style::LabelBold.size(TEXT));
            top += LEGEND_ROW;
        }
        self.bar(picture, Rect::new(place.x, top, place.width, BAR));
        top += BAR;
        let columns = self.columns(place.width, language);
        let rows = ((place.bottom() - top + 0.5) / LEGEND_ROW).floor().max(0.0) as usize;
        let room = columns * rows;
        let width = place.width / columns as f32;
        for (entry, level) in (0..self.levels.len()).take(room).enumerate() {
            let (column, row) = (entry % columns, entry / columns);
            let corner = Vec2::new(
                place.x + width * column as f32,
                top + LEGEND_ROW * row as f32,
            );
            let is_last = entry + 1 == room && room < self.levels.len();
            let text = match is_last {
                true => {
                    let others = self.levels[level..].iter().sum();
                    self.written(LEVELS_FROM, level, others, language)
                }
                false => self.level(level, language),
            };
            let middle = corner + Vec2::new(0.0, 0.5 * LEGEND_ROW);
            let end = middle + Vec2::new(LEGEND_SAMPLE - 4.0, 0.0);
            let series = Series::of(level);
            picture.line(middle, end, series.stroke);
            series.mark.draw(picture, end, 3.0, series.ink);
            let text_at = Rect::new(
                corner.x + LEGEND_SAMPLE + 3.0,
                corner.y,
                width - LEGEND_SAMPLE - 3.0,
                LEGEND_ROW,
            );
            elided(picture, text_at, &text, style);
        }
    }

    fn bar(&self, picture: &mut Picture, place: Rect) {
        let whole = Rect::between((place.x, place.y + 2.0), place.max() - Vec2::new(1.0, 4.0));
        picture.rect(whole, Ink::Faint.fill().outlined(Ink::Rule.stroke(1.0)));
        let Some(pairs) = self.pairs.filter(|pairs| *pairs > 0.0) else {
            return;
        };
        let mut x = whole.x;
        for (level, &count) in self.levels.iter().enumerate() {
            let width = (count as f64 / pairs) as f32 * whole.width;
            let width = width.min(whole.right() - x);
            let part = Rect::new(x, whole.y, width, whole.height);
            picture.rect(part, Series::of(level).ink.fill());
            x += width;
        }
    }
}
