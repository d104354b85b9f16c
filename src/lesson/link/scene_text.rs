//! The text of a scene within an address: deflated (RFC 1951), and written in the letters that an address may have (RFC 4648, base64url).

use base64::Engine;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::{DeflateDecoder, DeflateEncoder};
use std::io::Read;

/// What browsers, chats and slides take without cutting it off.
const LONGEST: usize = 8000;
/// Of a scene's text, in bytes.
const LARGEST: u64 = 1 << 20;

/// None where the address would be too long.
pub fn pack(text: &[u8]) -> Option<String> {
    let mut packed = Vec::new();
    let mut encoder = DeflateEncoder::new(text, Compression::best());
    // A slice can always be read.
    encoder.read_to_end(&mut packed).ok()?;
    let packed = BASE64_URL_SAFE_NO_PAD.encode(packed);
    (packed.len() <= LONGEST).then_some(packed)
}

/// Errors: what is wrong with the address.
pub fn unpack(packed: &str) -> Result<Vec<u8>, String> {
    let cut = || "the scene in the address is not whole; copy the address again".to_owned();
    let bytes = BASE64_URL_SAFE_NO_PAD.decode(packed);
    let bytes = bytes.map_err(|_| cut())?;
    let mut text = Vec::new();
    let mut decoder = DeflateDecoder::new(&*bytes).take(LARGEST + 1);
    decoder.read_to_end(&mut text).map_err(|_| cut())?;
    match text.len() as u64 > LARGEST {
        true => Err("the scene in the address has more than 1 MiB of text".into()),
        false => Ok(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_comes_back_and_what_is_cut_or_too_large_is_refused() {
        let scene = include_bytes!("../../../lessons/scenes/cornell-box.json");
        let packed = pack(scene).unwrap();
        assert!(packed.len() < scene.len() / 2, "{}", packed.len());
        assert_eq!(unpack(&packed).unwrap(), scene);
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
        assert!(packed.chars().all(plain), "{packed}");

        for cut in [&packed[..packed.len() / 2], "####", &format!("{packed}!")] {
            assert!(unpack(cut).unwrap_err().contains("not whole"), "{cut}");
        }
        let spaces = pack(&vec![b' '; 2 << 20]).unwrap();
        assert!(unpack(&spaces).unwrap_err().contains("1 MiB"));
        let mut random = crate::numeric::Random(1);
        let noise: Vec<u8> = (0..20_000).map(|_| random.bits() as u8).collect();
        assert_eq!(pack(&noise), None);
    }
}
