//! The light aircraft that ships with Cloudwright: a four-seater of the high-winged kind, drawn by the project itself.
//!
//! 11 m of span, 8 m long. Axes as in a model's file: +x over the right wing, +y up, the nose along −z, metres. The
//! origin is the centre of gravity, on the propeller's axis. Every part is a loft: cross sections, and a skin over them.

mod fuselage;
mod gear;
mod glb;
mod propeller;
mod solid;
mod wings;

use solid::Solid;

/// assets/models/aircraft.glb, made anew.
pub fn glb() -> Vec<u8> {
    let mut aircraft = Solid::default();
    for part in [fuselage::body(), wings::all(), gear::all(), propeller::all()] {
        aircraft.add(part);
    }
    glb::write(&aircraft)
}
