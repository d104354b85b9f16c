//! Classic mistakes in programs that render: which there are, what they are called, and by which methods one can make them. What they
//! do to a picture stands in `study::mistakes`.

use super::{Family, Method};
use crate::language::{Language, called};

named! {
    /// A mistake, by its name in `compare`.
    pub enum Mistake {
        /// η inside is taken for 1/η.
        EtaInverted = "eta_inverted",
        /// What lies behind a light casts a shadow too.
        ShadowIgnoresLightDistance = "shadow_ignores_light_distance",
        /// The angle of the camera is taken for its height.
        FovVertical = "fov_vertical",
        /// The angle of the camera is taken for its half.
        FovHalfAngle = "fov_half_angle",
        /// Upside down.
        FlipY = "flip_y",
        /// Left and right changed places.
        MirrorX = "mirror_x",
        /// Pixels written column by column where rows are meant.
        ColumnsFirst = "columns_first",
        /// Width and height change places in the header of the file, or where the picture is drawn.
        SidesSwapped = "sides_swapped",
        /// Rays through the corners of pixels instead of their centres.
        HalfPixelOff = "half_pixel_off",
        /// Linear numbers written for the screen.
        NoSrgb = "no_srgb",
        /// Encoded for the screen once too often.
        SrgbTwice = "srgb_twice",
        /// The ambient term added once a light.
        AmbientPerLight = "ambient_per_light",
        /// Lights are as bright at any distance.
        NoAttenuation = "no_attenuation",
        /// One level of the ray tree too few.
        DepthMinusOne = "depth_minus_one",
        /// One level too many.
        DepthPlusOne = "depth_plus_one",
        /// k_r is left out, so mirrors are dull.
        ReflectionForgotten = "reflection_forgotten",
        /// N is not turned toward the ray: dark inside, and on the backs of polygons.
        NormalNotFlipped = "normal_not_flipped",
        /// N as long as it comes out of the equation of the surface.
        NormalNotNormalized = "normal_not_normalized",
        /// A ray that leaves the glass is refracted as if it entered.
        EtaNotSwappedOnLeaving = "eta_not_swapped_on_leaving",
        /// Shadow rays start on the surface itself, and some meet it.
        NoShadowOffset = "no_shadow_offset",
        /// N·L below 0 takes light away.
        CosNotClamped = "cos_not_clamped",
        /// Highlights where N·L ≤ 0.
        SpecularWithoutNdotl = "specular_without_ndotl",
        /// R = u + 2(u·N)N.
        ReflectSign = "reflect_sign",
        /// L leads from the light to the point.
        LightToPoint = "light_to_point",
        /// Nothing comes back where the reflection is total.
        TirBlack = "tir_black",
        /// Vertex normals are means weighted by the areas of the faces.
        VertexNormalsByArea = "vertex_normals_by_area",
        /// Patches gather with F_ji in place of F_ij.
        FormFactorTransposed = "form_factor_transposed",
        /// ρ is left out, so patches reflect all light.
        ReflectanceForgotten = "reflectance_forgotten",
        /// Form factors are divided by π once more.
        PiTwice = "pi_twice",
        /// L is as long as the light is far away.
        LightNotNormalized = "light_not_normalized",
        /// The ambient term is left out.
        AmbientForgotten = "ambient_forgotten",
        /// The cosine of the highlight is not raised to n.
        ExponentForgotten = "exponent_forgotten",
        /// R·V where N·H is meant, or N·H where R·V is.
        HighlightSwapped = "highlight_swapped",
        /// No ray goes to the lights.
        NoShadows = "no_shadows",
        /// Both ends of a span are drawn, rounded outward, and so are the first and the last row.
        InclusiveScanRule = "inclusive_scan_rule",
        /// Red and blue changed places.
        ChannelsSwapped = "channels_swapped",
    }
}

/// The methods whose scan conversion can be done wrong in place of the textbook body's.
const SCAN_CONVERTED: [Method; 3] = [Method::Flat, Method::Gouraud, Method::Phong];

impl Mistake {
    /// What is wrong, in a few words.
    pub fn in_words(self, language: Language) -> String {
        called("mistake", self.name(), language).unwrap_or_else(|| self.name().into())
    }

    /// The same as a title: with a capital letter.
    pub fn title(self, language: Language) -> String {
        let words = self.in_words(language);
        let mut letters = words.chars();
        match (letters.next(), letters.next()) {
            // But not sRGB, or a symbol.
            (Some(first), Some(second)) if first.is_ascii_lowercase() && !second.is_uppercase() => {
                let rest = &words[first.len_utf8()..];
                format!("{}{rest}", first.to_ascii_uppercase())
            }
            _ => words,
        }
    }

    /// What is wrong, and what to look for in a picture.
    pub fn about(self, language: Language) -> String {
        called("mistake-about", self.name(), language).unwrap_or_default()
    }

    /// Whether a program that draws by that method can make it at all.
    pub fn concerns(self, method: Method) -> bool {
        let family = method.family();
        match self {
            Mistake::EtaInverted
            | Mistake::EtaNotSwappedOnLeaving
            | Mistake::ShadowIgnoresLightDistance
            | Mistake::NoShadowOffset
            | Mistake::TirBlack
            | Mistake::DepthMinusOne
            | Mistake::DepthPlusOne
            | Mistake::NoShadows
            | Mistake::ReflectionForgotten => method == Method::RayTracing,
            Mistake::NormalNotFlipped
            | Mistake::NormalNotNormalized
            | Mistake::CosNotClamped
            | Mistake::SpecularWithoutNdotl
            | Mistake::ReflectSign
            | Mistake::LightToPoint
            | Mistake::LightNotNormalized => {
                family == Family::Rays || SCAN_CONVERTED.contains(&method)
            }
            Mistake::InclusiveScanRule => SCAN_CONVERTED.contains(&method),
            Mistake::VertexNormalsByArea => {
                [Method::Gouraud, Method::Phong, Method::FastPhong].contains(&method)
            }
            Mistake::FormFactorTransposed | Mistake::ReflectanceForgotten | Mistake::PiTwice => {
                family == Family::Exchange
            }
            Mistake::AmbientPerLight
            | Mistake::AmbientForgotten
            | Mistake::ExponentForgotten
            | Mistake::HighlightSwapped
            | Mistake::NoAttenuation => !family.exchanges_light(),
            Mistake::FovVertical
            | Mistake::FovHalfAngle
            | Mistake::FlipY
            | Mistake::MirrorX
            | Mistake::ColumnsFirst
            | Mistake::SidesSwapped
            | Mistake::HalfPixelOff
            | Mistake::NoSrgb
            | Mistake::SrgbTwice
            | Mistake::ChannelsSwapped => true,
        }
    }
}
