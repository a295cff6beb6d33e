// The air inside a cloud: what sprites around the eye that have faded would hide. The twin of core/src/shading/veil.rs.

/** Red, green, blue and alpha before everything, premultiplied. */
function veil_of(list, light, air) {
  const { scene, shadows } = list;
  const { MOST_OPAQUE, BEFORE_THE_EYE } = HEADER.constants;
  const density = light.inside_density[0];
  let depth = 0, lit = [0, 0, 0];
  for (const { index, sprite, center, pose, moment } of density > 0 ? list.veiled : []) {
    const { scale } = moment;
    const rest = [0, 1, 2].map((i) => scene.sprites[8 * sprite + i]);
    const point = add(rest, scaled(at_rest(moment, scaled(center, -1)), 1 / scale));
    const word = scene.sprite_words[8 * sprite + 7];
    const from_origin = add(moment.origin, scaled(list.eye, -1));
    const shade = shadows.left_at(index, add(center, scaled(from_origin, -1)), light.sun_direction);
    const color = corner_light(scene, index, sprite, point, moment, light, shade);
    const threshold = air ? scene.stirs[4 * sprite + 1] : 0;
    const condensed = air ? smoothstep(threshold - CONDENSING, threshold + CONDENSING, air.humidity) : 1;
    const opacity = Math.min(color[3] * condensed * HEADER.mean_opacities[word & 15], MOST_OPAQUE);
    const share = -Math.log1p(-opacity) * BEFORE_THE_EYE * (1 - pose.fade);
    depth += share;
    lit = add(lit, scaled(color, share));
  }
  if (depth <= 0) return [0, 0, 0, 0];
  const alpha = -Math.expm1(-depth * density);
  return [...scaled(lit, alpha / depth), alpha];
}

/** The light on a sprite at a point at rest, as the sprites' shader has it: linear rgb, straight, and alpha. */
function corner_light(scene, cloud, sprite, point, moment, light, shade) {
  const { clouds, groups, sprites } = scene;
  const at = CLOUD_NUMBERS * cloud;
  const group = scene.sprite_words[8 * sprite + 7] >>> 4;
  const sun = at_rest(moment, light.sun_direction);
  const [bottom, top] = [clouds[at + 4], clouds[at + 5]];
  const level = level_color(clouds, at, top > bottom ? clamp((point[1] - bottom) / (top - bottom), 0, 1) : 0);
  const [x, y, z, c_min, c_med, c_max] = groups.subarray(8 * group, 8 * group + 6);
  const d = clamp(dot(unit_or(add(point, [-x, -y, -z]), [0, 0, 0]), sun), -1, 1);
  let [ambient, directional] = [1, in_shade(c_med + d * (d < 0 ? c_med - c_min : c_max - c_med), shade)];
  const soft = soft_light(clouds, cloud);
  if (soft) {
    const [px, py, pz, width, height] = sprites.subarray(8 * sprite, 8 * sprite + 5);
    const offset = scaled(in_model(soft, add(point, [-px, -py, -pz])), 2 / Math.hypot(width, height));
    const by_group = [ambient, directional];
    [ambient, directional] = through(scene, soft, sprite, offset, in_model(soft, sun), c_max, by_group, shade);
  }
  const radii = length([0, 1, 2].map((i) => point[i] - clouds[at + i])) * clouds[at + 3];
  const formed = clamp(moment.core - moment.falloff * radii, 0, 1) * moment.opacity;
  const rgb = [0, 1, 2].map((i) => level[i] * light.ambient[i] * ambient + light.directional[i] * directional);
  return [...rgb, clamp(level[3] * light.ambient[3], 0, 1) * formed];
}

function level_color(clouds, at, height) {
  const heights = [...clouds.subarray(at + 8, at + 12), clouds[at + 6]];
  const color = (i) => [...clouds.subarray(at + 12 + 4 * i, at + 16 + 4 * i)];
  const above = heights.findIndex((level) => level > height);
  if (above < 0) return color(4);
  if (above === 0) return color(0);
  const share = (height - heights[above - 1]) / (heights[above] - heights[above - 1]);
  const [from, to] = [color(above - 1), color(above)];
  return from.map((value, i) => value + (to[i] - value) * share);
}
