// The air inside a cloud, before everything.

@fragment
fn draw_veil() -> @location(0) vec4f {
    return frame.veil;
}
