//! Prints how much a view changes along the test flights, for every way of locking and sorting.

use cloudwright_tests::stability::{flights, methods, pixel_change, scene, sprite_changes};
use std::io::Write;

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "Largest change a metre, times the sprite's lock distance: of its alpha, its facing, its up (weighted by"
    )?;
    writeln!(out, "alpha); and of any pixel from frame to frame beyond the truth's own, linear light.\n")?;
    writeln!(out, "{:<20} {:<15} {:>9} {:>9} {:>9} {:>9}", "method", "flight", "alpha", "facing", "up", "pixel")?;
    let scene = scene();
    for (name, rule, sorting) in methods() {
        for flight in flights() {
            let sprites = sprite_changes(&scene, &flight.cameras, rule);
            let pixel = pixel_change(&scene, &flight.cameras, (rule, sorting), 4);
            let (alpha, facing, up) = (sprites.fade, sprites.facing, sprites.up);
            writeln!(out, "{name:<20} {:<15} {alpha:>9.2} {facing:>9.2} {up:>9.2} {pixel:>9.4}", flight.name)?;
        }
    }
    Ok(())
}
