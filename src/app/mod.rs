//! The window: a [`Session`] holds what is shown, [`window`] shows it, [`open`] puts it on the screen.

mod against_drawer;
mod announced;
mod arrow_focus;
mod author;
mod author_strings;
mod background;
mod binding;
mod borders;
mod button;
mod cards;
mod compared_pictures;
mod crosshair;
mod document;
mod document_bar;
mod drag;
mod eframe_app;
mod finished;
mod forget;
mod home;
mod image_controls;
mod inspector_controls;
mod inspector_drawer;
mod keeper;
mod key_sheet;
mod keys;
mod layout;
mod lesson_card;
#[cfg(not(target_arch = "wasm32"))]
mod main_window;
mod mistakes_page;
mod narration;
mod narrow;
mod notice;
mod opened;
mod outline;
#[cfg(target_arch = "wasm32")]
mod page;
mod panel_on;
mod panel_view;
mod parameter_drawer;
mod picture_place;
mod picture_view;
mod presentation;
mod pressed;
mod prose;
mod question_card;
mod results_drawer;
mod room_controls;
mod row_end;
mod said_beside;
mod scene_page;
pub mod session;
mod skipped;
mod space_controls;
mod strings;
mod study_plot;
mod study_view;
mod study_words;
mod style;
mod take_away;
mod take_away_menu;
mod thumbnails;
mod top_bar;
mod transport;
mod tree_controls;
mod unsaved;
mod what_if_drawer;
mod whereabouts;
pub mod window;
mod window_files;
mod window_state;

#[cfg(test)]
mod tests;

#[cfg(not(target_arch = "wasm32"))]
pub use main_window::{NotOpened, Start, open};
pub use opened::Readers;
#[cfg(target_arch = "wasm32")]
pub use page::start;
pub use session::{Choice, Command, FolderOfLessons, LessonFromFile, Session};
pub use style::fonts;
pub use window_state::Window;
