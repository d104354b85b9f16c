//! The colours of each theme: one table, and what can be read on what.

use super::ink::Ink;

named! {
    /// What the inks look like.
    #[derive(Default)]
    pub enum Theme {
        #[default]
        Light = "light",
        Dark = "dark",
        /// For a lecture hall: black on white, stronger accents, everything larger.
        Projector = "projector",
    }
}

/// One row a meaning: the ink in the light, dark and projector theme, as `0xRRGGBB` sRGB.
const TABLE: [(Ink, [u32; 3]); 14] = [
    (Ink::Background, [0xf7f7f5, 0x14181b, 0xffffff]),
    (Ink::Surface, [0xffffff, 0x1e2327, 0xffffff]),
    (Ink::Text, [0x1b1b1b, 0xececea, 0x000000]),
    (Ink::Muted, [0x696969, 0xa5abae, 0x3a3a3a]),
    (Ink::Faint, [0xe9ecee, 0x2f373c, 0xdadfe2]),
    (Ink::Rule, [0x8f8f8c, 0x656d74, 0x8a8a8a]),
    (Ink::This, [0xc45500, 0xff9a4d, 0xb34700]),
    (Ink::ThisTint, [0xfff1e5, 0x40301f, 0xffe3cc]),
    (Ink::Linked, [0x0072b2, 0x56b4e9, 0x005a94]),
    (Ink::LinkedTint, [0xdfeff8, 0x1c3a4d, 0xcce5f6]),
    (Ink::Good, [0x008060, 0x3fc79a, 0x006b4a]),
    (Ink::Bad, [0xc62828, 0xff8078, 0xb00020]),
    (Ink::Warn, [0x946000, 0xf0b429, 0x7a4b00]),
    (Ink::WarnTint, [0xfff6e6, 0x3a2f16, 0xffefc9]),
];

/// Okabe & Ito's colours for categories (2008), in an order that keeps the accent's neighbour for last and starts with the
/// darkest; their black is the theme's text. On a light ground the lighter ones are darkened until they stand out from it by 3.
const SERIES: [[u32; 2]; 7] = [
    [0x0072b2, 0x0072b2],
    [0xbe8300, 0xe69f00],
    [0x009e73, 0x009e73],
    [0xc675a2, 0xcc79a7],
    [0x4897c3, 0x56b4e9],
    [0xd55e00, 0xd55e00],
    [0x99912a, 0xf0e442],
];

impl Theme {
    /// How much larger this theme is drawn. Lay a panel out for its size divided by this factor, and rasterise it at the
    /// screen's scale times this factor: then everything grows together, and no text leaves its place.
    pub fn text_scale(self) -> f32 {
        match self {
            Theme::Light | Theme::Dark => 1.0,
            Theme::Projector => 1.25,
        }
    }

    /// 8-bit sRGB of an ink.
    pub fn color(self, ink: Ink) -> [u8; 3] {
        match ink {
            Ink::Rgb(rgb) => rgb.to_srgb8(),
            Ink::Series(n) => match usize::from(n) % (SERIES.len() + 1) {
                n if n < SERIES.len() => bytes(SERIES[n][usize::from(self == Theme::Dark)]),
                _ => self.color(Ink::Text),
            },
            ink => TABLE
                .iter()
                .find(|(meaning, _)| *meaning == ink)
                .map(|(_, colors)| bytes(colors[self as usize]))
                .expect("every ink without a value of its own is in the table"),
        }
    }
}

fn bytes(rgb: u32) -> [u8; 3] {
    let [_, r, g, b] = rgb.to_be_bytes();
    [r, g, b]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    /// WCAG 2.1 contrast ratio, from the relative luminances of the 8-bit colours.
    fn contrast(theme: Theme, ink: Ink, on: Ink) -> f64 {
        let luminance = |ink| {
            let linear = theme.color(ink).map(|byte| {
                let encoded = f64::from(byte) / 255.0;
                if encoded <= 0.040_45 {
                    encoded / 12.92
                } else {
                    ((encoded + 0.055) / 1.055).powf(2.4)
                }
            });
            Rgb::from(linear).luminance()
        };
        let (a, b) = (luminance(ink) + 0.05, luminance(on) + 0.05);
        (a / b).max(b / a)
    }

    /// WCAG 2.1, success criterion 1.4.11.
    #[test]
    fn lines_series_borders_and_bars_stand_out_by_three() {
        let series = (0..=SERIES.len()).map(|n| Ink::Series(n as u8));
        let lines = [
            Ink::Rule,
            Ink::This,
            Ink::Linked,
            Ink::Good,
            Ink::Bad,
            Ink::Warn,
        ];
        for theme in Theme::ALL {
            for ink in series.clone().chain(lines) {
                for ground in [Ink::Surface, Ink::Background] {
                    let contrast = contrast(theme, ink, ground);
                    assert!(
                        contrast >= 3.0,
                        "{theme:?} {ink:?} on {ground:?}: {contrast}"
                    );
                }
            }
            // The current bar of the time line beside others, and the name on it.
            assert!(contrast(theme, Ink::Linked, Ink::Faint) >= 3.0, "{theme:?}");
            assert!(
                contrast(theme, Ink::Surface, Ink::Linked) >= 4.5,
                "{theme:?}"
            );
        }
    }

    #[test]
    fn text_inks_can_be_read_in_every_theme() {
        let text = [
            Ink::Text,
            Ink::Muted,
            Ink::This,
            Ink::Linked,
            Ink::Good,
            Ink::Bad,
            Ink::Warn,
        ];
        let fills = [
            Ink::Background,
            Ink::Faint,
            Ink::ThisTint,
            Ink::LinkedTint,
            Ink::WarnTint,
        ];
        for theme in Theme::ALL {
            for ink in text {
                let ratio = contrast(theme, ink, Ink::Surface);
                assert!(ratio >= 4.5, "{theme:?}: {ink:?} has {ratio:.2}");
            }
            for fill in fills {
                for ink in [Ink::Text, Ink::Muted] {
                    let ratio = contrast(theme, ink, fill);
                    assert!(ratio >= 4.5, "{theme:?}: {ink:?} on {fill:?} {ratio:.2}");
                }
            }
        }
        assert!(contrast(Theme::Projector, Ink::Muted, Ink::Surface) >= 7.0);
    }

    #[test]
    fn scene_colours_are_encoded_as_the_image_is() {
        let grey = Ink::Rgb(Rgb::splat(0.214_041_140_482_232_55));
        assert_eq!(Theme::Dark.color(grey), [128; 3]);
        assert_eq!(
            Theme::Dark.color(Ink::Series(7)),
            Theme::Dark.color(Ink::Text)
        );
        assert_eq!(
            Theme::Light.color(Ink::Series(8)),
            Theme::Light.color(Ink::Series(0))
        );
    }
}
