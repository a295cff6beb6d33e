//! The frames of a flight: which there are, what their files are called, and whether one is there whole.

use crate::cli::counted;
use crate::cli::failure::Failure;
use crate::storage::{self, Folder, StorageError};
use cloudwright_core::scene::{CameraPath, Scene};
use std::io::Cursor;
use std::ops::Range;
use std::path::PathBuf;

/// No PNG of the largest picture is larger, bytes.
const MAX_FRAME_BYTES: usize = 1 << 30;

/// Where the frames of one run lie.
pub(super) struct Frames {
    pub(super) folder: PathBuf,
    /// Of the flight, fit for a file's name, and no other flight's of the scene.
    pub(super) path_name: String,
    /// Width and height, pixels.
    pub(super) size: [u32; 2],
    pub(super) numbers: Range<u32>,
}

impl Frames {
    pub(super) fn file(&self, number: u32) -> PathBuf {
        self.folder.join(format!("{}_{number:05}.png", self.path_name))
    }

    /// Those that lie there already, from whatever run.
    pub(super) fn there(&self) -> Vec<PathBuf> {
        // On some disks a name in other letters, small or large, is the same.
        let prefix = format!("{}_", self.path_name).to_lowercase();
        let is_frame = |name: &PathBuf| {
            let name = name.to_string_lossy().to_lowercase();
            let number = name.strip_prefix(&prefix).and_then(|rest| rest.strip_suffix(".png")?.parse().ok());
            number.is_some_and(|number| self.numbers.contains(&number))
        };
        storage::names_in(&self.folder).into_iter().filter(is_frame).map(|name| self.folder.join(name)).collect()
    }

    /// Makes the folder, and sees whether the frames can be written there.
    pub(super) fn make_folder(&self) -> Result<Folder, StorageError> {
        let folder = Folder::make(&self.folder)?;
        // The last has the longest name.
        storage::check_writable(&self.file(self.numbers.end - 1))?;
        Ok(folder)
    }

    /// Whether the frame is there to its last byte, in this size.
    pub(super) fn is_whole(&self, number: u32) -> bool {
        storage::read(&self.file(number), MAX_FRAME_BYTES).is_ok_and(|bytes| is_whole_png(&bytes, self.size))
    }
}

fn is_whole_png(bytes: &[u8], size: [u32; 2]) -> bool {
    let Ok(mut reader) = png::Decoder::new(Cursor::new(bytes)).read_info() else { return false };
    // Before memory is taken for what a file claims to be.
    if [reader.info().width, reader.info().height] != size {
        return false;
    }
    let Some(length) = reader.output_buffer_size() else { return false };
    reader.next_frame(&mut vec![0; length]).is_ok() && reader.finish().is_ok()
}

/// `A..B` as frame numbers.
pub(super) fn range(text: &str) -> Result<Range<u32>, String> {
    text.split_once("..")
        .and_then(|(first, end)| Some(first.parse().ok()?..end.parse().ok()?))
        .filter(|range| !range.is_empty())
        .ok_or_else(|| "write the first frame and the one after the last, such as 0..90".into())
}

/// The frames asked for, or all of a flight: the first at its start, the last not after its end.
pub(super) fn chosen(asked: Option<Range<u32>>, duration_s: f64, fps: u32) -> Result<Range<u32>, Failure> {
    // A path of 0.7 s has a frame at its end at any rate that meets it, whatever 0.7 × 30 is in binary.
    let last = (duration_s * f64::from(fps) + 1e-6).floor();
    if last >= f64::from(u32::MAX) {
        return Err(Failure::argument(format!("the flight has {last} frames"), "lower --fps, or shorten the path"));
    }
    let count = last as u32 + 1;
    match asked {
        Some(range) if range.end > count => Err(Failure::argument(
            format!(
                "--frames {}..{}: the flight has {} at --fps {fps}",
                range.start,
                range.end,
                counted(count as usize, "frame", "frames")
            ),
            format!("stay within 0..{count}"),
        )),
        Some(range) => Ok(range),
        None => Ok(0..count),
    }
}

/// A path's name as a part of files' names, on any system: another one for each path of `scene`, for one that would share
/// the name of an earlier one is numbered.
pub(super) fn file_name_of(path: &CameraPath, scene: &Scene) -> String {
    let mut taken: Vec<String> = Vec::new();
    for one in scene.paths.iter() {
        let plain = plain_name(&one.name);
        let numbered = (2..).map(|number| format!("{plain}-{number}"));
        let is_free = |name: &String| !taken.contains(&name.to_lowercase());
        let name = std::iter::once(plain.clone()).chain(numbered).find(is_free).unwrap_or_default();
        if one.id == path.id {
            return name;
        }
        taken.push(name.to_lowercase());
    }
    plain_name(&path.name)
}

fn plain_name(path_name: &str) -> String {
    let name: String = path_name.chars().map(|c| if c.is_alphanumeric() || c == '-' { c } else { '_' }).collect();
    if name.is_empty() { "path".into() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::PathId;

    #[test]
    fn ranges() {
        assert_eq!(range("4..7"), Ok(4..7));
        for bad in ["", "..", "4", "4..", "..7", "7..4", "4..4", "4..=7", "-1..3", "0..99999999999"] {
            assert!(range(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_flight_has_a_frame_at_either_end() {
        for (duration_s, fps, count) in [(1.0, 30, 31), (0.7, 30, 22), (0.29, 100, 30), (0.99, 1, 1), (12.0, 240, 2881)]
        {
            let all = chosen(None, duration_s, fps).expect("not many");
            assert_eq!(all, 0..count, "{duration_s} s at {fps}");
            assert!(chosen(Some(0..count), duration_s, fps).is_ok());
            assert!(chosen(Some(0..count + 1), duration_s, fps).is_err());
        }
        assert!(chosen(None, 1e9, 240).is_err());
    }

    #[test]
    fn each_path_has_a_name_of_its_own() {
        let names = ["through", "a/b %d:c", "..", "", "a_b__d_c", "A_B__D_C", "a_b__d_c-2", "path", "through"];
        let path = |(id, &name): (u64, &&str)| CameraPath::new(PathId(id), name, Vec::new());
        let paths = (1..).zip(&names).map(path).collect();
        let scene = Scene { paths, ..Scene::default() };
        let found: Vec<String> = scene.paths.iter().map(|path| file_name_of(path, &scene)).collect();
        let wanted =
            ["through", "a_b__d_c", "__", "path", "a_b__d_c-2", "A_B__D_C-3", "a_b__d_c-2-2", "path-2", "through-2"];
        assert_eq!(found, wanted);
    }
}
