// Which sprites to draw, from the farthest to the nearest, and the poses of those near the eye.

const FACES_EYE = 0xffffffff;
// The sine of so many whole turns.
const sine = (turns) => Math.sin(2 * Math.PI * turns);

/** A direction as it lies to a cloud at rest. */
const at_rest = ({ sin, cos }, [x, y, z]) => [cos * x - sin * z, y, sin * x + cos * z];

/** Lists that are made anew for each frame, in memory that is kept. */
class DrawList {
  constructor(scene) {
    this.scene = scene;
    const most = HEADER.clouds.reduce((sum, cloud) => sum + cloud.sprites, 0);
    this.instances = new Uint32Array(3 * most);
    this.unsorted = new Uint32Array(3 * most);
    this.distances = new Float32Array(most);
    this.keys = new Uint32Array(this.distances.buffer);
    this.order = [new Uint32Array(most), new Uint32Array(most)];
    this.moments = new Float32Array(24 * HEADER.clouds.length);
    this.shadows = new Shadows(scene);
    this.poses = [];
    this.veiled = [];
  }

  /** What `view` sees at `clock_s` in that light and air, with what `memory` holds of the sprites around it. */
  make(view, clock_s, light, air, memory) {
    this.count = 0;
    this.poses.length = this.veiled.length = 0;
    memory.begin(view);
    this.eye = view.eye;
    const now = HEADER.clouds.map((_, index) => this.scene.moment(index, clock_s, air));
    const sun_direction = light.sun_direction;
    this.has_new_shadows = this.shadows.make(now, light, air, [clock_s, ...sun_direction].join());
    let key = 0;
    HEADER.clouds.forEach((cloud, index) => {
      const moment = now[index];
      const from_eye = [0, 1, 2].map((i) => Math.fround(moment.origin[i] - view.eye[i]));
      const { core, falloff, growth, opacity, scale, sin, cos, reach_m } = moment;
      const soft = soft_light(this.scene.clouds, index);
      const { at, shares } = soft ? around(in_model(soft, at_rest(moment, sun_direction))) : { at: [0, 0, 0], shares: [0, 0, 0] };
      const places = at[0] + 16 * at[1] + 256 * at[2];
      const { low, a_metre, first, side } = this.shadows.shades[index] ?? { low: [0, 0], a_metre: 0, first: 0, side: 0 };
      const shade = [...low, a_metre, first, side, 0, 0, 0];
      const numbers = [...from_eye, core, falloff, growth, opacity, scale, sin, cos, reach_m, places, ...shares, 0, ...shade];
      this.moments.set(numbers, 24 * index);
      if (core > 0 && opacity > 0) this.add(index, cloud, moment, from_eye, { air, view, memory, first_key: key });
      key += cloud.sprites;
    });
    memory.end(view.stands);
    this.sort();
  }

  add(index, cloud, moment, from_eye, { air, view, memory, first_key }) {
    const { sprites, clouds } = this.scene;
    const { growth, scale, sin, cos } = moment;
    const [bottom, top] = [clouds[CLOUD_NUMBERS * index + 4], clouds[CLOUD_NUMBERS * index + 5]];
    for (let i = 0; i < cloud.sprites; i++) {
      const sprite = cloud.first_sprite + i;
      const at = 8 * sprite;
      const rest_y = sprites[at + 1];
      const y = rest_y + (rest_y - bottom) * (growth - 1);
      const width = sprites[at + 3] * scale, height = sprites[at + 4] * scale;
      const center = [
        from_eye[0] + scale * (cos * sprites[at] + sin * sprites[at + 2]),
        from_eye[1] + scale * y,
        from_eye[2] + scale * (cos * sprites[at + 2] - sin * sprites[at]),
      ];
      if (air) {
        const within = top > bottom ? clamp((rest_y - bottom) / (top - bottom), 0, 1) : 0;
        this.carry(center, sprite, air, within, moment.reach_m, Math.min(width, height));
      }
      const radius = Math.max(width, height) / 2;
      const pose = memory.pose(first_key + i, center, radius);
      if (pose?.within_shell && pose.fade < 1) this.veiled.push({ index, sprite, center, pose, moment });
      // What lies behind the eye is not drawn; where it is in the order does not matter.
      if (dot(center, view.forward) < NEAR_M - Math.hypot(width, height) / 2) continue;
      const place = this.count++;
      this.distances[place] = center[0] * center[0] + center[1] * center[1] + center[2] * center[2];
      this.unsorted[3 * place] = index;
      this.unsorted[3 * place + 1] = sprite;
      this.unsorted[3 * place + 2] = pose ? this.poses.push(pose) - 1 : FACES_EYE;
    }
  }

  /** Moves `center` by what the air does to the sprite. */
  carry(center, sprite, air, within, reach_m, side_m) {
    const { stirs, stir_words } = this.scene;
    const loose_m = stirs[4 * sprite] * reach_m;
    const share = (stir_words[4 * sprite + 2] >> 16) / 32767;
    const sway_m = air.turbulence * share * SWAY * side_m;
    for (let i = 0; i < 3; i++) {
      const phase = ((stir_words[4 * sprite + 3] >>> (10 * i)) & 1023) / 1024;
      center[i] += (air.lean[i] + air.shear[i] * (within - 0.5)) * loose_m + sine(air.swings[i] + phase) * sway_m;
    }
  }

  /** Farthest first; equally far ones stay in order. A radix sort of the distances' bits, which are ordered as they are. */
  sort() {
    const { count, keys, unsorted, instances } = this;
    let [from, to] = this.order;
    for (let i = 0; i < count; i++) from[i] = i;
    for (const shift of [0, 16]) {
      const starts = new Uint32Array(0x10001);
      for (let i = 0; i < count; i++) starts[((~keys[i] >>> shift) & 0xffff) + 1]++;
      for (let digit = 0; digit < 0x10000; digit++) starts[digit + 1] += starts[digit];
      for (let i = 0; i < count; i++) to[starts[(~keys[from[i]] >>> shift) & 0xffff]++] = from[i];
      [from, to] = [to, from];
    }
    for (let i = 0; i < count; i++) {
      for (let part = 0; part < 3; part++) instances[3 * i + part] = unsorted[3 * from[i] + part];
    }
  }
}
