//! The window in a web page: [`start`] shows it in the page's canvas, and its address says what is shown.

mod files;

use super::background;
use super::eframe_app::{App, to_go_on_with};
use super::keeper::{Keeper, Store};
use super::opened::Opened;
use super::session::{Kept, Session, Standing};
use super::window_state::Window;
use crate::lesson::Link;
use eframe::{WebOptions, WebRunner};
use std::sync::Arc;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::spawn_local;
use web_sys::js_sys::{Function, Reflect};
use web_sys::{Event, HtmlCanvasElement};

/// The ids of the page's canvas, of what stands there until it is drawn, and of the message that stands there where it cannot be.
const CANVAS: &str = "lightwalk";
const LOADING: &str = "loading";
const TROUBLE: &str = "trouble";
/// What the address says of a page in a frame of another one.
const EMBEDDED: &str = "embed";
/// The function of the page that takes reports, as JSON.
const REPORT: &str = "report";

/// Shows the window in the page.
pub fn start() {
    spawn_local(async {
        let outcome = run().await;
        let page = web_sys::window().and_then(|window| window.document());
        let element = |id| page.as_ref()?.get_element_by_id(id);
        if let Some(loading) = element(LOADING) {
            loading.remove();
        }
        if let (Err(why), Some(place)) = (outcome, element(TROUBLE)) {
            place.set_text_content(Some(&why));
        }
    });
}

async fn run() -> Result<(), String> {
    let page = web_sys::window().ok_or("there is no page")?;
    let document = page.document().ok_or("there is no document")?;
    let canvas = document
        .get_element_by_id(CANVAS)
        .and_then(|element| element.dyn_into::<HtmlCanvasElement>().ok())
        .ok_or("the page has no canvas")?;
    let mut window = Window {
        address: Some(base(&page)),
        opened: Some(Opened::new(files::readers(), None)),
        embedded: is_embedded(&page),
        ..Window::default()
    };
    let mut kept = Kept::default();
    if let Some(store) = Store::of_user() {
        let (keeper, found) = Keeper::open(store);
        match found {
            Ok(found) => (kept, window.borders) = (found.session, found.layout),
            Err(why) => window.notice = Some(why.in_language(Default::default())),
        }
        window.keeper = Some(keeper);
    }
    kept.language = kept.language.or_else(|| page.navigator().language());
    let (lesson, _) = to_go_on_with(kept.lesson.as_deref(), None)?;
    let mut session = Session::new(lesson).map_err(|error| error.to_string())?;
    session.restore(kept);
    session.look.home = true;
    let address = Address::new(&page);
    let runner = WebRunner::new();
    runner
        .start(
            canvas,
            WebOptions::default(),
            Box::new(move |creation| {
                address.wake(creation.egui_ctx.clone());
                Ok(Box::new(PageApp {
                    app: App::new(session, window, creation),
                    address,
                    leave: Leave::new(),
                    reported: None,
                }))
            }),
        )
        .await
        .map_err(|why| format!("the browser cannot draw the window: {}", in_words(&why)))
}

/// Whether the address says that the page stands in a frame of another one.
fn is_embedded(page: &web_sys::Window) -> bool {
    let asked = page.location().search().unwrap_or_default();
    let mut parts = asked.trim_start_matches('?').split('&');
    parts.any(|part| part == EMBEDDED)
}

fn in_words(error: &JsValue) -> String {
    error.as_string().unwrap_or_else(|| format!("{error:?}"))
}

/// The page's address without what follows its `#`.
fn base(page: &web_sys::Window) -> String {
    let href = page.location().href().unwrap_or_default();
    href.split('#').next().unwrap_or_default().to_owned()
}

/// The window, with what the page reports of it.
struct PageApp {
    app: App,
    address: Address,
    leave: Leave,
    /// What was reported last: the recording, the step and the address, and how the questions stood.
    reported: Option<((u64, usize, String), Vec<Standing>)>,
}

impl PageApp {
    /// Reports where the window is: by the page's title; for screen readers, which see nothing of a canvas, by what is said at the step; and
    /// to the page that has this one in a frame, with how the questions stand.
    fn report(&mut self) {
        let session = &self.app.session;
        let shown = (
            session.recording(),
            session.step(),
            session.link().to_string(),
        );
        let standings = session.standings().to_vec();
        if self.reported.as_ref() == Some(&(shown.clone(), standings.clone())) {
            return;
        }
        let answers: Vec<_> = session
            .outline()
            .iter()
            .map(|entry| entry.standing)
            .collect();
        let text = serde_json::json!({
            "address": shown.2,
            "title": session.window_title(),
            "said": session.said_here(),
            "answers": answers,
        });
        let text = text.to_string();
        let page = web_sys::window().map(JsValue::from).unwrap_or_default();
        let report = Reflect::get(&page, &REPORT.into());
        if let Some(report) = report.ok().as_ref().and_then(JsCast::dyn_ref::<Function>) {
            // What the page makes of it is its own concern.
            drop(report.call1(&page, &text.as_str().into()));
        }
        self.reported = Some((shown, standings));
    }
}

impl eframe::App for PageApp {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.address.follow(&mut self.app);
        files::take_dropped(ui.ctx());
        if let Some(dropped) = files::next_dropped() {
            self.app.open(dropped);
        }
        eframe::App::ui(&mut self.app, ui, frame);
        self.address.write(&self.app.session);
        self.report();
        self.leave.ask(!self.app.window.unsaved().is_empty());
        if background::do_next() {
            ui.ctx().request_repaint();
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        eframe::App::clear_color(&self.app, visuals)
    }
}

/// What stands behind the `#` of the page's address. Another lesson is another page to go back to; another step is not.
struct Address {
    page: web_sys::Window,
    /// As it was last written or read; none before.
    known: Option<String>,
    place: Place,
}

/// The lesson, the scene, and whether it is the page of mistakes, as they were last written or read.
type Place = (Option<String>, Option<Arc<str>>, bool);

impl Address {
    fn new(page: &web_sys::Window) -> Self {
        Address {
            page: page.clone(),
            known: None,
            place: Place::default(),
        }
    }

    /// Lets the window be drawn once the user goes back or forward, or writes another address.
    fn wake(&self, ctx: egui::Context) {
        let wake = Closure::<dyn Fn()>::new(move || ctx.request_repaint());
        self.page
            .set_onhashchange(Some(wake.as_ref().unchecked_ref()));
        // As long as the page lives.
        wake.forget();
    }

    fn now(&self) -> String {
        let hash = self.page.location().hash().unwrap_or_default();
        hash.trim_start_matches('#').to_owned()
    }

    /// Goes where the address leads, once it is another one.
    fn follow(&mut self, app: &mut App) {
        let now = self.now();
        if self.known.as_ref() == Some(&now) {
            return;
        }
        let shown = Link::parse(&now).and_then(|link| app.session.show_link(&link));
        if let Err(why) = shown {
            app.window.notice = Some(why);
        }
        self.place = place(&app.session.link());
        self.known = Some(now);
    }

    fn write(&mut self, session: &Session) {
        let link = session.link();
        let text = link.to_string();
        if self.known.as_ref() == Some(&text) {
            return;
        }
        let address = format!("#{text}");
        let Ok(history) = self.page.history() else {
            return;
        };
        // A browser that is asked too often refuses for a while: then the next frame tries again.
        let written = match place(&link) == self.place {
            true => history.replace_state_with_url(&JsValue::NULL, "", Some(&address)),
            false => history.push_state_with_url(&JsValue::NULL, "", Some(&address)),
        };
        if written.is_ok() {
            self.place = place(&link);
            self.known = Some(text);
        }
    }
}

/// Lets the browser ask before the page is left.
struct Leave {
    asks: bool,
    stop: Closure<dyn Fn(Event)>,
}

impl Leave {
    fn new() -> Self {
        Leave {
            asks: false,
            stop: Closure::new(|event: Event| event.prevent_default()),
        }
    }

    fn ask(&mut self, asks: bool) {
        if self.asks != asks
            && let Some(page) = web_sys::window()
        {
            let stop = asks.then(|| self.stop.as_ref().unchecked_ref());
            page.set_onbeforeunload(stop);
            self.asks = asks;
        }
    }
}

/// What is another page to go back to.
fn place(link: &Link) -> Place {
    (link.lesson.clone(), link.scene.clone(), link.mistakes)
}
