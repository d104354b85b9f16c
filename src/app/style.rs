//! How egui looks: the fonts and inks of the pictures, so that window and panels are of one piece.

use super::layout::TARGET;
use crate::picture::{self, Ink, Theme};
use egui::epaint::Shadow;
use egui::{
    Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Stroke, TextStyle,
    Visuals,
};
use std::sync::Arc;

/// The bar on top keeps its colours in every theme.
pub const BAR: Color32 = Color32::from_rgb(0x24, 0x30, 0x38);
pub const BAR_BUTTON: Color32 = Color32::from_rgb(0x37, 0x46, 0x4f);
pub const BAR_CHOSEN: Color32 = Color32::from_rgb(0x00, 0x72, 0xb2);
pub const BAR_TEXT: Color32 = Color32::from_rgb(0xf4, 0xf6, 0xf7);

/// The bundled fonts, and no others: the same glyphs on every machine.
pub fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    let files = [
        ("sans", picture::Style::Body),
        ("bold", picture::Style::Bold),
        ("mono", picture::Style::Mono),
    ];
    for (name, style) in files {
        fonts.font_data.insert(
            name.into(),
            Arc::new(FontData::from_static(picture::font_file(style))),
        );
    }
    let family = |names: [&str; 2]| names.map(String::from).to_vec();
    fonts
        .families
        .insert(FontFamily::Proportional, family(["sans", "mono"]));
    fonts
        .families
        .insert(FontFamily::Monospace, family(["mono", "sans"]));
    fonts.families.insert(bold(), family(["bold", "sans"]));
    fonts
}

pub fn bold() -> FontFamily {
    FontFamily::Name("bold".into())
}

/// `text` in bold, `size` points to the em.
pub fn strong(text: impl Into<String>, size: f32) -> egui::RichText {
    egui::RichText::new(text).font(FontId::new(size, bold()))
}

pub fn color(theme: Theme, ink: Ink) -> Color32 {
    let [r, g, b] = theme.color(ink);
    Color32::from_rgb(r, g, b)
}

/// Paints a card that fills `rect`, its frame inside.
pub fn card(theme: Theme, rect: egui::Rect, ui: &egui::Ui) {
    let rule = Stroke::new(1.0, color(theme, Ink::Rule));
    let surface = color(theme, Ink::Surface);
    let inside = egui::StrokeKind::Inside;
    ui.painter().rect(rect, 6.0, surface, rule, inside);
}

/// The frame of a sheet that lies over the window.
pub fn card_frame(theme: Theme) -> egui::Frame {
    egui::Frame::new()
        .fill(color(theme, Ink::Surface))
        .stroke(Stroke::new(1.0, color(theme, Ink::Rule)))
        .corner_radius(6)
        .inner_margin(18)
}

/// Whether what can be pressed is as large as a finger needs it.
pub fn is_for_fingers(ctx: &egui::Context) -> bool {
    ctx.global_style().spacing.interact_size.y >= TARGET
}

/// Puts fonts and inks of a theme in place, and the sizes of what can be pressed.
pub fn apply(ctx: &egui::Context, theme: Theme, for_fingers: bool) {
    ctx.set_theme(if theme == Theme::Dark {
        egui::Theme::Dark
    } else {
        egui::Theme::Light
    });
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
    let sizes = [
        (TextStyle::Small, FontId::proportional(12.0)),
        (TextStyle::Body, FontId::proportional(14.0)),
        (TextStyle::Button, FontId::proportional(13.0)),
        (TextStyle::Monospace, FontId::monospace(13.0)),
        (TextStyle::Heading, FontId::new(15.0, bold())),
    ];
    ctx.all_styles_mut(|style| {
        style.text_styles = sizes.clone().into();
        style.spacing.item_spacing = egui::vec2(8.0, 6.0);
        // Menus are as high as their entries, where the window has the room.
        style.spacing.default_area_size.y = f32::INFINITY;
        style.spacing.button_padding = egui::vec2(9.0, 5.0);
        style.spacing.interact_size.y = match for_fingers {
            true => TARGET,
            false => 26.0,
        };
        style.visuals = Visuals {
            // A steady cursor: an idle window stays idle.
            text_cursor: egui::style::TextCursorStyle {
                blink: false,
                ..Default::default()
            },
            ..visuals(theme)
        };
    });
}

/// What is scrolled leaves room for the bar, which else lies over the ends of its buttons.
pub fn beside_scroll_bar(ui: &mut egui::Ui) {
    let scroll = &mut ui.spacing_mut().scroll;
    scroll.floating_allocated_width = scroll.bar_width + scroll.bar_inner_margin;
}

fn visuals(theme: Theme) -> Visuals {
    let ink = |ink| color(theme, ink);
    let line = |width: f32, of| Stroke::new(width, ink(of));
    let mut visuals = if theme == Theme::Dark {
        Visuals::dark()
    } else {
        Visuals::light()
    };
    visuals.panel_fill = ink(Ink::Background);
    visuals.window_fill = ink(Ink::Surface);
    visuals.window_stroke = line(1.0, Ink::Rule);
    visuals.window_shadow = Shadow::NONE;
    visuals.popup_shadow = Shadow::NONE;
    visuals.extreme_bg_color = ink(Ink::Surface);
    visuals.text_edit_bg_color = Some(ink(Ink::Surface));
    visuals.faint_bg_color = ink(Ink::Faint);
    visuals.code_bg_color = ink(Ink::Faint);
    visuals.weak_text_color = Some(ink(Ink::Muted));
    visuals.hyperlink_color = ink(Ink::Linked);
    visuals.warn_fg_color = ink(Ink::Warn);
    visuals.error_fg_color = ink(Ink::Bad);
    visuals.selection.bg_fill = ink(Ink::LinkedTint);
    visuals.selection.stroke = line(1.5, Ink::Linked);
    visuals.disabled_alpha = 0.55;
    let looks = [
        (
            &mut visuals.widgets.noninteractive,
            Ink::Surface,
            Ink::Rule,
            1.0,
        ),
        (&mut visuals.widgets.inactive, Ink::Faint, Ink::Rule, 1.0),
        (
            &mut visuals.widgets.hovered,
            Ink::LinkedTint,
            Ink::Linked,
            1.0,
        ),
        (
            &mut visuals.widgets.active,
            Ink::LinkedTint,
            Ink::Linked,
            2.0,
        ),
        (&mut visuals.widgets.open, Ink::LinkedTint, Ink::Linked, 1.0),
    ];
    for (widget, fill, rule, width) in looks {
        widget.bg_fill = ink(fill);
        widget.weak_bg_fill = ink(fill);
        widget.bg_stroke = line(width, rule);
        widget.fg_stroke = line(1.0, Ink::Text);
        widget.corner_radius = CornerRadius::same(4);
        widget.expansion = 0.0;
    }
    visuals
}
