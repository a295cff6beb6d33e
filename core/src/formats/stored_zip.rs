//! A zip whose files stand in it as they are, each at a multiple of 64 bytes: `.usdz` is one, so that readers can map its
//! files into memory (the USDZ specification; PKWARE's APPNOTE for the rest). All files are of the format's first day.

use std::io::{self, ErrorKind};

const ALIGNED: usize = 64;
/// 1 January 1980.
const DAY: u16 = 1 << 5 | 1;
/// Version 1.0 unpacks it.
const VERSION: u16 = 10;
/// Names are UTF-8.
const FLAGS: u16 = 1 << 11;

/// The zip of files by their names, in that order.
///
/// # Errors
/// If it would be larger than 4 GB, which zips of this kind can't tell.
pub fn write(files: &[(&str, &[u8])]) -> io::Result<Vec<u8>> {
    let mut zip = Vec::new();
    let mut directory = Vec::new();
    for (name, bytes) in files {
        let start = zip.len();
        let head = start + 30 + name.len();
        // A field of its own, with 4 bytes of head, moves what follows.
        let padding = (head + 4).next_multiple_of(ALIGNED) - head;
        let mut about = Vec::new();
        for short in [VERSION, FLAGS, 0, 0, DAY] {
            about.extend_from_slice(&short.to_le_bytes());
        }
        let size = number(bytes.len())?;
        for long in [crc_32(bytes), size, size] {
            about.extend_from_slice(&long.to_le_bytes());
        }
        let lengths = |extra: usize| [name.len() as u16, extra as u16].map(u16::to_le_bytes).concat();
        zip.extend_from_slice(b"PK\x03\x04");
        zip.extend_from_slice(&about);
        zip.extend_from_slice(&lengths(padding));
        zip.extend_from_slice(name.as_bytes());
        zip.extend_from_slice(&[FIELD, (padding - 4) as u16].map(u16::to_le_bytes).concat());
        zip.resize(head + padding, 0);
        zip.extend_from_slice(bytes);
        directory.extend_from_slice(b"PK\x01\x02");
        directory.extend_from_slice(&VERSION.to_le_bytes());
        directory.extend_from_slice(&about);
        directory.extend_from_slice(&lengths(0));
        // No comment, the first disk, no attributes.
        directory.extend_from_slice(&[0; 10]);
        directory.extend_from_slice(&number(start)?.to_le_bytes());
        directory.extend_from_slice(name.as_bytes());
    }
    let (start, size) = (number(zip.len())?, number(directory.len())?);
    zip.append(&mut directory);
    zip.extend_from_slice(b"PK\x05\x06\0\0\0\0");
    zip.extend_from_slice(&[files.len() as u16; 2].map(u16::to_le_bytes).concat());
    zip.extend_from_slice(&[size, start].map(u32::to_le_bytes).concat());
    zip.extend_from_slice(&[0; 2]);
    Ok(zip)
}

/// What the field of zeros is called: a name that no one else has for one.
const FIELD: u16 = 0x1986;

fn number(length: usize) -> io::Result<u32> {
    u32::try_from(length).map_err(|_| io::Error::new(ErrorKind::FileTooLarge, "it would be larger than 4 GB"))
}

/// As ITU-T V.42 has it.
fn crc_32(bytes: &[u8]) -> u32 {
    const TABLE: [u32; 256] = {
        let mut table = [0; 256];
        let mut at = 0;
        while at < 256 {
            let mut rest = at as u32;
            let mut bit = 0;
            while bit < 8 {
                rest = rest >> 1 ^ if rest & 1 == 1 { 0xEDB8_8320 } else { 0 };
                bit += 1;
            }
            table[at] = rest;
            at += 1;
        }
        table
    };
    !bytes.iter().fold(!0, |rest, byte| rest >> 8 ^ TABLE[usize::from(rest as u8 ^ byte)])
}

#[cfg(test)]
mod tests {
    use super::crc_32;

    #[test]
    fn the_check_of_the_standard() {
        assert_eq!(crc_32(b"123456789"), 0xCBF4_3926);
    }
}
