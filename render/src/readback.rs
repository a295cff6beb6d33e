//! Textures back to memory, in bands of rows that fit the device's buffers, and 16-bit floats to 32.

use crate::{Gpu, RenderError};
use std::sync::mpsc;

/// A band's size, bytes, before rounding to whole rows.
const BAND_BYTES: u64 = 64 << 20;

/// All bytes of a texture of `texel_bytes` a texel, top row first, without padding.
pub(crate) fn read_texture(gpu: &Gpu, texture: &wgpu::Texture, texel_bytes: u32) -> Result<Vec<u8>, RenderError> {
    let row_bytes = texture.width() * texel_bytes;
    let padded = row_bytes.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let band_bytes = BAND_BYTES.min(gpu.device().limits().max_buffer_size);
    let band = ((band_bytes / u64::from(padded)) as u32).clamp(1, texture.height());
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size: u64::from(padded) * u64::from(band),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    // Software OpenGL on a busy machine now and then copies before it has drawn.
    gpu.wait_until(|| true)?;
    let mut bytes = Vec::with_capacity(row_bytes as usize * texture.height() as usize);
    for first_row in (0..texture.height()).step_by(band as usize) {
        let rows = band.min(texture.height() - first_row);
        copy_rows(gpu, texture, &buffer, first_row..first_row + rows, padded);
        read_buffer(gpu, &buffer, |mapped| {
            for row in mapped.chunks_exact(padded as usize).take(rows as usize) {
                bytes.extend_from_slice(&row[..row_bytes as usize]);
            }
        })?;
    }
    Ok(bytes)
}

fn copy_rows(gpu: &Gpu, texture: &wgpu::Texture, buffer: &wgpu::Buffer, rows: std::ops::Range<u32>, padded: u32) {
    let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("readback") });
    encoder.copy_texture_to_buffer(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d { x: 0, y: rows.start, z: 0 },
            aspect: wgpu::TextureAspect::All,
        },
        wgpu::TexelCopyBufferInfo {
            buffer,
            layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded), rows_per_image: None },
        },
        wgpu::Extent3d { width: texture.width(), height: rows.len() as u32, depth_or_array_layers: 1 },
    );
    gpu.queue().submit([encoder.finish()]);
}

/// Maps `buffer`, shows its bytes to `read`, unmaps it.
pub(crate) fn read_buffer(gpu: &Gpu, buffer: &wgpu::Buffer, read: impl FnOnce(&[u8])) -> Result<(), RenderError> {
    let (sender, receiver) = mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |answer| {
        // The receiver is gone only if waiting was given up.
        let _ = sender.send(answer);
    });
    let mut answer = None;
    gpu.wait_until(|| {
        answer = answer.take().or_else(|| receiver.try_recv().ok());
        answer.is_some()
    })?;
    match answer {
        Some(Ok(())) => {
            let mapped = buffer.get_mapped_range(..).map_err(|error| RenderError::Refused(error.to_string()))?;
            read(&mapped);
        }
        Some(Err(error)) => return Err(RenderError::Refused(error.to_string())),
        None => return Err(RenderError::Refused("a picture could not be read back".into())),
    }
    buffer.unmap();
    Ok(())
}

/// Texels of four 16-bit floats as 32-bit ones.
pub(crate) fn texels_from_f16(bytes: &[u8]) -> impl Iterator<Item = [f32; 4]> + '_ {
    bytes
        .as_chunks::<8>()
        .0
        .iter()
        .map(|texel| std::array::from_fn(|c| f32_from_f16(u16::from_le_bytes([texel[2 * c], texel[2 * c + 1]]))))
}

/// IEEE 754 binary16 to binary32, exact.
fn f32_from_f16(bits: u16) -> f32 {
    let sign = u32::from(bits >> 15) << 31;
    let (exponent, fraction) = (u32::from(bits >> 10) & 31, u32::from(bits & 1023));
    let magnitude = match exponent {
        0 => return f32::from_bits(sign | (fraction as f32 * 2.0_f32.powi(-24)).to_bits()),
        31 => 0x7f80_0000 | (fraction << 13),
        _ => ((exponent + 112) << 23) | (fraction << 13),
    };
    f32::from_bits(sign | magnitude)
}

#[cfg(test)]
mod tests {
    use super::f32_from_f16;

    #[test]
    fn halves_are_exact() {
        for (bits, want) in [
            (0x0000, 0.0),
            (0x0001, 2.0_f32.powi(-24)),
            (0x03ff, 1023.0 * 2.0_f32.powi(-24)),
            (0x0400, 2.0_f32.powi(-14)),
            (0x3c00, 1.0),
            (0x3c01, 1.0 + 2.0_f32.powi(-10)),
            (0xc500, -5.0),
            (0x7bff, 65504.0),
            (0x7c00, f32::INFINITY),
        ] {
            assert_eq!(f32_from_f16(bits), want, "{bits:#06x}");
        }
        assert!(f32_from_f16(0x7e00).is_nan());
    }
}
