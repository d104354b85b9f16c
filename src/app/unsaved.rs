//! Asks before the window closes over scenes and lessons with changes that are not saved.

use super::document::Documents;
use super::session::Session;
use super::window_state::{Closing, Window};
use super::{strings, style};
use egui::{Context, Id, Modal, ViewportCommand};

/// Keeps the window open while something is not saved, and asks what to do about it.
pub fn ask(session: &Session, window: &mut Window, ctx: &Context) {
    if window.unsaved().is_empty() {
        window.closing = Closing::No;
        return;
    }
    let wants_to_close = ctx.input(|input| input.viewport().close_requested());
    if wants_to_close && window.closing != Closing::Agreed {
        ctx.send_viewport_cmd(ViewportCommand::CancelClose);
        window.closing = Closing::Asked;
    }
    if window.closing == Closing::Asked {
        question(session, window, ctx);
    }
}

fn question(session: &Session, window: &mut Window, ctx: &Context) {
    let frame = style::card_frame(session.look.theme);
    let mut leave = None;
    let modal = Modal::new(Id::unique("unsaved"))
        .frame(frame)
        .show(ctx, |ui| {
            ui.set_max_width((ctx.content_rect().width() - 60.0).min(460.0));
            ui.label(style::strong(session.localize(strings::UNSAVED), 17.0));
            for name in window.unsaved() {
                ui.label(name);
            }
            ui.add_space(6.0);
            ui.horizontal_wrapped(|ui| {
                let save = ui.button(session.localize(strings::SAVE_AND_CLOSE));
                if ui.memory(|memory| memory.focused().is_none()) {
                    save.request_focus();
                }
                if save.clicked() {
                    leave = Some(true);
                }
                if ui
                    .button(session.localize(strings::CLOSE_UNSAVED))
                    .clicked()
                {
                    leave = Some(false);
                }
                if ui.button(session.localize(strings::STAY)).clicked() {
                    window.closing = Closing::No;
                }
            });
        });
    let saved = match leave {
        None if modal.should_close() => return window.closing = Closing::No,
        None => return,
        Some(true) => window.save_all(session),
        Some(false) => Ok(()),
    };
    match saved {
        Ok(()) => {
            window.closing = Closing::Agreed;
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
        Err(why) => {
            window.closing = Closing::No;
            window.notice = Some(why);
        }
    }
}

impl Window {
    fn documents(&mut self) -> [&mut Documents; 2] {
        [&mut self.scene_page.documents, &mut self.author.documents]
    }

    /// The names of the files with changes that are not saved.
    pub fn unsaved(&mut self) -> Vec<String> {
        let documents = self.documents().into_iter();
        let unsaved = documents.flat_map(|documents| documents.unsaved());
        unsaved
            .map(|document| document.path().display().to_string())
            .collect()
    }

    /// Errors: which file is not saved, and why; those after it are not saved either.
    fn save_all(&mut self, session: &Session) -> Result<(), String> {
        for document in self
            .documents()
            .into_iter()
            .flat_map(Documents::unsaved_mut)
        {
            if !document.save(false)? {
                let path = document.path().display().to_string();
                let language = session.look.language;
                return Err(strings::CHANGED_BY_OTHERS.format(language, &[("path", &path)]));
            }
        }
        Ok(())
    }
}
