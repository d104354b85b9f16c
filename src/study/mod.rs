//! Error against run time: for each family of methods a ladder of settings beside a trusted reference.
//!
//! A study is data ([`form`]): settings with what they run, and what is right. [`harness`] measures it with [`timing`], fits laws
//! ([`fit`]) and finds the [`pareto`] front; [`report`] and [`plot`] present it. A new family is a file in [`families`].
//!
//! And what is stiff, extreme or wrong: cases of [`stress`], each with the answer that it must give.
//!
//! And programs of others: a picture [`against`] ours, a trace to [`follow`], a [`matrix`] and a [`room_light`] of radiosity, and the [`mistakes`] that would make them.
//!
//! All times are of one thread. Nothing here touches a file.

pub mod ablation;
pub mod against;
pub mod count;
pub mod errors;
pub mod families;
pub mod fit;
pub mod follow;
pub mod form;
pub mod harness;
pub mod label;
pub mod machine;
pub mod matrix;
pub mod mistakes;
pub mod numbers;
pub mod pareto;
pub mod plot;
pub mod report;
pub mod room_light;
pub mod stress;
#[cfg(test)]
pub mod tests;
pub mod timing;
