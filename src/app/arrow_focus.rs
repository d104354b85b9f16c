//! Whether a slider has the focus: the arrows then move it, and not through the run.

use egui::{Context, Id};

fn id() -> Id {
    Id::unique("a slider has the focus")
}

pub fn set(has_focus: bool, ctx: &Context) {
    ctx.data_mut(|data| data.insert_temp(id(), has_focus));
}

pub fn get(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(id())).unwrap_or(false)
}
