//! The window as eframe shows it, on the screen or in a page.

use super::session::{FolderOfLessons, Session};
use super::style;
use super::window;
use super::window_state::Window;
use crate::lesson::{Lesson, builtin, builtins};
use std::path::PathBuf;

pub struct App {
    pub session: Session,
    pub window: Window,
}

impl App {
    pub fn new(session: Session, window: Window, creation: &eframe::CreationContext<'_>) -> Self {
        creation.egui_ctx.set_fonts(style::fonts());
        App { session, window }
    }

    /// Opens what was dropped on the page, or says why it cannot be read.
    #[cfg(target_arch = "wasm32")]
    pub fn open(&mut self, dropped: Result<PathBuf, String>) {
        let outcome = dropped.and_then(|path| self.window.open_file(&mut self.session, &path));
        self.window.notice = outcome.unwrap_or_else(Some);
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        window::ui(&mut self.session, &mut self.window, ui);
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }
}

/// The lesson that was open last, or else the first one; of the folder where there is one.
pub fn to_go_on_with(
    last: Option<&str>,
    folder: Option<&FolderOfLessons>,
) -> Result<(Lesson, Option<PathBuf>), String> {
    let own = folder.and_then(|folder| {
        let last = last.and_then(|last| folder.lesson(last));
        last.or_else(|| folder.first())
    });
    if let Some((lesson, path)) = own {
        return Ok((lesson.clone(), Some(path.to_owned())));
    }
    let last = last.and_then(builtin);
    let first = last.or(builtins().first().copied());
    let read = first.ok_or("there is no lesson")?.read();
    Ok((read.map_err(|error| error.to_string())?, None))
}
