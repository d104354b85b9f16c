//! The files of the window: those that are opened in it, and those that it saves.

use super::background::Work;
use super::opened::{self, Opened};
use super::session::Session;
use super::window_state::Window;
use super::{strings, take_away};
use std::mem;
use std::path::Path;
use std::time::Duration;

/// How long to wait before looking whether a file is made.
const LOOK_AGAIN: Duration = Duration::from_millis(30);

impl Window {
    /// Begins to save, load or copy what is wanted. What is made of the whole picture waits for it.
    pub(super) fn serve_wishes(&mut self, session: &mut Session, ctx: &egui::Context) {
        match session.awaits_picture() {
            true if !session.wanted.files.is_empty() => {
                self.notice = Some(session.localize(strings::TAKING).to_owned());
            }
            true => {}
            false => {
                for (what, ending) in mem::take(&mut session.wanted.files) {
                    self.taking.push(take_away::begin(session, what, ending));
                    ctx.request_repaint();
                }
            }
        }
        if mem::take(&mut session.wanted.progress) {
            self.notice = self.save_progress(session);
        }
        if mem::take(&mut session.wanted.copy) {
            self.notice = Some(match take_away::copied(session) {
                Ok(image) => {
                    ctx.copy_image(image);
                    session.localize(strings::COPIED).to_owned()
                }
                Err(why) => why.to_string(),
            });
        }
    }

    /// Saves what was made to be taken away, and says where.
    pub(super) fn save_what_is_made(&mut self, session: &Session, ctx: &egui::Context) {
        let Some(opened) = &self.opened else {
            return;
        };
        let language = session.look.language;
        let mut notice = None;
        self.taking.retain_mut(|taking| {
            let made = taking.work.take().pop();
            let has_ended = made.is_some() || taking.work.is_done();
            if has_ended {
                let saved = made.map(|made| take_away::save(&taking.name, made, opened.readers()));
                notice = Some(match saved {
                    Some(Ok(path)) => strings::TAKEN.format(language, &[("name", &path)]),
                    Some(Err(why)) => why,
                    None => strings::NOT_TAKEN.format(language, &[("name", &taking.name)]),
                });
            }
            !has_ended
        });
        self.notice = notice.or(self.notice.take());
        if !self.taking.is_empty() {
            ctx.request_repaint_after(LOOK_AGAIN);
        }
    }

    /// Opens a file in place of what is shown, and returns what there is to say of it. Errors: what is wrong with it.
    pub(super) fn open_file(
        &mut self,
        session: &mut Session,
        path: &Path,
    ) -> Result<Option<String>, String> {
        match &mut self.opened {
            Some(opened) => opened.open(session, path),
            None => Ok(None),
        }
    }

    /// Saves all progress in a file. Returns what there is to say of it.
    fn save_progress(&self, session: &mut Session) -> Option<String> {
        let readers = self.opened.as_ref()?.readers();
        let made = session.progress_file().map_err(|why| why.to_string());
        let saved = take_away::save("lightwalk-progress.json", made, readers);
        let language = session.look.language;
        let outcome = saved.map(|name| strings::TAKEN.format(language, &[("name", &name)]));
        Some(outcome.unwrap_or_else(|why| why))
    }

    /// Opens what is chosen in the system's dialog.
    pub(super) fn open_chosen(&mut self, session: &mut Session, ctx: &egui::Context) {
        let readers = self.opened.as_ref().map(Opened::readers);
        if let (Some(choice), Some(readers)) = (session.wanted.choice.take(), readers) {
            self.choosing = Some(Work::begin("dialog", move |worker| {
                worker.send((readers.choose)(choice));
            }));
        }
        let Some(mut choosing) = self.choosing.take() else {
            return;
        };
        for chosen in choosing.take() {
            self.notice = match chosen {
                Ok(Some(path)) => self.open_file(session, &path).unwrap_or_else(Some),
                Ok(None) => continue,
                Err(why) => Some(session.localize(why).to_owned()),
            };
        }
        if !choosing.is_done() {
            self.choosing = Some(choosing);
            ctx.request_repaint_after(LOOK_AGAIN);
        }
    }

    /// Opens what is dropped on the window, and reads again what was saved.
    pub(super) fn open_files(&mut self, session: &mut Session, ctx: &egui::Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().cloned());
        let outcome = match dropped {
            Some(file) => Some(self.open_file(session, file.path())),
            None => {
                let opened = self.opened.as_mut();
                let read = opened.and_then(|opened| opened.look(session));
                read.map(|read| read.map(|said| Some(session.localize(said).to_owned())))
            }
        };
        if let Some(outcome) = outcome {
            self.notice = outcome.unwrap_or_else(Some);
        }
        if self.opened.as_ref().is_some_and(Opened::has_file) {
            ctx.request_repaint_after(opened::LOOK);
        }
    }
}
