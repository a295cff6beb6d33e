//! The frames of a flight: which there are, what their files are called, and whether one is there whole.

use super::NoFlight;
use crate::picture_hdr;
use crate::picture_kind::PictureKind;
use crate::storage::{self, Folder, StorageError};
use cloudwright_core::formats::picture_exr;
use cloudwright_core::scene::{Camera, Scene, Thing};
use std::io::Cursor;
use std::ops::Range;
use std::path::PathBuf;

/// No PNG of the largest picture is larger, nor any file of layers that fits into memory, bytes.
const MAX_FRAME_BYTES: usize = 1 << 31;

/// Where the frames of one run lie.
pub(super) struct Frames {
    pub(super) folder: PathBuf,
    /// Of path or camera, fit for a file's name, and no other's of the scene.
    pub(super) name: String,
    pub(super) kind: PictureKind,
    pub(super) in_layers: bool,
    /// Width and height, pixels.
    pub(super) size: [u32; 2],
    pub(super) numbers: Range<u32>,
}

impl Frames {
    pub(super) fn file(&self, number: u32) -> PathBuf {
        self.folder.join(format!("{}_{number:05}.{}", self.name, self.kind.ending()))
    }

    /// Those that lie there already, from whatever run.
    pub(super) fn there(&self) -> Vec<PathBuf> {
        // On some disks a name in other letters, small or large, is the same.
        let prefix = format!("{}_", self.name).to_lowercase();
        let suffix = format!(".{}", self.kind.ending());
        let is_frame = |name: &PathBuf| {
            let name = name.to_string_lossy().to_lowercase();
            let number = name.strip_prefix(&prefix).and_then(|rest| rest.strip_suffix(&suffix)?.parse().ok());
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
        storage::read(&self.file(number), MAX_FRAME_BYTES).is_ok_and(|bytes| match self.kind {
            PictureKind::Png => is_whole_png(&bytes, self.size),
            PictureKind::Exr => picture_exr::is_whole(&bytes, self.size, self.in_layers),
            PictureKind::Hdr => picture_hdr::is_whole(&bytes, self.size),
        })
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

/// `A..B` as frame numbers; or `A-B`, where B is the last, and `A` alone.
pub(crate) fn range(text: &str) -> Result<Range<u32>, String> {
    let number = |text: &str| text.parse::<u32>().ok();
    let parted = match text.split_once("..") {
        Some((first, end)) => number(first).zip(number(end)),
        None => {
            let (first, last) = text.split_once('-').unwrap_or((text, text));
            number(first).zip(number(last).and_then(|last| last.checked_add(1)))
        }
    };
    parted
        .map(|(first, end)| first..end)
        .filter(|range| !range.is_empty())
        .ok_or_else(|| "write the first frame and the one after the last, such as 0..90, or both, such as 0-89".into())
}

/// How many frames a film of `duration_s` has: the first at its start, the last not after its end.
///
/// # Errors
/// If their numbers can't be counted.
pub(crate) fn count(duration_s: f64, fps: u32) -> Result<u32, NoFlight> {
    // A path of 0.7 s has a frame at its end at any rate that meets it, whatever 0.7 × 30 is in binary.
    let last = (duration_s * f64::from(fps) + 1e-6).floor();
    if last >= f64::from(u32::MAX) { Err(NoFlight::TooMany(last)) } else { Ok(last as u32 + 1) }
}

/// The name of a path or camera of `scene` as a part of files' names, on any system: another one for each of them, for one
/// that would share the name of an earlier one is numbered.
pub(super) fn file_name_of(thing: Thing, scene: &Scene) -> String {
    let paths = scene.paths.iter().map(|path| (Thing::Path(path.id), plain_name(&path.name)));
    let still = |camera: &Camera| (Thing::Camera(camera.id), format!("still_{}", plain_name(&camera.name)));
    let mut taken: Vec<String> = Vec::new();
    for (one, plain) in paths.chain(scene.cameras.iter().map(still)) {
        let numbered = (2..).map(|number| format!("{plain}-{number}"));
        let is_free = |name: &String| !taken.contains(&name.to_lowercase());
        let name = std::iter::once(plain.clone()).chain(numbered).find(is_free).unwrap_or_default();
        if one == thing {
            return name;
        }
        taken.push(name.to_lowercase());
    }
    plain_name("")
}

fn plain_name(name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_alphanumeric() || c == '-' { c } else { '_' }).collect();
    if name.is_empty() { "path".into() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::{CameraId, CameraPath, PathId};

    #[test]
    fn ranges() {
        assert_eq!(range("4..7"), Ok(4..7));
        assert_eq!((range("4-6"), range("4-4"), range("4")), (Ok(4..7), Ok(4..5), Ok(4..5)));
        for bad in ["", "..", "-", "4-", "-4", "7-4", "4..", "..7", "7..4", "4..4", "4..=7", "-1..3", "0..99999999999"]
        {
            assert!(range(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_flight_has_a_frame_at_either_end() {
        for (duration_s, fps, count) in [(1.0, 30, 31), (0.7, 30, 22), (0.29, 100, 30), (0.99, 1, 1), (12.0, 240, 2881)]
        {
            assert_eq!(super::count(duration_s, fps).expect("not many"), count, "{duration_s} s at {fps}");
        }
        assert!(count(1e9, 240).is_err());
    }

    #[test]
    fn each_path_has_a_name_of_its_own() {
        let names =
            ["through", "a/b %d:c", "..", "", "a_b__d_c", "A_B__D_C", "a_b__d_c-2", "path", "through", "still/main"];
        let path = |(id, &name): (u64, &&str)| CameraPath::new(PathId(id), name, Vec::new());
        let paths = (1..).zip(&names).map(path).collect();
        let camera = |(id, name): (u64, &str)| Camera::new(CameraId(id), name, glam::DVec3::ZERO);
        let cameras = [(50, "main"), (51, "a/b"), (52, "A_B")].map(camera).into_iter().collect();
        let scene = Scene { paths, cameras, ..Scene::default() };
        let found: Vec<String> = scene.paths.iter().map(|path| file_name_of(Thing::Path(path.id), &scene)).collect();
        let stills = [50, 51, 52].map(|id| file_name_of(Thing::Camera(CameraId(id)), &scene));
        assert_eq!(stills, ["still_main-2", "still_a_b", "still_A_B-2"], "beside a path “still/main”");
        let wanted = [
            "through",
            "a_b__d_c",
            "__",
            "path",
            "a_b__d_c-2",
            "A_B__D_C-3",
            "a_b__d_c-2-2",
            "path-2",
            "through-2",
            "still_main",
        ];
        assert_eq!(found, wanted);
    }
}
