//! What one takes away of a lesson. The steps that are explained become [`Page`]s: what is said and asked there, the line of code, and
//! pictures of its panels. A handout, slides and an animation are three uses of the same pages.

mod card;
mod deck;
mod handout;
mod html;
mod page;
mod question;
mod shown;

pub use card::{SMALLEST_CARD, card, reading_seconds};
pub use deck::deck;
pub use handout::{Contents, handout};
pub use page::Page;
pub use shown::ExportedLesson;
