//! A picture as the bytes of a Radiance file (Ward 1991): linear light before exposure and tone curve, three mantissas of
//! 8 bits with a common exponent. What engines take as a sky.

use cloudwright_core::image::LinearPicture;
use image::ImageDecoder;
use image::codecs::hdr::{HdrDecoder, HdrEncoder};

/// The picture's bytes. The same picture gives the same bytes.
///
/// # Errors
/// If there is not enough room for the file.
pub fn encode(picture: &LinearPicture) -> image::ImageResult<Vec<u8>> {
    let mut bytes = Vec::new();
    let pixels: Vec<_> = picture.pixels.iter().map(|pixel| image::Rgb(pixel.to_array())).collect();
    HdrEncoder::new(&mut bytes).encode(&pixels, picture.width as usize, picture.height as usize)?;
    Ok(bytes)
}

/// Whether `bytes` are such a file to its last byte, of that size.
pub fn is_whole(bytes: &[u8], size: [u32; 2]) -> bool {
    let Ok(decoder) = HdrDecoder::new(bytes) else { return false };
    // Before memory is taken for what a file claims to be.
    if decoder.dimensions() != (size[0], size[1]) {
        return false;
    }
    let mut pixels = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut pixels).is_ok()
}
