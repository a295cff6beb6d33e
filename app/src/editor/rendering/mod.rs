//! Pictures out of the window: into a file, onto the clipboard, or as a film. All are drawn off the frame.

mod copying;
mod film;
mod picture;

pub(super) use copying::Copying;
pub(super) use film::Filming;
pub(super) use picture::Rendering;

use std::sync::Mutex;

/// What a painter leaves out or does otherwise is told when the picture is there. Its name is no news.
#[derive(Default)]
struct Told(Mutex<Vec<String>>);

impl Told {
    fn tell(&self, line: &str) {
        if let Ok(mut lines) = self.0.lock() {
            lines.push(line.to_owned());
        }
    }

    /// All but the first, by which the renderer says who it is.
    fn news(self) -> Vec<String> {
        self.0.into_inner().unwrap_or_default().into_iter().skip(1).collect()
    }
}
