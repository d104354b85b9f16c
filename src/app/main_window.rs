//! The window on the screen.

use super::eframe_app::{App, to_go_on_with};
use super::keeper::{Keeper, Store};
use super::opened::{Opened, Readers};
use super::session::{FolderOfLessons, Kept, Session, listed};
use super::window_state::Window;
use crate::lesson::{Lesson, Link};
use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What the window opens with.
pub struct Start {
    /// A lesson, and its file where it is not one of the program's own; the page of all lessons unless given.
    pub lesson: Option<(Lesson, Option<PathBuf>)>,
    /// Of the lesson; where it was left unless given.
    pub step: Option<usize>,
    /// What else an address says about how it is shown.
    pub link: Option<Link>,
    /// A folder, and its lessons.
    pub folder: Option<(PathBuf, FolderOfLessons)>,
    /// For what is dropped on the window or saved again.
    pub readers: Readers,
}

/// Why nothing was opened.
pub enum NotOpened {
    /// What is wrong with the link.
    Link(String),
    /// Why there is no window, and what works without, in one line.
    Window(String),
}

/// Opens the window, and returns when it is closed.
pub fn open(start: Start) -> Result<(), NotOpened> {
    let (path, folder) = start.folder.unzip();
    let mut window = Window {
        opened: Some(Opened::new(start.readers, path)),
        ..Window::default()
    };
    let mut kept = Kept::default();
    let mut trouble = None;
    if let Some(store) = Store::of_user() {
        let (keeper, found) = Keeper::open(store);
        match found {
            Ok(found) => (kept, window.borders) = (found.session, found.layout),
            Err(why) => trouble = Some(why),
        }
        window.keeper = Some(keeper);
    }
    let at_home = start.lesson.is_none();
    let (lesson, file) = match start.lesson {
        Some(lesson) => lesson,
        None => {
            let found = to_go_on_with(kept.lesson.as_deref(), folder.as_ref());
            found.map_err(NotOpened::Window)?
        }
    };
    // Read here, so that no frame waits for it.
    listed();
    let session = Session::new(lesson);
    let mut session = session.map_err(|error| NotOpened::Window(error.to_string()))?;
    kept.language = kept.language.or_else(sys_locale::get_locale);
    session.file = file;
    if let Some(folder) = folder {
        session.show_folder(folder);
    }
    session.restore(kept);
    session.look.home = at_home;
    if let Some(step) = start.step {
        session.start_at(step);
    }
    window.notice = trouble.map(|trouble| trouble.in_language(session.look.language));
    if let Some(link) = start.link {
        session.show_link(&link).map_err(NotOpened::Link)?;
    }
    show(session, window).map_err(|problem| {
        NotOpened::Window(format!(
            "cannot open a window: {problem}; `lightwalk frames LESSON --out DIR` and `lightwalk render SCENE --method gouraud --out FILE.png` work without one"
        ))
    })
}

fn show(session: Session, window: Window) -> Result<(), String> {
    #[cfg(target_os = "linux")]
    if let Some(number) = missing_socket() {
        return Err(format!(
            "the Wayland display {number:?} (that of WAYLAND_SOCKET) did not answer"
        ));
    }
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title(session.window_title())
            .with_app_id("lightwalk")
            .with_icon(egui::IconData::default())
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([360.0, 480.0]),
        ..Default::default()
    };
    // Where a library is missing, winit panics before there is a window: that is a message, not a crash.
    let shown = Arc::new(AtomicBool::new(false));
    let hook = Arc::new(panic::take_hook());
    panic::set_hook(Box::new({
        let (shown, hook) = (shown.clone(), hook.clone());
        move |panic| {
            if shown.load(Ordering::Relaxed) {
                hook(panic);
            }
        }
    }));
    let running = panic::catch_unwind(AssertUnwindSafe(|| {
        let shown = shown.clone();
        let create: eframe::AppCreator = Box::new(move |creation| {
            shown.store(true, Ordering::Relaxed);
            Ok(Box::new(App::new(session, window, creation)))
        });
        eframe::run_native("lightwalk", options, create)
    }));
    match running {
        Ok(result) => result.map_err(|error| no_window(&error.to_string())),
        Err(panic) if shown.load(Ordering::Relaxed) => panic::resume_unwind(panic),
        Err(panic) => Err(no_window(&message(&*panic))),
    }
}

/// The number of a socket to the display that was to be inherited, where there is none: the Wayland library would abort.
#[cfg(target_os = "linux")]
fn missing_socket() -> Option<String> {
    use std::os::unix::fs::FileTypeExt;
    let value = std::env::var_os("WAYLAND_SOCKET").filter(|value| !value.is_empty())?;
    let number = value.to_string_lossy().into_owned();
    let is_socket = number.parse::<u32>().is_ok()
        && std::fs::metadata(format!("/proc/self/fd/{number}"))
            .is_ok_and(|file| file.file_type().is_socket());
    (!is_socket).then_some(number)
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or_default()
        .to_owned()
}

/// What is missing, in one line, from what the window system reported.
fn no_window(report: &str) -> String {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    if report.contains("xkbcommon-x11") {
        return "the library libxkbcommon-x11 is missing (on Debian and Ubuntu: apt install libxkbcommon-x11-0)".into();
    }
    if cfg!(target_os = "linux")
        && !set("DISPLAY")
        && !set("WAYLAND_DISPLAY")
        && !set("WAYLAND_SOCKET")
    {
        return "there is no display (DISPLAY and WAYLAND_DISPLAY are not set)".into();
    }
    let value = |name| std::env::var_os(name).unwrap_or_default();
    for (part, system, name) in [
        ("wayland compositor", "Wayland", "WAYLAND_DISPLAY"),
        ("X server", "X", "DISPLAY"),
        ("XOpenDisplay", "X", "DISPLAY"),
    ] {
        if report.contains(part) {
            return format!(
                "the {system} display {:?} (that of {name}) did not answer",
                value(name)
            );
        }
    }
    let line = without_source_places(report);
    if line.is_empty() {
        "the window system did not say why".into()
    } else {
        line
    }
}

/// On one line, without the source files of libraries, such as `os error at /…/winit/src/x11.rs:788: …`: those are of the machine that
/// built the program.
fn without_source_places(report: &str) -> String {
    let mut words: Vec<&str> = Vec::new();
    for word in report.split_whitespace() {
        if !word.contains(".rs:") {
            words.push(word);
        } else if words.last() == Some(&"at") {
            words.pop();
        }
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_message_shows_a_source_file_of_a_library() {
        let report = "winit EventLoopError: os error at\n /root/x/winit-0.30.13/src/linux/mod.rs:788: Out of luck";
        assert_eq!(
            without_source_places(report),
            "winit EventLoopError: os error Out of luck"
        );
    }
}
