//! Phase 3 and the sky for any input: finite, in range.

use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::derived::Derived;
use cloudwright_core::scene::{ColorLevel, DailyTable, Sun};
use cloudwright_core::shading::{corner_light, directional_share, level_color};
use cloudwright_core::sky::Dome;
use cloudwright_core::weather::{CloudNow, Light};
use cloudwright_tests::small_scenes::heap;
use glam::Vec3;
use proptest::prelude::*;

fn any_direction() -> impl Strategy<Value = Vec3> {
    prop_oneof![
        Just(Vec3::ZERO),
        Just(Vec3::Y),
        (-1.0..1.0_f32, -1.0..1.0_f32, -1.0..1.0_f32).prop_map(Vec3::from),
        (-1e30..1e30_f32, -1e30..1e30_f32, -1e-30..1e-30_f32).prop_map(Vec3::from),
    ]
}

proptest! {
    /// g stays between the smallest and the largest of its three numbers, and meets them at −1, 0 and 1.
    #[test]
    fn directional_share_is_bounded(outward in any_direction(), sun in any_direction(), c in prop::array::uniform3(-4.0..4.0_f32)) {
        let sun = sun.normalize_or(Vec3::X);
        let share = directional_share(outward, c, sun);
        let (low, high) = (c.into_iter().fold(f32::MAX, f32::min), c.into_iter().fold(f32::MIN, f32::max));
        prop_assert!(share >= low - 1e-5 && share <= high + 1e-5, "{share}");
        prop_assert!((directional_share(sun, c, sun) - c[2]).abs() < 1e-5);
        prop_assert!((directional_share(-sun, c, sun) - c[0]).abs() < 1e-5);
        prop_assert!((directional_share(Vec3::ZERO, c, sun) - c[1]).abs() < 1e-6);
    }

    /// Levels at any five heights in order stay within the hull of their colours.
    #[test]
    fn levels_are_bounded(mut heights in prop::array::uniform5(0.0..=1.0_f64), values in prop::array::uniform5(0.0..2.0_f32), at in 0.0..=1.0_f32) {
        heights.sort_by(f64::total_cmp);
        let levels: [ColorLevel; 5] =
            std::array::from_fn(|i| ColorLevel { height: heights[i], color: Rgba::new(values[i], 0.0, 0.0, 1.0) });
        let got = level_color(&levels, at).rgb.r;
        let (low, high) = (values.into_iter().fold(f32::MAX, f32::min), values.into_iter().fold(f32::MIN, f32::max));
        prop_assert!(got >= low - 1e-5 && got <= high + 1e-5, "{got}");
    }

    #[test]
    fn tables_are_cyclic(hours in prop::collection::btree_set(0..2400_u32, 1..12), at in -100.0..100.0_f64) {
        let table = DailyTable::new(hours.iter().map(|h| (f64::from(*h) / 100.0, Rgb::grey(*h as f32))));
        let value = |hour| table.at(hour, Rgb::mix).r;
        prop_assert!((value(at) - value(at + 24.0)).abs() < 0.5, "{} {}", value(at), value(at + 24.0));
        for hour in &hours {
            prop_assert!((value(f64::from(*hour) / 100.0) - *hour as f32).abs() < 0.5);
        }
    }

    #[test]
    fn the_sky_is_finite(sun in any_direction(), to in any_direction(), turbidity in -5.0..20.0_f32, albedo in -1.0..3.0_f32) {
        let dome = Dome::new(sun.normalize_or(Vec3::Y), turbidity, Rgb::grey(albedo), 1.0, Rgb::grey(1.0));
        for color in [dome.radiance(to.normalize_or(Vec3::X)), dome.horizon(to)] {
            prop_assert!(color.to_array().iter().all(|c| c.is_finite() && *c >= 0.0), "{color:?}");
        }
    }
}

#[test]
fn every_corner_of_a_cloud_is_lit_by_both_lights() {
    let mut scene = heap(30);
    for sun in [
        Sun::ByPlace,
        Sun::ByHand { heading_deg: 90.0, elevation_deg: 0.0 },
        Sun::ByHand { heading_deg: 0.0, elevation_deg: -60.0 },
    ] {
        scene.sun = sun;
        for hour in [0.0, 5.5, 12.0, 20.9, 23.99] {
            let light = Light::at(&scene, hour);
            let derived = Derived::new(&scene);
            let cloud = &derived.clouds()[0];
            let mut brightest = 0.0_f32;
            for sprite in cloud.sprites.iter() {
                let group = &cloud.groups[sprite.group as usize];
                let lit = corner_light(
                    sprite.position + Vec3::splat(sprite.radius()),
                    &CloudNow::at_rest(cloud),
                    group,
                    &light,
                );
                let level = level_color(&cloud.color_levels, lit.height);
                assert!((0.0..=1.0).contains(&lit.height));
                brightest = brightest.max(lit.directional.g);
                assert!((lit.ambient.rgb.g - level.rgb.g * light.ambient_max.rgb.g).abs() < 1e-6);
                assert!(lit.color().rgb.g >= lit.ambient.rgb.g - 1e-6 && lit.color().a <= 1.0);
            }
            assert!(brightest >= 0.5 * light.directional_max.g, "some corner faces the light: {brightest}");
        }
    }
}
