//! What each command does.

use super::lessons::Neighbour;
use super::search::{in_program_names, is_sign};
use super::{Command, Direction, Drawer, Guess, Refused, Session, TEXT_SIZES};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::language::{Language, Message};
use crate::lesson::Thing;
use crate::picture::{Tag, Theme};
use crate::replay::moves::{self, Move};
use crate::replay::{Query, QueryError, query};

impl Session {
    /// Carries out a command. Errors: why it cannot act here; nothing has changed then.
    pub fn update(&mut self, command: Command) -> Result<(), Refused> {
        if let Some(target) = self.target(&command)? {
            self.play = None;
            return self.go_to(target);
        }
        if command == Command::NextNarrated {
            return self.finish();
        }
        match command {
            Command::Search => {
                self.show_window();
                self.search_wanted = true;
            }
            Command::Find(text) => return self.find(text, true),
            Command::FindBack(text) => return self.find(text, false),
            Command::SearchFor(text) => return self.search_for(text),
            Command::Results => self.toggle_drawer(Drawer::Results),
            Command::Play => return self.start_playing(Direction::Forward),
            Command::PlayBackwards => return self.start_playing(Direction::Backward),
            Command::Faster => {
                return self
                    .change_speed(1)
                    .then_some(())
                    .ok_or(strings::FASTEST.into());
            }
            Command::Slower => {
                return self
                    .change_speed(-1)
                    .then_some(())
                    .ok_or(strings::SLOWEST.into());
            }
            Command::LoopFrom => self.around.from = toggled(self.around.from, self.step()),
            Command::LoopTo => self.around.to = toggled(self.around.to, self.step()),
            Command::LoopOff => self.around = Default::default(),
            Command::Breakpoint => self.toggle_breakpoint(),
            Command::Focus(focus) => return self.focus_on(focus),
            Command::FocusOnPointer => {
                let focus = self.hovered.and_then(|tag| self.focus_of(tag));
                return self.focus_on(focus.ok_or(strings::NOTHING_UNDER_POINTER)?);
            }
            Command::FocusOnPolygonAt { x, y } => return self.focus_on_polygon(x, y),
            Command::Click(tag) => return self.click(tag),
            Command::Go(tag) => return self.go(tag),
            Command::Hover(tag) => self.hovered = tag,
            Command::ViewImage(view) => self.image = view,
            Command::ViewSpace(view) => self.space = view,
            Command::ViewTree(view) => self.tree = view,
            Command::Pin => match self.cannot_pin() {
                Some(why) => return Err(why.into()),
                None => self.toggle_pin(),
            },
            Command::ViewInspector(view) => self.inspector = view,
            Command::Answer(guess) => return self.answer(&guess),
            Command::Turn(degrees) => return self.turn(degrees),
            Command::Skip => return self.skip(),
            Command::Questions => self.look.questions = !self.look.questions,
            Command::Change(change) => return self.change(change),
            Command::Undo => return self.undo(),
            Command::Redo => return self.redo(),
            Command::LessonsValues => self.reset(),
            Command::Force(part) => return self.force(part),
            Command::Reset => {
                if !self.setup().forced().is_empty() {
                    self.leave_all_out();
                }
                if self.is_changed() {
                    self.reset();
                }
                self.focus_on(self.open.lesson.focus)?;
                self.start_over();
                self.forget_lesson();
            }
            Command::Sheet(sheet) => self.toggle_sheet(sheet),
            Command::Forget => self.forget(),
            Command::Open(id) => return self.open_listed(&id),
            Command::Method(method) => return self.choose_method(method),
            Command::NextLesson => return self.open_neighbour(Neighbour::Next),
            Command::PreviousLesson => return self.open_neighbour(Neighbour::Previous),
            Command::Home => self.toggle_home(),
            Command::Mistakes => self.toggle_mistakes(),
            Command::ShowMistake(mistake) => return self.show_mistake(mistake),
            Command::Study(command) => return self.study(command),
            Command::Key(panel) => self.choose_key(panel),
            Command::KeyNumber(number) => self.choose_key(self.numbered(number)?),
            Command::Fill => self.fill(),
            Command::Inspector => self.toggle_drawer(Drawer::Inspector),
            Command::Parameters => {
                if self.lesson().parameters.is_empty() {
                    return Err(strings::NO_PARAMETERS.into());
                }
                self.toggle_drawer(Drawer::Parameters);
            }
            Command::EditScene => match self.cannot_edit() {
                Some(why) => return Err(why.into()),
                None => self.look.editing = !self.look.editing,
            },
            Command::Author => match self.cannot_write() {
                Some(why) => return Err(why.into()),
                None => self.toggle_drawer(Drawer::Author),
            },
            Command::Against => match self.against() {
                Some(_) => self.toggle_drawer(Drawer::Against),
                None => return Err(strings::COMPARE_HOW.into()),
            },
            Command::WhatIf => self.toggle_drawer(Drawer::WhatIf),
            Command::Mistake(mistake) => self.make_mistake(mistake),
            Command::Share => {
                self.shared = Some(self.command_line()?);
            }
            Command::Choose(choice) => self.wanted.choice = Some(choice),
            Command::TakeAway(what, ending) => self.take_away(what, ending)?,
            Command::CopyPicture => self.wanted.copy = true,
            Command::OpenOwn(name) => self.open_own_scene(&name).map_err(Refused::Error)?,
            Command::ForgetOwn(name) => drop(self.scenes.remove(&name)),
            Command::SaveProgress => self.wanted.progress = true,
            command => return self.change_look(&command),
        }
        Ok(())
    }

    /// Whether a command could act here; the error says why not.
    pub fn allows(&self, command: &Command) -> Result<(), Refused> {
        if let Some(target) = self.target(command)? {
            let waits = self.question_at(self.step()) && target > self.step();
            return if waits {
                Err(strings::ANSWER_FIRST.into())
            } else {
                Ok(())
            };
        }
        let refusal = match *command {
            Command::NextNarrated if self.question_at(self.step()) => Some(strings::ANSWER_FIRST),
            Command::Play if self.playing().is_none() => self.cannot_play(Direction::Forward),
            Command::PlayBackwards if self.playing().is_none() => {
                self.cannot_play(Direction::Backward)
            }
            Command::LoopOff if self.loop_ends() == (None, None) => Some(strings::NO_LOOP),
            Command::ViewImage(view) if view == self.image => Some(strings::IMAGE_AS_IT_IS),
            Command::ViewSpace(view) if view == self.space => Some(strings::SPACE_AS_IT_IS),
            Command::ViewTree(ref view) if *view == self.tree => Some(strings::TREE_AS_IT_IS),
            Command::Method(method) => self.cannot_choose(method),
            Command::Pin => self.cannot_pin(),
            Command::TakeAway(what, _) => self.cannot_take(what),
            Command::Share => self.command_line().err(),
            Command::NextLesson => self.neighbour(Neighbour::Next).err(),
            Command::PreviousLesson => self.neighbour(Neighbour::Previous).err(),
            Command::Parameters if self.lesson().parameters.is_empty() => {
                Some(strings::NO_PARAMETERS)
            }
            Command::EditScene => self.cannot_edit(),
            Command::Author => self.cannot_write(),
            Command::Against if self.against().is_none() => Some(strings::COMPARE_HOW),
            Command::Unshot if !self.has_unshot() => Some(strings::NO_UNSHOT),
            Command::Focus(focus @ Focus::FormFactor { .. }) => self.cannot_follow(focus),
            Command::Key(panel) if self.key_panel() == Some(panel) => Some(strings::IS_KEY_PANEL),
            Command::KeyNumber(number) => {
                return self.numbered(number).map(drop);
            }
            Command::Change(change) => self.cannot_change(change.parameter()),
            Command::Undo => self.cannot_undo(),
            Command::Redo => self.cannot_redo(),
            Command::LessonsValues if !self.is_changed() => Some(strings::NOTHING_CHANGED),
            Command::Study(command) => self.cannot_study(command),
            Command::Force(part) => self.cannot_leave_out(part),
            _ => None,
        };
        refusal.map_or(Ok(()), |strings| Err(strings.into()))
    }

    /// The step that a command goes to; none for a command that is no move.
    fn target(&self, command: &Command) -> Result<Option<usize>, Refused> {
        let (here, last) = (self.step(), self.last_step());
        let go = |go: Move, why: Message| self.walk().target(go).ok_or(why);
        let narrated = |found: Option<&usize>, why: Message| found.copied().ok_or(why);
        let target = match *command {
            Command::Forward(_) | Command::End if here == last => Err(strings::AT_THE_END),
            Command::Back(_) | Command::Start if here == 0 => Err(strings::AT_THE_START),
            Command::Forward(steps) => Ok(here.saturating_add(steps).min(last)),
            Command::Back(steps) => Ok(here.saturating_sub(steps)),
            Command::Start => Ok(0),
            Command::End => Ok(last),
            Command::NextScope => go(moves::next_scope, strings::NO_SCOPE_AHEAD),
            Command::PreviousScope => go(moves::previous_scope, strings::NO_SCOPE_BEFORE),
            Command::Into => go(moves::into, strings::AT_THE_END),
            Command::Over => go(moves::over, strings::AT_THE_END),
            Command::Out => go(moves::out, strings::NOTHING_AROUND),
            Command::NextNarrated if self.is_last_explanation() => return Ok(None),
            Command::NextNarrated => narrated(
                self.narrated.iter().find(|&&step| step > here),
                strings::NOTHING_NARRATED_AHEAD,
            ),
            Command::PreviousNarrated => narrated(
                self.narrated.iter().rfind(|&&step| step < here),
                strings::NOTHING_NARRATED_BEFORE,
            ),
            Command::Seek(step) => Ok(step.min(last)),
            _ => return Ok(None),
        };
        Ok(Some(target?))
    }

    /// Goes to a step, or to the first question on the way that waits for its answer.
    pub(super) fn go_to(&mut self, target: usize) -> Result<(), Refused> {
        match self.question_between(self.step(), target) {
            Some(step) if step == self.step() => return Err(strings::ANSWER_FIRST.into()),
            Some(step) => self.seek(step),
            None => self.seek(target),
        }
        Ok(())
    }

    pub(super) fn seek(&mut self, step: usize) {
        let from = self.step();
        self.open.run.walk_mut().seek(step);
        self.follow_narration(from);
        self.select_again();
    }

    /// A text with conditions selects events; any other is looked for everywhere.
    fn search_for(&mut self, text: String) -> Result<(), Refused> {
        if text.contains(is_sign) {
            return self.find(text, true);
        }
        let listed = self.list_results(&text);
        if listed {
            self.look.drawer = Some(Drawer::Results);
        } else if self.look.drawer == Some(Drawer::Results) {
            self.look.drawer = None;
        }
        match self.find(text, true) {
            // The list is the answer.
            Err(_) if listed => Ok(()),
            Err(_) => Err(strings::NOT_FOUND.into()),
            Ok(()) => Ok(()),
        }
    }

    fn find(&mut self, text: String, forward: bool) -> Result<(), Refused> {
        let query = in_program_names(&text, self.walk(), self.look.language);
        let wrong = |error: QueryError| Refused::Error(error.to_string());
        let query: Query = query.parse().map_err(wrong)?;
        let (walk, here) = (self.walk(), self.step());
        let found = if forward {
            query::next(walk, &query, here)
                .or_else(|| query::matches(walk, &query, 0..here + 1).next())
        } else {
            query::previous(walk, &query, here)
                .or_else(|| query::matches(walk, &query, here..walk.len()).next_back())
        };
        self.search = text;
        self.play = None;
        self.go_to(found.ok_or(strings::NOT_FOUND)?)
    }

    fn cannot_play(&self, direction: Direction) -> Option<Message> {
        match direction {
            Direction::Forward if self.question_at(self.step()) => Some(strings::ANSWER_FIRST),
            _ if self.can_play(direction) => None,
            Direction::Forward => Some(strings::AT_THE_END),
            Direction::Backward => Some(strings::AT_THE_START),
        }
    }

    fn start_playing(&mut self, direction: Direction) -> Result<(), Refused> {
        match self.cannot_play(direction) {
            Some(strings) if self.playing() != Some(direction) => Err(strings.into()),
            _ => {
                self.play(direction);
                Ok(())
            }
        }
    }

    fn toggle_breakpoint(&mut self) {
        let step = self.step();
        let breakpoints = self.breakpoints.entry(self.focus).or_default();
        match breakpoints.binary_search(&step) {
            Ok(index) => drop(breakpoints.remove(index)),
            Err(index) => breakpoints.insert(index, step),
        }
    }

    fn click(&mut self, tag: Tag) -> Result<(), Refused> {
        match tag {
            Tag::Pixel { x, y } if self.pixel_is_asked() => self.answer(&Guess::Pixel { x, y }),
            Tag::Pixel { x, y } if self.thing_asked() == Some(Thing::Object) => {
                self.pick_object_at(x, y)
            }
            Tag::Patch(number) if self.thing_asked() == Some(Thing::Patch) => {
                self.answer(&Guess::Pick(number))
            }
            Tag::Fold(step) => {
                self.tree = self.tree.toggled(step);
                Ok(())
            }
            Tag::Channel(channel) => {
                self.channel = Some(channel).filter(|_| self.channel != Some(channel));
                Ok(())
            }
            Tag::Line(_) => self.go(tag),
            _ => {
                self.select(tag);
                Ok(())
            }
        }
    }

    /// What a question asks for is answered all the same.
    fn go(&mut self, tag: Tag) -> Result<(), Refused> {
        match tag {
            Tag::Pixel { .. } if self.pixel_is_asked() => self.click(tag),
            Tag::Pixel { .. } | Tag::Patch(_) if self.thing_asked().is_some() => self.click(tag),
            Tag::Fold(_) | Tag::Channel(_) => self.click(tag),
            Tag::Step(step) | Tag::Scope(step) => self.update(Command::Seek(step)),
            Tag::Line(line) => {
                let listing = self.walk().line(self.step()).listing;
                let carries_out = |&step: &usize| {
                    let at = self.walk().line(step);
                    at.number == line && at.listing == listing
                };
                let next = (self.step() + 1..self.walk().len()).find(carries_out);
                let found = next.or_else(|| (0..self.step()).find(carries_out));
                self.update(Command::Seek(found.ok_or(strings::NOT_FOUND)?))
            }
            Tag::Pixel { x, y } if !self.lesson().method.draws_pixels() => {
                self.go_to_patch_at(x, y)
            }
            Tag::Pixel { .. } | Tag::ScanLine(_) | Tag::Polygon(_)
                if self.focus_of(tag) != Some(self.focus) =>
            {
                self.focus_on(self.focus_of(tag).ok_or(strings::OUTSIDE)?)
            }
            _ => self.go_to_thing(tag),
        }
    }

    fn change_look(&mut self, command: &Command) -> Result<(), Refused> {
        let look = &mut self.look;
        match *command {
            Command::Speak(language) => look.language = language,
            Command::OtherLanguage => {
                look.language = match look.language {
                    Language::English => Language::Indonesian,
                    _ => Language::English,
                }
            }
            Command::Theme(theme) => look.theme = theme,
            Command::NextTheme => {
                look.theme = match look.theme {
                    Theme::Light => Theme::Dark,
                    Theme::Dark => Theme::Projector,
                    Theme::Projector => Theme::Light,
                }
            }
            Command::Present if look.presenting => look.stop_presenting(),
            Command::Present => {
                look.presenting = true;
                look.before_presenting = look.theme;
                look.theme = Theme::Projector;
            }
            Command::StopPresenting if self.filled => self.filled = false,
            Command::StopPresenting => look.stop_presenting(),
            Command::Keys => look.keys = !look.keys,
            Command::Skipped => look.skipped = !look.skipped,
            Command::Smooth => look.smooth = !look.smooth,
            Command::Unshot => look.unshot = !look.unshot,
            Command::NormalText => look.text = super::Look::new().text,
            Command::LargerText if look.text + 1 == TEXT_SIZES.len() => {
                return Err(strings::LARGEST.into());
            }
            Command::SmallerText if look.text == 0 => return Err(strings::SMALLEST.into()),
            Command::LargerText => look.text += 1,
            Command::SmallerText => look.text -= 1,
            _ => unreachable!("every other command is carried out above"),
        }
        Ok(())
    }
}

/// The end of a loop, set to this step, or taken away where it is this step already.
fn toggled(end: Option<usize>, step: usize) -> Option<usize> {
    if end == Some(step) { None } else { Some(step) }
}
