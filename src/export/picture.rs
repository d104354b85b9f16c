//! The finished picture of a scene, and pictures of panels.

use super::making::Making;
use crate::algorithms::frame::Frame;
use crate::color::{Rgb, pfm, png_rgb8};
use crate::picture::{Picture, Theme, rasterize, to_png, to_svg};
use std::io;

/// The whole picture: as a PNG scaled by `factor` and with 8 bits a channel, or as it is, in a PFM.
pub fn whole_picture(frame: &Frame, ending: &str, factor: f64) -> Making<'static> {
    let height = frame.rows.len() as u32;
    Making::of(match ending {
        "pfm" => pfm(frame.width, height, &frame.color),
        _ => {
            let colors = frame.color.iter();
            let pixels = colors.flat_map(|&color: &Rgb| (color * factor).to_srgb8());
            png_rgb8(frame.width, height, &pixels.collect::<Vec<u8>>())
        }
    })
}

/// A panel of that title: as SVG, or as a PNG with `scale` pixels to a point.
pub fn panel(
    picture: &Picture,
    title: &str,
    theme: Theme,
    ending: &str,
    scale: f32,
) -> io::Result<Making<'static>> {
    Ok(Making::of(match ending {
        "svg" => to_svg(picture, title, theme).into_bytes(),
        _ => to_png(&rasterize(picture, theme, scale).map_err(io::Error::other)?),
    }))
}
