//! What every shader knows of a frame: the view, the light, the background. The twin of `Frame` in shader/frame.wgsl.

use cloudwright_core::color::Rgb;
use cloudwright_core::frame::Frame;
use cloudwright_core::sky::{GROUND_CELLS_M, GROUND_PERIOD_M, HORIZON_SINE, MOON_RADIUS, SUN_DISC_COSINES};
use cloudwright_core::{camera, facing};

/// Declares the uniform, and its members' names and offsets for the test that compares them with the shader.
macro_rules! uniform {
    ($(#[$doc:meta])* struct $name:ident { $($member:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
        #[repr(C)]
        pub(crate) struct $name { $($member: $type,)* }

        impl $name {
            pub(crate) const MEMBERS: &[(&str, usize)] = &[$((stringify!($member), std::mem::offset_of!($name, $member)),)*];
        }
    };
}

uniform! {
    /// Rows of 16 bytes; every vector of three is followed by a number.
    struct FrameUniform {
        right_in_world: [f32; 3],
        pixel: f32,
        up_in_world: [f32; 3],
        width_px: f32,
        forward_in_world: [f32; 3],
        height_px: f32,
        light_direction: [f32; 3],
        haze_length_m: f32,
        ambient_max: [f32; 4],
        directional_max: [f32; 3],
        exposure: f32,
        dome_parameters: [[f32; 4]; 9],
        dome_scale: [f32; 3],
        near_m: f32,
        sun_disc: [f32; 3],
        ground_eye_height_m: f32,
        dome_sun_direction: [f32; 3],
        ground_period_m: f32,
        glow_direction: [f32; 3],
        horizon_sine: f32,
        ground_dark: [f32; 3],
        sun_disc_cosine_from: f32,
        ground_bright: [f32; 3],
        sun_disc_cosine_to: f32,
        ground_eye_in_pattern_m: [f32; 2],
        pole_sines: [f32; 2],
        ground_cells_m: [f32; 4],
        veil: [f32; 4],
        air_lean: [f32; 3],
        air_turned: f32,
        air_lean_shear: [f32; 3],
        air_turbulence: f32,
        air_swings: [f32; 3],
        air_humidity: f32,
        glow_overhead: [f32; 3],
        stars: f32,
        glow_at_horizon: [f32; 3],
        moon: f32,
        moon_direction: [f32; 3],
        moon_radius: f32,
        celestial_from_world: [[f32; 4]; 3],
        shadow_level: [f32; 3],
        shadow_eye_x: f32,
        shadow_upwards: [f32; 3],
        shadow_eye_y: f32,
        ground_without_sun: [f32; 3],
        shadow_share: f32,
        shadow_texel_m: [f32; 2],
        unused: [f32; 2],
    }
}

impl FrameUniform {
    pub(crate) fn new(frame: &Frame<'_>) -> Self {
        let Frame { view, now, background, .. } = frame;
        let light = &now.light;
        let dome = &background.dome;
        let [red, green, blue] = &dome.parameters;
        let ground = background.ground.as_ref();
        let radiance = |color: Option<Rgb>| color.unwrap_or(Rgb::BLACK).to_array();
        let air = now.air();
        let night = dome.night.as_ref();
        let plane = now.shadows.and_then(|shadows| shadows.plane);
        let axes = now.shadows.map(|shadows| shadows.axes());
        let eye = plane.as_ref().map_or([0.0; 2], |plane| plane.place(view.eye));
        let axis = |i: usize| axes.map_or([0.0; 3], |axes| axes[i].to_array());
        let glow = |i: usize| radiance(night.map(|night| night.glow[i]));
        Self {
            right_in_world: view.right.to_array(),
            pixel: view.pixel(),
            up_in_world: view.up.to_array(),
            width_px: view.width as f32,
            forward_in_world: view.forward.to_array(),
            height_px: view.height as f32,
            light_direction: light.direction.to_array(),
            haze_length_m: background.haze_length_m,
            ambient_max: light.ambient_max.to_array(),
            directional_max: light.directional_max.to_array(),
            exposure: now.exposure,
            dome_parameters: std::array::from_fn(|i| [red[i], green[i], blue[i], 0.0]),
            dome_scale: dome.scale.to_array(),
            near_m: camera::NEAR_M,
            sun_disc: dome.sun_disc.to_array(),
            ground_eye_height_m: ground.map_or(0.0, |g| g.eye_height),
            dome_sun_direction: dome.sun_direction.to_array(),
            ground_period_m: GROUND_PERIOD_M as f32,
            glow_direction: dome.glow_direction.to_array(),
            horizon_sine: HORIZON_SINE,
            ground_dark: radiance(ground.map(|g| g.dark)),
            sun_disc_cosine_from: SUN_DISC_COSINES[0],
            ground_bright: radiance(ground.map(|g| g.bright)),
            sun_disc_cosine_to: SUN_DISC_COSINES[1],
            ground_eye_in_pattern_m: ground.map_or([0.0; 2], |g| g.eye_in_pattern),
            pole_sines: facing::upright::POLE,
            ground_cells_m: GROUND_CELLS_M,
            veil: [frame.veil.r, frame.veil.g, frame.veil.b, frame.veil.a],
            air_lean: air.map_or([0.0; 3], |air| air.lean.to_array()),
            air_turned: air.map_or(0.0, |air| air.turned),
            air_lean_shear: air.map_or([0.0; 3], |air| air.lean_shear.to_array()),
            air_turbulence: air.map_or(0.0, |air| air.turbulence),
            air_swings: air.map_or([0.0; 3], |air| air.swings),
            air_humidity: air.map_or(1.0, |air| air.humidity),
            glow_overhead: glow(0),
            stars: night.map_or(0.0, |night| night.stars),
            glow_at_horizon: glow(1),
            moon: night.map_or(0.0, |night| night.moon),
            moon_direction: night.map_or([0.0; 3], |night| night.moon_direction.to_array()),
            moon_radius: MOON_RADIUS,
            celestial_from_world: night.map_or([[0.0; 4]; 3], |night| {
                night.celestial_from_world.to_cols_array_2d().map(|[x, y, z]| [x, y, z, 0.0])
            }),
            shadow_level: axis(0),
            shadow_eye_x: eye[0],
            shadow_upwards: axis(1),
            shadow_eye_y: eye[1],
            // Without a map there are none on the ground.
            ground_without_sun: radiance(ground.map(|g| plane.map_or(Rgb::grey(1.0), |_| g.without_sun))),
            shadow_share: now.shadows.map_or(0.0, |shadows| shadows.share),
            shadow_texel_m: plane.map_or([1.0; 2], |plane| plane.texel_m),
            unused: [0.0; 2],
        }
    }
}
