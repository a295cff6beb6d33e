//! stub
use crate::frame::Frame;
use crate::image::{LinearPicture, Picture};

/// The frame as a display shows it, one sample at each pixel's centre.
pub fn picture(frame: &Frame<'_>) -> Picture {
    super::plain::picture(frame)
}

/// The frame in linear light, before exposure.
pub fn linear_picture(frame: &Frame<'_>) -> LinearPicture {
    super::plain::linear_picture(frame)
}
