//! Files of a page, which has no disk: those that were dropped on it are kept in memory, and what is written is downloaded.

use super::in_words;
use crate::app::opened::Readers;
use crate::color::read_image;
use crate::lesson::Lesson;
use crate::scene::Limits;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::spawn_local;
use web_sys::js_sys::{Array, Function, Reflect, Uint8Array};
use web_sys::{Blob, HtmlAnchorElement, Url};

thread_local! {
    static FILES: RefCell<BTreeMap<PathBuf, Vec<u8>>> = RefCell::default();
    /// Which are to be opened, and what kept others from being read.
    static DROPPED: RefCell<Vec<Result<PathBuf, String>>> = RefCell::default();
}

pub fn readers() -> Readers {
    Readers {
        document: |path| Lesson::of_file(&path.to_string_lossy(), &read(path)?, &mut named),
        folder: |_| Err("a page opens files, not folders".into()),
        picture: |path| read_image(&read(path)?),
        text: |path| String::from_utf8(read(path)?).map_err(|error| error.to_string()),
        scene: |path, text| Lesson::of_scene_text(&path.to_string_lossy(), text, &mut named),
        lesson: |_, text| {
            let lesson = Lesson::read(text, &Limits::default(), &mut named);
            lesson.map_err(|error| error.problems)
        },
        choose: |_| {
            let page = web_sys::window().map(JsValue::from).unwrap_or_default();
            let choose = Reflect::get(&page, &"choose".into());
            if let Some(choose) = choose.ok().as_ref().and_then(JsCast::dyn_ref::<Function>) {
                drop(choose.call0(&page));
            }
            Ok(None)
        },
        write: |path, bytes| {
            keep(path, bytes.to_vec());
            download(&path.to_string_lossy(), bytes)
        },
    }
}

fn keep(path: &Path, bytes: Vec<u8>) {
    FILES.with_borrow_mut(|files| files.insert(path.to_owned(), bytes));
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    let found = FILES.with_borrow(|files| files.get(path).cloned());
    found.ok_or_else(|| {
        "no such file; drop it on the page together with the one that names it".into()
    })
}

/// A file that another one names: of its path the page knows the last part.
fn named(name: &str) -> Result<Vec<u8>, String> {
    read(Path::new(Path::new(name).file_name().unwrap_or_default()))
}

/// Begins to read what was dropped on the page in this frame. Of several files one is opened, once all are read: a scene or lesson where
/// there is one, as it may name the others.
pub fn take_dropped(ctx: &egui::Context) {
    let files = ctx.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
    let is_document = |path: &Path| path.extension().is_some_and(|ending| ending == "json");
    let paths = files.iter().map(|file| file.path());
    let document = paths.clone().find(|path| is_document(path));
    let Some(opened) = document.or(paths.clone().next()).map(Path::to_owned) else {
        return;
    };
    let ctx = ctx.clone();
    spawn_local(async move {
        let mut all = Ok(opened);
        for file in files {
            match file.bytes_async().await {
                Ok(bytes) => keep(file.path(), bytes),
                Err(why) => all = Err(why),
            }
        }
        DROPPED.with_borrow_mut(|dropped| dropped.push(all));
        ctx.request_repaint();
    });
}

/// What is to be opened of the files dropped last, once they are read.
pub fn next_dropped() -> Option<Result<PathBuf, String>> {
    DROPPED.with_borrow_mut(Vec::pop)
}

/// Has the browser save a file of that name.
pub fn download(name: &str, bytes: &[u8]) -> Result<(), String> {
    let link = || -> Result<(), JsValue> {
        let parts = Array::of1(&Uint8Array::from(bytes));
        let blob = Blob::new_with_u8_array_sequence(&parts)?;
        let address = Url::create_object_url_with_blob(&blob)?;
        let document = web_sys::window().and_then(|window| window.document());
        let link = document.ok_or(JsValue::NULL)?.create_element("a")?;
        let link: HtmlAnchorElement = link.unchecked_into();
        link.set_href(&address);
        link.set_download(name);
        link.click();
        Url::revoke_object_url(&address)
    };
    link().map_err(|why| format!("{name} cannot be saved: {}", in_words(&why)))
}
