// Shadows of clouds on the ground and on one another. The twin of core/src/weather/shadows/: on the ground falls that of every
// sprite (shadows.vert.glsl); on another cloud that of a few balls, on a small grid across the light.

const BALL_NUMBERS = 6;
const [NODES_ACROSS_HALF, LEAST_NODES, MOST_NODES, LEAST_SPOT, SEEN_DEPTH] = [2.5, 4, 24, 0.75, 0.02];
const LOWEST_LIGHT = 0.01;

/** Two unit vectors across a direction: a level one, and one that looks up. */
function axes_across(direction) {
  const level = unit_or([-direction[2], 0, direction[0]], [1, 0, 0]);
  return [level, cross(level, direction)];
}

/** What a cloud of that index is, where its `moment` has it, for those that shadows fall from or on. */
function body_of(scene, index, moment, air) {
  const numbers = scene.clouds.subarray(CLOUD_NUMBERS * index, CLOUD_NUMBERS * (index + 1));
  const [x, y, z] = numbers;
  const [radius, reach, largest] = [numbers[7], numbers[35], numbers[38]];
  const { growth, scale, reach_m } = moment;
  const side_m = 2 * largest * scale;
  const carried_m = air
    ? (length(air.lean) + 0.5 * length(air.shear)) * reach_m + 1.7321 * air.turbulence * SWAY * side_m
    : 0;
  const stands = !air && scale === 1 && growth === 1;
  const now_m = radius * Math.max(growth, 1) * scale + carried_m;
  return {
    index, moment, bottom: numbers[4],
    center: point_now(moment, numbers[4], [x, y, z]),
    reach: stands ? reach : now_m + Math.max((reach - radius) * scale, 0),
    largest: largest * scale,
    casts: moment.core > 0 && moment.opacity > 0 && (!air || air.humidity > -CONDENSING),
    condensed: air ? clamp(air.humidity, 0, 1) : 1,
  };
}

/** Where a point of a cloud at rest is now, from its origin. */
function point_now({ growth, scale, sin, cos }, bottom, [x, y, z]) {
  const grown = y + (y - bottom) * (growth - 1);
  return scaled([cos * x + sin * z, grown, cos * z - sin * x], scale);
}

class Shadows {
  constructor(scene) {
    this.scene = scene;
    this.nodes = new Float32Array(0);
    this.made_for = null;
  }

  /** Brings all up to date with clouds that are `moments` now; whether anything is other than it was. */
  make(moments, light, air, what) {
    const direction = [...light.sun_direction];
    this.axes = axes_across(direction);
    this.share = direction[1] >= LOWEST_LIGHT && light.ambient[3] > 0 ? clamp(light.shadow_share[0], 0, 1) : 0;
    if (this.made_for === what) return false;
    this.made_for = what;
    this.shades = moments.map(() => null);
    this.plane = null;
    this.nodes = new Float32Array(0);
    if (this.share <= 0) return true;
    const bodies = moments.map((moment, index) => body_of(this.scene, index, moment, air));
    if (HEADER.ground_altitude_m !== null) this.plane = this.plane_of(bodies, direction);
    const all = [];
    bodies.forEach((body) => {
      const shade = body.casts ? this.shade_on(body, bodies, direction, light.ambient[3], all.length / 4) : null;
      if (!shade) return;
      this.shades[body.index] = shade;
      all.push(...shade.nodes);
    });
    this.nodes = new Float32Array(all);
    return true;
  }

  /** The plane across the light around all that casts. */
  plane_of(bodies, direction) {
    const most = HEADER.constants.SHADOW_TEXELS;
    const [low, high] = [[Infinity, Infinity], [-Infinity, -Infinity]];
    let finest = Infinity;
    for (const { casts, moment, center, reach, largest } of bodies) {
      if (!casts) continue;
      const middle = add(moment.origin, center);
      const soft = (HEADER.constants.SUN_RADIUS * Math.max(middle[1] - HEADER.ground_altitude_m, 0)) / direction[1];
      this.axes.forEach((axis, i) => {
        low[i] = Math.min(low[i], dot(middle, axis) - reach - soft);
        high[i] = Math.max(high[i], dot(middle, axis) + reach + soft);
      });
      finest = Math.min(finest, largest / 8);
    }
    if (!(low[0] < high[0])) return null;
    const rounded_up = (metres) => 2 ** (Math.ceil(Math.log2(metres) * 4) / 4);
    const texel_m = [0, 1].map((i) => rounded_up(Math.max((high[i] - low[i]) / (most - 4), finest, 0.01)));
    return { texel_m, from_m: [0, 1].map((i) => low[i] - 1.5 * texel_m[i]) };
  }

  /** Where an eye is on the plane, texels. */
  eye_on_plane(eye) {
    return [0, 1].map((i) => (dot(eye, this.axes[i]) - this.plane.from_m[i]) / this.plane.texel_m[i]);
  }

  /** What other clouds take of the light over one; null where that is nothing. */
  shade_on(body, bodies, direction, opacity, first) {
    const [level, upwards] = this.axes;
    const balls = bodies.flatMap((from) => (from !== body && from.casts ? this.balls_over(body, from, direction, opacity) : []));
    if (balls.length === 0) return null;
    const mean_half = balls.reduce((sum, { half }) => sum + Math.max(...half), 0) / balls.length;
    const side = clamp(Math.ceil((2 * body.reach * NODES_ACROSS_HALF) / mean_half), LEAST_NODES, MOST_NODES);
    const low = [level, upwards].map((axis) => dot(body.center, axis) - body.reach);
    const a_metre = (side - 1) / (2 * body.reach);
    const nodes = new Float32Array(4 * side * side);
    let most = 0;
    for (const { center, half: [across, up], depth } of balls) {
      const rise = direction[1];
      const half = [across, Math.sqrt((across * rise) ** 2 + up * up * Math.max(1 - rise * rise, 0))];
      const wider = half.map((each) => Math.hypot(each, LEAST_SPOT / a_metre));
      const there = (depth * half[0] * half[1]) / (wider[0] * wider[1]);
      const at = [level, upwards].map((axis, i) => (dot(center, axis) - low[i]) * a_metre);
      const span = wider.map((each, i) => [
        Math.max(0, Math.ceil(at[i] - each * a_metre)), Math.min(side - 1, Math.floor(at[i] + each * a_metre)),
      ]);
      const [stands, deep] = [dot(center, direction), Math.max(across, up)];
      for (let row = span[1][0]; row <= span[1][1]; row++) {
        for (let column = span[0][0]; column <= span[0][1]; column++) {
          const off = [column, row].map((place, i) => (place - at[i]) / (wider[i] * a_metre));
          const inside = 1 - off[0] * off[0] - off[1] * off[1];
          if (inside <= 0) continue;
          const taken = there * inside * Math.sqrt(inside);
          const node = 4 * (row * side + column);
          nodes[node] += taken;
          nodes[node + 1] += taken * stands;
          nodes[node + 2] += taken * deep;
          most = Math.max(most, nodes[node]);
        }
      }
    }
    return most > SEEN_DEPTH ? { low, a_metre, side, first, nodes } : null;
  }

  /** The balls of one cloud that come over another, from whose origin they count. */
  balls_over(body, from, direction, opacity) {
    const { few, few_balls } = HEADER.clouds[from.index];
    const { core, falloff, scale } = from.moment;
    const numbers = this.scene.clouds.subarray(CLOUD_NUMBERS * from.index, CLOUD_NUMBERS * (from.index + 1));
    const offset = [0, 1, 2].map((i) => from.moment.origin[i] - body.moment.origin[i]);
    const balls = [];
    for (let i = few; i < few + few_balls; i++) {
      const [x, y, z, across, up, depth] = this.scene.balls.subarray(BALL_NUMBERS * i, BALL_NUMBERS * (i + 1));
      const center = add(point_now(from.moment, from.bottom, [x, y, z]), offset);
      const half = [across * scale, up * scale];
      const off = add(center, scaled(body.center, -1));
      const [along, near] = [dot(off, direction), Math.max(...half) + body.reach];
      if (along <= -near || dot(off, off) - along * along >= near * near) continue;
      const radii = length([x - numbers[0], y - numbers[1], z - numbers[2]]) * numbers[3];
      const formed = clamp(core - falloff * radii, 0, 1) * from.moment.opacity;
      const now = depth * formed * opacity * from.condensed;
      if (now > 0) balls.push({ center, half, depth: now });
    }
    return balls;
  }

  /** What is left of the light at a point that counts from a cloud's origin, e^(−τ/10). */
  left_at(index, point, direction) {
    const shade = this.shades[index];
    if (!shade) return 1;
    const { low, a_metre, side, nodes } = shade;
    const place = this.axes.map((axis, i) => clamp((dot(point, axis) - low[i]) * a_metre, 0, side - 1));
    const from = place.map((each) => Math.min(Math.floor(each), side - 2));
    const [x, y] = [place[0] - from[0], place[1] - from[1]];
    const at = 4 * (from[1] * side + from[0]);
    const mixed = (i) => {
      const pair = (node) => nodes[node + i] + (nodes[node + 4 + i] - nodes[node + i]) * x;
      return pair(at) + (pair(at + 4 * side) - pair(at)) * y;
    };
    const depth = mixed(0);
    if (depth <= 0) return 1;
    const before = clamp(0.5 + (0.5 * (mixed(1) - dot(point, direction) * depth)) / Math.max(mixed(2), 1e-6), 0, 1);
    return 1 - this.share * (1 - Math.exp(-0.1 * depth * before));
  }
}

/** A light that other clouds have left so much of, and that goes by a group's sides. */
function in_shade(share, shade) {
  const { SCATTERED, STRAIGHT } = HEADER.constants;
  return share * ((SCATTERED * shade + STRAIGHT * shade ** 8) / (SCATTERED + STRAIGHT));
}
