//! Whether what has the focus takes the arrows itself: a slider, or a picture with its crosshair. They then do not walk through the run.

use egui::{Context, Id};

fn id() -> Id {
    Id::unique("arrows")
}

/// What has the focus says so in every frame.
pub fn claim(ctx: &Context) {
    ctx.data_mut(|data| data.insert_temp(id(), true));
}

/// Whether the arrows were claimed since this was asked last.
pub fn take(ctx: &Context) -> bool {
    ctx.data_mut(|data| data.remove_temp::<bool>(id()))
        .unwrap_or(false)
}
