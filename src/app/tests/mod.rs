//! The whole window, with no screen: keys pressed, buttons clicked, and what is then shown.

mod against;
mod author;
mod far_and_found;
mod home;
mod kept;
mod keys;
mod layout;
mod looking_closer;
mod meanings;
mod mistakes_page;
mod outline;
mod own;
mod painter;
mod parameters;
mod phone;
mod pictures;
mod progress_file;
mod questions;
mod ray_tree;
mod reading;
mod scene_page;
mod skipped;
mod studies;
mod take_away;
mod unsaved;
mod what_if;

use super::session::{Command, Session, Sheet, Standing};
use super::window;
use super::window_state::Window;
use super::{prose, strings, style};
use crate::algorithms::focus::Focus;
use crate::lesson::{Answer, Guess, Lesson, builtin, rounded};
use crate::panels::strings::Language;
use crate::panels::{Panel, draw};
use crate::picture::{Ink, Tag, Theme, to_png};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use painter::Textures;

type App = (Session, Window);

struct Screen {
    harness: Harness<'static, App>,
    textures: Textures,
    /// In physical pixels.
    size: [u32; 2],
}

/// The window on a screen of `size` pixels, `scale` of them a point.
fn screen(
    id: &str,
    size: [u32; 2],
    scale: f32,
    commands: impl IntoIterator<Item = Command>,
) -> Screen {
    let lesson = builtin(id)
        .expect("a lesson")
        .read()
        .expect("a right lesson");
    screen_of(lesson, size, scale, commands)
}

fn screen_of(
    lesson: Lesson,
    size: [u32; 2],
    scale: f32,
    commands: impl IntoIterator<Item = Command>,
) -> Screen {
    let mut session = Session::new(lesson).expect("a lesson that resolves");
    for command in commands {
        session.update(command).expect("a command that can act");
    }
    session.wait_for_picture();
    let textures = Textures::default();
    let zoom = session.look.zoom();
    let points = egui::vec2(size[0] as f32, size[1] as f32) / scale / zoom;
    let harness = Harness::builder()
        .with_size(points)
        .with_pixels_per_point(scale)
        .with_max_steps(12)
        .renderer(textures.clone())
        .with_context_setup(|ctx| ctx.set_fonts(style::fonts()))
        .build_ui_state(
            |ui, (session, window): &mut App| window::ui(session, window, ui),
            (session, Window::default()),
        );
    let mut screen = Screen {
        harness,
        textures,
        size,
    };
    screen.harness.input_mut().max_texture_side = Some(1 << 14);
    screen.harness.run();
    screen
}

fn triangle(commands: impl IntoIterator<Item = Command>) -> Screen {
    screen("gouraud-triangle", [1280, 800], 1.0, commands)
}

impl Screen {
    fn session(&self) -> &Session {
        &self.harness.state().0
    }

    fn session_mut(&mut self) -> &mut Session {
        &mut self.harness.state_mut().0
    }

    fn press(&mut self, held: Modifiers, key: Key) {
        self.harness.key_press_modifiers(held, key);
        self.harness.run();
    }

    fn click(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.harness.run();
    }

    /// The place of a panel on the screen.
    fn panel(&self, panel: Panel) -> egui::Rect {
        let images = self
            .harness
            .get_all_by_label(panel.title().text(self.session().look.language));
        let mut panel = images.filter(|node| node.accesskit_node().role() == egui::Role::Image);
        panel.next_back().expect("the panel").rect()
    }

    /// The place of the one picture of that name.
    fn picture(&self, name: &str) -> egui::Rect {
        let named = self.harness.get_all_by_label(name);
        let mut images = named.filter(|node| node.accesskit_node().role() == egui::Role::Image);
        let image = images.next().expect("a picture");
        assert!(images.next().is_none(), "one picture named {name}");
        image.rect()
    }

    /// Clicks there with the pointer.
    fn click_at(&mut self, at: egui::Pos2) {
        self.harness.hover_at(at);
        self.harness.run_steps(2);
        self.harness.drag_at(at);
        self.harness.drop_at(at);
        self.harness.run_steps(3);
    }

    /// Where a panel shows `tag`.
    fn place_of(&self, panel: Panel, tag: Tag) -> egui::Rect {
        let rect = self.panel(panel);
        let size = glam::Vec2::new(rect.width(), rect.height());
        let picture = draw(panel, &self.session().panel_input(), size);
        let place = picture.tagged_bounds(tag).expect("a place");
        let min = rect.min + egui::vec2(place.x, place.y);
        egui::Rect::from_min_size(min, egui::vec2(place.width, place.height))
    }

    fn painted(&self) -> tiny_skia::Pixmap {
        self.textures
            .paint(&self.harness.ctx, self.harness.output(), self.size)
    }

    /// Keeps a PNG of the window under `LIGHTWALK_SCREENSHOTS`, for people to look at.
    fn keep(&self, name: &str) {
        if let Some(folder) = std::env::var_os("LIGHTWALK_SCREENSHOTS") {
            let path = std::path::Path::new(&folder).join(format!("{name}.png"));
            std::fs::write(path, to_png(&self.painted())).expect("a folder that can be written to");
        }
    }
}

#[test]
fn every_input_has_a_name() {
    for commands in [
        vec![],
        vec![Command::Keys],
        vec![Command::NextNarrated, Command::Speak(Language::Indonesian)],
    ] {
        // The harness panics on an input without a name.
        triangle(commands).harness.run();
    }
}

/// A place on the border between the column and the key panel.
const BORDER: egui::Pos2 = egui::pos2(269.0, 300.0);

#[test]
fn the_column_is_as_wide_as_before_after_the_window_was_small() {
    let mut screen = triangle([]);
    let usual = screen.painted();
    screen.harness.hover_at(BORDER);
    screen.harness.drag_at(BORDER);
    screen.harness.run();
    screen.harness.hover_at(egui::pos2(409.0, 300.0));
    screen.harness.run();
    screen.harness.drop_at(egui::pos2(409.0, 300.0));
    screen.harness.remove_cursor();
    screen.harness.run();
    let chosen = screen.painted();
    assert!(usual != chosen);
    screen.keep("wide-column");
    for size in [[700.0, 500.0], [1280.0, 800.0]] {
        screen.harness.set_size(size.into());
        screen.harness.run();
    }
    assert!(screen.painted() == chosen);
}

#[test]
fn an_index_stands_low_and_the_space_after_it_stays() {
    let screen = triangle([]);
    let job = prose::prose(screen.session(), "I_P incremental", 14.0, Ink::Text);
    let galley = screen.harness.ctx.fonts_mut(|fonts| fonts.layout_job(job));
    let glyphs = &galley.rows[0].glyphs;
    let place = |index: usize| (glyphs[index].chr, glyphs[index].pos.y);
    let ((i, base), (p, low), (space, _)) = (place(0), place(1), place(2));
    assert_eq!([i, p, space], ['I', 'P', ' ']);
    assert!(low > base + 1.0, "{low} below {base}");
    assert!(glyphs[3].pos.x - glyphs[2].pos.x > 3.0, "a whole space");
}

#[test]
fn the_title_of_the_window_names_the_step() {
    let mut screen = triangle([]);
    screen.press(Modifiers::NONE, Key::ArrowRight);
    let last = screen.session().last_step();
    let title = screen.session().window_title();
    assert!(
        title.starts_with("Lightwalk") && title.ends_with(&format!("step 1 of {last}")),
        "{title}"
    );
}

/// Everything that the window looks like, in one loop; what is drawn must fill the screen and differ from theme to theme.
#[test]
fn the_window_can_be_painted_at_every_size() {
    let far = |questions: bool| {
        let mut commands = vec![Command::Questions; usize::from(questions)];
        commands.extend(vec![Command::NextNarrated; 5]);
        commands
    };
    let mut kept = Vec::new();
    for (lesson, name, size, scale, theme, language, commands) in [
        (
            "gouraud-triangle",
            "light",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "question",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::End],
        ),
        (
            "gouraud-triangle",
            "plain-step",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::Indonesian,
            vec![Command::Forward(3)],
        ),
        (
            "gouraud-teapot",
            "dark",
            [1280, 800],
            1.0,
            Theme::Dark,
            Language::Indonesian,
            far(true),
        ),
        (
            "gouraud-teapot",
            "pixel",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::Focus(Focus::Pixel { x: 320, y: 240 })],
        ),
        (
            "gouraud-triangle",
            "projector",
            [1280, 800],
            1.0,
            Theme::Projector,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "large",
            [1920, 1080],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
        (
            "gouraud-teapot",
            "projector-large",
            [1920, 1080],
            1.0,
            Theme::Projector,
            Language::Indonesian,
            far(true),
        ),
        (
            "gouraud-triangle",
            "fine",
            [2560, 1600],
            2.0,
            Theme::Dark,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "keys",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::Keys],
        ),
        (
            "gouraud-triangle",
            "small",
            [720, 480],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
    ] {
        let looks = [Command::Theme(theme), Command::Speak(language)];
        let screen = screen(lesson, size, scale, looks.into_iter().chain(commands));
        screen.keep(name);
        if size == [1280, 800] {
            let pixmap = screen.painted();
            // The harness leaves up to 10 pixels free on each side.
            let mut inside = (10..790).flat_map(|y| (10..1270).map(move |x| (x, y)));
            assert!(
                inside.all(|(x, y)| pixmap.pixel(x, y).is_some_and(|pixel| pixel.alpha() == 255)),
                "{name}"
            );
            assert!(!kept.contains(&pixmap), "{name}");
            kept.push(pixmap);
        }
    }
}
