//! The list of what can be taken away, which the command line, the window and the page share; and how each is made of what is shown.

use super::ExportedLesson;
use super::animation::{Film, animation};
use super::deck::deck;
use super::handout::handout;
use super::making::Making;
use super::picture::{panel, whole_picture};
use super::radiosity_table::{radiosities, system};
use super::steps::steps_in_lines;
use super::steps_table::steps_in_table;
use super::tables::Table;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::language::Message;
use crate::methods::Method;
use crate::panels::Panel;
use crate::picture::{Picture, Theme};
use crate::render::matrix;
use crate::replay::{Query, Walk, query};
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::thread::available_parallelism;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TakeAway {
    /// On paper.
    Handout,
    /// For reveal.js.
    Slides,
    /// What is explained, as an animation.
    Explanations,
    /// Radiosity converging, as an animation.
    Convergence,
    /// The panel that is looked at.
    Panel,
    /// The whole picture of the scene.
    Picture,
    Steps,
    /// I − ρF.
    System,
    /// B.
    Radiosities,
}

/// What is wanted of what is shown.
pub struct Wish {
    /// In place of those that are explained.
    pub steps: Option<Vec<usize>>,
    /// The panel that is looked at, and how it looks.
    pub panel: Panel,
    pub seen: Picture,
    pub theme: Theme,
}

/// Pixels of an animation, and points of a panel.
pub const SIZE: [u32; 2] = [960, 600];
/// Pixels to a point of a panel.
const SCALE: f32 = 2.0;
/// Of radiosity converging so many frames are shown: of more iterations, some evenly spaced.
const MOST_FRAMES: usize = 300;
/// The most steps that are made into one file in memory: as JSON they take about 400 MB.
const MOST_STEPS: usize = 1 << 20;
/// The most numbers: 128 MB.
const MOST_NUMBERS: usize = 1 << 24;

impl TakeAway {
    pub const ALL: [TakeAway; 9] = [
        TakeAway::Handout,
        TakeAway::Slides,
        TakeAway::Explanations,
        TakeAway::Convergence,
        TakeAway::Panel,
        TakeAway::Picture,
        TakeAway::Steps,
        TakeAway::Radiosities,
        TakeAway::System,
    ];

    /// In the names of files.
    pub fn name(self) -> &'static str {
        match self {
            TakeAway::Handout => "handout",
            TakeAway::Slides => "slides",
            TakeAway::Explanations => "explanations",
            TakeAway::Convergence => "convergence",
            TakeAway::Panel => "panel",
            TakeAway::Picture => "picture",
            TakeAway::Steps => "steps",
            TakeAway::System => "system",
            TakeAway::Radiosities => "radiosity",
        }
    }

    pub fn title(self) -> Message {
        Message(match self {
            TakeAway::Handout => "export-handout",
            TakeAway::Slides => "export-slides",
            TakeAway::Explanations => "export-explanations",
            TakeAway::Convergence => "export-convergence",
            TakeAway::Panel => "export-panel",
            TakeAway::Picture => "export-picture",
            TakeAway::Steps => "export-steps",
            TakeAway::System => "export-system",
            TakeAway::Radiosities => "export-radiosities",
        })
    }

    /// What the names of its files may end in, which says how they are written.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            TakeAway::Handout | TakeAway::Slides => &["html"],
            TakeAway::Explanations | TakeAway::Convergence => &["png", "gif"],
            TakeAway::Panel => &["png", "svg"],
            TakeAway::Picture => &["png", "pfm"],
            TakeAway::Steps => &["jsonl", "csv"],
            TakeAway::System | TakeAway::Radiosities => &["csv", "npy"],
        }
    }

    /// Whether it has words, so that there is one in each language.
    pub fn has_words(self) -> bool {
        matches!(
            self,
            TakeAway::Handout | TakeAway::Slides | TakeAway::Explanations
        )
    }

    /// Why there is none by this method, if there is none.
    pub fn is_missing(self, method: Method) -> Option<Message> {
        let of_radiosity = matches!(
            self,
            TakeAway::Convergence | TakeAway::System | TakeAway::Radiosities
        );
        let is_missing = of_radiosity && method != Method::Radiosity;
        is_missing.then_some(Message("export-of-radiosity"))
    }

    /// What is recorded for it, where `own` is the part that the lesson explains, and `shown` the one that is looked at.
    pub fn focus(self, own: Focus, shown: Focus, wish: &Wish) -> Focus {
        match self {
            TakeAway::Convergence => Focus::Frame,
            _ if self.has_words() && wish.steps.is_none() => own,
            _ => shown,
        }
    }

    /// Begins to make it, with that ending. Errors: why there is none, in the language of what is shown.
    pub fn make(
        self,
        ending: &str,
        shown: ExportedLesson,
        wish: Wish,
    ) -> Result<Making<'static>, String> {
        let language = shown.language;
        let why = |message: &'static str| Message(message).text(language).to_owned();
        let table = Table::with_ending(ending);
        let film = Film {
            panel: None,
            size: SIZE,
            theme: wish.theme,
            seconds: None,
            explains: true,
        };
        let walk = shown.open.run.walk();
        let made = match self {
            TakeAway::Handout => {
                let steps = explained(&shown, wish)?;
                Ok(handout(shown.asking(), steps, true))
            }
            TakeAway::Slides => {
                let steps = explained(&shown, wish)?;
                Ok(deck(shown.asking(), steps, film.theme))
            }
            TakeAway::Explanations => {
                let steps = explained(&shown, wish)?;
                animation(shown, steps, film, ending)
            }
            TakeAway::Convergence => {
                let film = Film {
                    panel: Some(wish.panel),
                    explains: false,
                    ..film
                };
                let steps = evenly(&iterations(walk), MOST_FRAMES);
                animation(shown, steps, film, ending)
            }
            TakeAway::Panel => {
                let title = wish.panel.title().text(language);
                panel(&wish.seen, title, wish.theme, ending, SCALE)
            }
            TakeAway::Picture => Ok(whole_picture(shown.picture(), ending, 1.0)),
            TakeAway::Steps if walk.truncated() || walk.len() > MOST_STEPS => {
                return Err(why("export-too-many-steps"));
            }
            TakeAway::Steps => Ok(match table {
                Some(_) => steps_in_table(shown.open.run),
                None => steps_in_lines(shown.open.run),
            }),
            TakeAway::System => {
                let (enclosure, matrix) = exchanged(&shown)?;
                if 3 * matrix.len() > MOST_NUMBERS {
                    return Err(why("export-too-many-patches"));
                }
                let table = table.unwrap_or(Table::Csv);
                Ok(system(table, enclosure, matrix.to_vec()))
            }
            TakeAway::Radiosities => {
                let (enclosure, matrix) = exchanged(&shown)?;
                let light = enclosure.light(matrix).map_err(|why| why.to_string())?;
                let scene = &shown.open.setup.prepared.scene;
                let table = table.unwrap_or(Table::Csv);
                Ok(radiosities(table, scene, enclosure, light))
            }
        };
        made.map_err(|error| error.to_string())
    }
}

/// The steps that were chosen, or those that are explained.
fn explained(shown: &ExportedLesson, wish: Wish) -> Result<Vec<usize>, String> {
    let steps = wish.steps.unwrap_or_else(|| shown.narrated().to_vec());
    match steps.is_empty() {
        true => {
            let why = Message("export-nothing-explained");
            Err(why.text(shown.language).to_owned())
        }
        false => Ok(steps),
    }
}

/// The beginnings of the iterations, or shots.
fn iterations(walk: &dyn Walk) -> Vec<usize> {
    let iteration = Query {
        kind: Some("Iteration".into()),
        conditions: Vec::new(),
    };
    query::matches(walk, &iteration, 0..walk.len()).collect()
}

/// The first, the last, and of those between as many as there may be.
fn evenly(steps: &[usize], most: usize) -> Vec<usize> {
    let count = steps.len().min(most);
    let last = steps.len().saturating_sub(1);
    let at = |number: usize| steps[number * last / (count - 1).max(1)];
    (0..count).map(at).collect()
}

/// The room, and its matrix of form factors.
fn exchanged(shown: &ExportedLesson) -> Result<(&Enclosure, &[f64]), String> {
    let enclosure = shown.open.setup.enclosure();
    let enclosure = enclosure.map_err(|why| why.to_string())?;
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let Ok(matrix) = matrix(enclosure, threads, &|_, _| Ok::<(), Infallible>(()));
    Ok((enclosure, matrix))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_steps_some_are_kept_evenly_with_the_first_and_the_last() {
        let steps: Vec<usize> = (100..201).collect();
        assert_eq!(evenly(&steps, 5), [100, 125, 150, 175, 200]);
        assert_eq!(evenly(&steps, 200), steps);
        assert_eq!(evenly(&[7], 300), [7]);
        assert!(evenly(&[], 300).is_empty());
    }
}
