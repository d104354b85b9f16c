//! What one takes away of what is shown: made beside the window, a part at a time, then saved. A page saves it as a download, the window
//! in the folder where it was started.

use super::background::{Work, Worker};
use super::opened::Readers;
use super::session::{Session, Source};
use crate::export::{Making, TakeAway};
use crate::picture::{RasterError, rasterize};
use egui::{Color32, ColorImage};
use std::mem;
use std::path::PathBuf;
use web_time::{Duration, Instant};

/// How long is worked on a file before it is looked whether it is still wanted; in a page, before the next frame.
const SLICE: Duration = Duration::from_millis(8);

/// Pixels to a point of a picture that is copied.
const SCALE: f32 = 2.0;

/// What is in a file, before it is written, or why there is none.
type NewFile = Result<Vec<u8>, String>;

/// A file in the making. Dropped, its work ends.
pub struct Taking {
    /// Of the file.
    pub name: String,
    pub work: Work<NewFile>,
}

/// Begins to make a file of what is shown. Its work can be cancelled between two parts.
pub fn begin(session: &Session, what: TakeAway, ending: &'static str) -> Taking {
    let mut state = State::Prepared(Box::new(session.source(what)));
    let mut bytes = Vec::new();
    let step = move |worker: &Worker<NewFile>| {
        let stepped = state.go_on(what, ending, &mut bytes);
        match stepped {
            Ok(Some((done, all))) => worker.progress(done, all).is_ok(),
            Ok(None) => {
                worker.send(Ok(mem::take(&mut bytes)));
                false
            }
            Err(why) => {
                worker.send(Err(why));
                false
            }
        }
    };
    Taking {
        name: session.file_name(what, ending),
        work: Work::begin_in_steps(what.name(), step),
    }
}

enum State {
    Prepared(Box<Source>),
    Making(Making<'static>),
    Ended,
}

impl State {
    /// Works for a while. Returns how many parts are done of how many, or nothing at the end.
    fn go_on(
        &mut self,
        what: TakeAway,
        ending: &str,
        bytes: &mut Vec<u8>,
    ) -> Result<Option<(usize, usize)>, String> {
        *self = match mem::replace(self, State::Ended) {
            State::Prepared(source) => {
                let (shown, wish) = source.run();
                State::Making(what.make(ending, shown, wish)?)
            }
            state => state,
        };
        let State::Making(making) = self else {
            return Ok(None);
        };
        let start = Instant::now();
        while start.elapsed() < SLICE {
            let went_on = making.write_next(bytes);
            if !went_on.map_err(|error| error.to_string())? {
                return Ok(None);
            }
        }
        Ok(Some(making.progress()))
    }
}

/// Writes it beside what is there. Returns the name under which it was saved.
pub fn save(name: &str, made: NewFile, readers: Readers) -> Result<String, String> {
    let bytes = made?;
    let path = free(name);
    (readers.write)(&path, &bytes)?;
    Ok(path.display().to_string())
}

/// A path in the folder where the program was started that nothing has yet: numbered, where the name is taken.
fn free(name: &str) -> PathBuf {
    let folder = std::env::current_dir().unwrap_or_default();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let numbered = |number: usize| folder.join(format!("{stem}-{number}.{ending}"));
    let first = folder.join(name);
    match first.exists() {
        false => first,
        true => {
            let mut others = (2..).map(numbered);
            others.find(|path| !path.exists()).unwrap_or(first)
        }
    }
}

/// The key panel as pixels, for the clipboard.
pub fn copied(session: &Session) -> Result<ColorImage, RasterError> {
    let (_, picture) = session.seen();
    let pixmap = rasterize(&picture, session.look.theme, SCALE)?;
    let size = [pixmap.width() as usize, pixmap.height() as usize];
    let pixels = pixmap.pixels().iter();
    // It is opaque: the ground is part of the picture.
    let colors = pixels.map(|pixel| Color32::from_rgb(pixel.red(), pixel.green(), pixel.blue()));
    Ok(ColorImage::new(size, colors.collect()))
}
