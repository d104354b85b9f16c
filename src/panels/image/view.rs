//! What of the picture is looked at, and what of its pixels.

use crate::figure::View;
use crate::language::Message;

named! {
    /// What is shown of each pixel.
    pub enum PixelLayer {
        Color = "color",
        /// Along the view: the depth buffer.
        Depth = "depth",
        /// The object that is nearest at the pixel's centre.
        Object = "object",
        /// N there, toward the eye.
        Normal = "normal",
        /// How many rays the pixel took.
        Rays = "rays",
    }
}

impl PixelLayer {
    pub fn title(self) -> Message {
        match self {
            PixelLayer::Color => Message("image-layer-color"),
            PixelLayer::Depth => Message("image-layer-depth"),
            PixelLayer::Object => Message("image-layer-object"),
            PixelLayer::Normal => Message("image-layer-normal"),
            PixelLayer::Rays => Message("image-layer-rays"),
        }
    }
}

/// The part of the picture that is drawn; where no place was chosen for its middle, it follows the current pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImageView {
    pub shown: View,
    pub layer: PixelLayer,
}

impl ImageView {
    /// The whole picture in its colours.
    pub const WHOLE: ImageView = ImageView {
        shown: View::WHOLE,
        layer: PixelLayer::Color,
    };
}
