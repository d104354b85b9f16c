//! What a screen reader says by itself.

/// Has a screen reader say what stands there whenever it changes.
pub(super) fn announced(response: egui::Response) {
    response.ctx.accesskit_node_builder(response.id, |node| {
        node.set_live(egui::accesskit::Live::Polite);
    });
}
