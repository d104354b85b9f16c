//! What a user can ask of a session, and why it may be refused.

use crate::algorithms::focus::Focus;
use crate::export::TakeAway;
use crate::language::{Language, Message};
use crate::lesson::{Change, Guess};
use crate::methods::{Method, Mistake};
use crate::panels::{ImageView, InspectorView, Panel, SpaceView, TreeView};
use crate::picture::{Tag, Theme};
use crate::scene::Part;

/// Everything that keys, buttons and clicks do.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// So many events on; the last one where there are fewer.
    Forward(usize),
    /// So many events back.
    Back(usize),
    NextScope,
    PreviousScope,
    /// To the next event, inside the scope that opens here.
    Into,
    /// To what follows the scope that opens here.
    Over,
    /// To what follows the scope around.
    Out,
    Start,
    End,
    NextNarrated,
    PreviousNarrated,
    Seek(usize),
    /// To the next event that a search text selects; around the end to the first.
    Find(String),
    FindBack(String),
    /// Lists what a text finds, and goes to the next event where it selects events.
    SearchFor(String),
    /// Opens the list again, or closes it.
    Results,
    /// To where the keyboard writes a search.
    Search,
    /// Plays, or pauses.
    Play,
    PlayBackwards,
    Faster,
    Slower,
    /// The loop starts at this step; a second time, there is none.
    LoopFrom,
    LoopTo,
    LoopOff,
    /// Sets one at this step, or takes it away.
    Breakpoint,
    /// Looks at another part of the frame.
    Focus(Focus),
    /// Looks at what the pointer is over.
    FocusOnPointer,
    /// Looks at the polygon that is seen at a pixel.
    FocusOnPolygonAt {
        x: u32,
        y: u32,
    },
    /// Answers with what a tag shows, where it is asked for; else selects it.
    Click(Tag),
    /// Goes to what a tag shows, or focuses on it.
    Go(Tag),
    Hover(Option<Tag>),
    /// Another part of the picture, or something else of its pixels.
    ViewImage(ImageView),
    /// The scene in space from elsewhere, or with other rays.
    ViewSpace(SpaceView),
    /// Another part of the ray tree, or at another size.
    ViewTree(TreeView),
    /// Pins the ray tree, so that those of other pixels are shown beside it, or takes it away.
    Pin,
    /// Other values in the inspector.
    ViewInspector(InspectorView),
    Answer(Guess),
    /// Turns the arrow that is asked for: degrees clockwise from the normal.
    Turn(f64),
    Skip,
    /// Questions on or off.
    Questions,
    /// Gives a parameter another value; the lesson says which may be changed.
    Change(Change),
    /// Takes the last change of a parameter back.
    Undo,
    /// Makes it again.
    Redo,
    /// Gives all parameters the values that the lesson gives them.
    LessonsValues,
    /// Forces a part that the scene does not need, or skips it again.
    Force(Part),
    /// The lesson from its beginning, as it was before anything was changed or answered.
    Reset,
    /// Lays a sheet over the lesson, or takes it away.
    Sheet(Sheet),
    /// Forgets the position and the answers in all lessons.
    Forget,
    /// Error against run time.
    Study(StudyCommand),
    /// Another method for a scene that one walks through freely.
    Method(Method),
    /// A lesson of the list, by its id.
    Open(String),
    NextLesson,
    PreviousLesson,
    /// A scene of one's own that was kept, by its name.
    OpenOwn(String),
    /// Keeps it no longer.
    ForgetOwn(String),
    /// Saves all progress in a file.
    SaveProgress,
    /// The page of all lessons, or back from it.
    Home,
    /// The page of classic mistakes, or from there to that of all lessons.
    Mistakes,
    /// Walks through a scene that shows a mistake, with the mistake switched on.
    ShowMistake(Mistake),
    Speak(Language),
    OtherLanguage,
    Theme(Theme),
    NextTheme,
    /// Copies the command that opens this lesson at this step; the window takes it to the clipboard.
    Share,
    /// Asks for a file or folder, and opens it.
    Choose(Choice),
    /// Makes a file of what is shown; its name ends so.
    TakeAway(TakeAway, &'static str),
    /// Copies the key panel as a picture; the window takes it to the clipboard.
    CopyPicture,
    /// Presentation: the whole screen, larger and with more contrast.
    Present,
    /// Ends what fills the window, or the presentation.
    StopPresenting,
    /// The sheet of keys.
    Keys,
    /// The view of what is left out, because the scene does not need it.
    Skipped,
    /// All values of the step, in a drawer.
    Inspector,
    /// What may be changed, in a drawer.
    Parameters,
    /// The page on which the scene that is walked is edited, or back from it.
    EditScene,
    /// The lesson as its file has it, in a drawer, to be written.
    Author,
    /// The user's own picture beside ours, in a drawer.
    Against,
    /// Classic mistakes beside ours, in a drawer.
    WhatIf,
    /// Switches a classic mistake on there, or all of them off.
    Mistake(Option<Mistake>),
    /// Shows a panel large, until the lesson turns to another one.
    Key(Panel),
    /// The same by the panel's number, from 1.
    KeyNumber(usize),
    /// The key panel alone in the window, or no longer.
    Fill,
    /// Rooms smooth, or patch by patch.
    Smooth,
    /// Rooms with what is unshot, or with their light.
    Unshot,
    LargerText,
    SmallerText,
    NormalText,
}

/// A command about studies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StudyCommand {
    /// Opens the view, or closes it.
    View,
    /// By its index among all studies.
    Choose(usize),
    /// Few and small settings, or all of them.
    Quick,
    /// Measures the chosen study.
    Measure,
    Cancel,
    /// Shows a part of what was found.
    Part(usize),
    /// Describes a point; where it has a picture, opens that to be walked through.
    Pick(PointAt),
}

/// One point of the study that is shown: indices of its part, of its curve there, and of itself on that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointAt {
    pub part: usize,
    pub line: usize,
    pub point: usize,
}

/// Why a command was not carried out.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    Because(Message),
    /// With details, which are in English.
    Error(String),
}

impl Refused {
    pub fn in_language(&self, language: Language) -> &str {
        match self {
            Refused::Because(strings) => strings.text(language),
            Refused::Error(text) => text,
        }
    }
}

impl From<Message> for Refused {
    fn from(strings: Message) -> Self {
        Refused::Because(strings)
    }
}

/// What one is asked to choose, to open it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    File,
    /// Of lessons.
    Folder,
}

/// What lies over the lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sheet {
    /// The lesson's explanations, to go to one.
    Outline,
    /// What was learned, and how the questions were answered.
    Finished,
    /// Asks whether the progress in all lessons shall be forgotten.
    Forget,
}
