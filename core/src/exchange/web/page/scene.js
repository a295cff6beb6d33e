// What the page was given: its header, the sections of its block, and the scene at a moment.

const text_of = (id) => document.getElementById(id).textContent;
const HEADER = JSON.parse(text_of("header"));
const { NEAR_M, LOCK_SHARE, SHELL, POLE_FROM, POLE_TO, RELAXING, REACH, SWAY, CONDENSING } = HEADER.constants;

/** The block's sections by name, each as a function that gives them as numbers of one kind. */
async function sections() {
  const packed = Uint8Array.from(atob(text_of("block")), (character) => character.charCodeAt(0));
  const inflated = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = await new Response(inflated).arrayBuffer();
  const section = (name) => HEADER.sections.find((each) => each.name === name);
  return (name, Kind) => new Kind(bytes, section(name).from, section(name).bytes / Kind.BYTES_PER_ELEMENT);
}

/** Interpolates rows of `width` numbers, of which those from `first` on begin with their second, into `out`. */
function at_second(rows, width, first, count, second, out) {
  let low = first, high = first + count - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (rows[middle * width] <= second) low = middle; else high = middle - 1;
  }
  const next = Math.min(low + 1, first + count - 1);
  const [from_s, to_s] = [rows[low * width], rows[next * width]];
  const share = to_s > from_s ? Math.min(Math.max((second - from_s) / (to_s - from_s), 0), 1) : 0;
  for (let i = 1; i < width; i++) {
    const from = rows[low * width + i];
    out[i - 1] = from + (rows[next * width + i] - from) * share;
  }
  return out;
}

// Of a cloud; and of a sprite that is baked, with the directions straight up and straight down.
const CLOUD_NUMBERS = 40;
const [BAKED_WORDS, BAKED_UP, BAKED_DOWN] = [16, 6, 13];

/** The scene's light, clouds and air at any second of its clock, at its own hour or another. */
class Scene {
  constructor(section) {
    this.words = (name) => section(name, Uint32Array);
    this.atlas = section("atlas", Uint8Array);
    [this.sprites, this.clouds, this.groups] = ["sprites", "clouds", "groups"].map((name) => section(name, Float32Array));
    this.sprite_words = this.words("sprites");
    this.stirs = section("stirs", Float32Array);
    this.stir_words = this.words("stirs");
    this.baked = this.words("baked");
    const keys = ["cloud_keys", "air_keys", "level_keys"];
    [this.cloud_keys, this.air_keys, this.level_keys] = keys.map((name) => section(name, Float32Array));
    [this.depths, this.balls] = ["depths", "balls"].map((name) => section(name, Float32Array));
    this.by_hour = section("light_by_hour", Float32Array);
    this.by_clock = section("light_by_clock", Float32Array);
    this.row_length = HEADER.light_fields.reduce((sum, [, count]) => sum + count, 0);
  }

  /** The light by name of each of its fields; `hour`: another than the scene's own, or null. */
  light(clock_s, hour) {
    const row = new Float32Array(this.row_length);
    if (hour === null) {
      const width = this.row_length + 1;
      at_second(this.by_clock, width, 0, this.by_clock.length / width, clock_s, row);
    } else {
      this.at_hour(clock_s, hour, row);
    }
    const light = {};
    let from = 0;
    for (const [name, count] of HEADER.light_fields) {
      light[name] = row.subarray(from, from += count);
    }
    light.hour = light.hour[0];
    return light;
  }

  /** Interpolates between the rows of the hour, and between the days that there are. */
  at_hour(clock_s, hour, row) {
    const days_s = HEADER.days_s;
    const rows_a_day = this.by_hour.length / row.length / days_s.length;
    const next = days_s.findIndex((day_s) => day_s > clock_s);
    const later = next < 0 ? days_s.length - 1 : next;
    const earlier = Math.max(later - 1, 0);
    const days = later > earlier ? clamp((clock_s - days_s[earlier]) / (days_s[later] - days_s[earlier]), 0, 1) : 0;
    const place = hour * HEADER.rows_an_hour;
    const low = Math.floor(place), share = place - low;
    const at = (day, i) => {
      const from = (day * rows_a_day + low) * row.length + i;
      return this.by_hour[from] + (this.by_hour[from + row.length] - this.by_hour[from]) * share;
    };
    for (let i = 0; i < row.length; i++) row[i] = at(earlier, i) + (at(later, i) - at(earlier, i)) * days;
  }

  /** Puts colour levels into the clouds' numbers as they are at a second; whether any has changed. */
  set_levels(clock_s) {
    let changed = false;
    HEADER.clouds.forEach(({ first_level_key, level_keys }, index) => {
      if (level_keys === 0) return;
      const numbers = at_second(this.level_keys, 26, first_level_key, level_keys, clock_s, []);
      const cloud = this.clouds.subarray(CLOUD_NUMBERS * index, CLOUD_NUMBERS * (index + 1));
      for (let level = 0; level < 5; level++) {
        const [height, ...color] = numbers.slice(5 * level, 5 * level + 5);
        cloud[level < 4 ? 8 + level : 6] = height;
        cloud.set(color, 12 + 4 * level);
      }
      changed = true;
    });
    return changed;
  }

  /** The air that moves sprites one by one; null if none does. */
  air(clock_s) {
    const count = this.air_keys.length / 10;
    if (count === 0) return null;
    const [x, y, z, sx, sy, sz, turned, turbulence, humidity] = at_second(this.air_keys, 10, 0, count, clock_s, []);
    const swings = HEADER.swings_s.map((period_s) => (clock_s / period_s) % 1);
    return { lean: [x, y, z], shear: [sx, sy, sz], turned, turbulence, humidity, swings };
  }

  /** What the clock makes of the cloud of that index. */
  moment(index, clock_s, air) {
    const { origin, first_key, keys } = HEADER.clouds[index];
    const [x, y, z, core, falloff, growth, opacity, scale, sin, cos] =
      at_second(this.cloud_keys, 11, first_key, keys, clock_s, []);
    const reach_m = air ? REACH * this.clouds[index * CLOUD_NUMBERS + 7] * scale : -1;
    const now = [origin[0] + x, origin[1] + y, origin[2] + z];
    return { origin: now, core, falloff, growth, opacity, scale, sin, cos, reach_m };
  }
}
