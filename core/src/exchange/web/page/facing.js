// How sprites near the eye turn and fade: the twin of core/src/facing/, which says why. Vectors are arrays of three.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scaled = (a, by) => [a[0] * by, a[1] * by, a[2] * by];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(a[0], a[1], a[2]);
const across = (v, axis) => add(v, scaled(axis, -dot(v, axis)));
const clamp = (x, from, to) => Math.min(Math.max(x, from), to);

function unit_or(v, fallback) {
  const long = length(v);
  return long > 1e-30 ? scaled(v, 1 / long) : fallback;
}

function smoothstep(from, to, x) {
  const t = clamp((x - from) / (to - from), 0, 1);
  return t * t * (3 - 2 * t);
}

const lock_distance = (radius) => Math.max(LOCK_SHARE * radius, 1e-30);
const away_from_poles = (towards) => 1 - smoothstep(POLE_FROM, POLE_TO, Math.abs(towards[1]));
const world_up = (towards, otherwise) => unit_or(across([0, 1, 0], towards), otherwise);

function still_up(towards, camera_up) {
  const fallback = unit_or(across(Math.abs(towards[0]) < 0.8 ? [1, 0, 0] : [0, 0, 1], towards), [0, 0, 1]);
  const away = away_from_poles(towards);
  const world = world_up(towards, [0, 0, 0]);
  const camera = unit_or(across(camera_up, towards), world);
  return unit_or(add(scaled(world, away), scaled(camera, 1 - away)), fallback);
}

/** `up`, across `before`, carried to `towards` and relaxed on the way. */
function carried_up(up, before, towards) {
  const scale = 1 + dot(before, towards);
  const moved = scale > 1e-6 ? add(up, scaled(add(before, towards), -dot(up, towards) / scale)) : up;
  const carried = unit_or(across(moved, towards), up);
  const world = world_up(towards, carried);
  const left = Math.atan2(dot(cross(carried, world), towards), dot(carried, world));
  const turned = Math.atan2(length(cross(before, towards)), dot(before, towards));
  const relaxes = RELAXING * turned * away_from_poles(towards);
  if (Math.abs(left) <= relaxes) return world;
  const angle = left < 0 ? -relaxes : relaxes;
  return unit_or(add(scaled(carried, Math.cos(angle)), scaled(cross(towards, carried), Math.sin(angle))), world);
}

/** Within half its radius a sprite keeps the way it `faced`; over a shell around that it goes on to facing the eye. */
function locked(to_eye, faced, lock_m) {
  const share = smoothstep(lock_m, SHELL * lock_m, length(to_eye));
  const between = add(scaled(faced, 1 - share), scaled(unit_or(to_eye, faced), share));
  const before_plane = clamp(dot(faced, to_eye) / (SHELL * lock_m), 0, 1);
  const fade = length(between) * (before_plane + (1 - before_plane) * share);
  return { towards: unit_or(between, faced), fade: Math.min(fade, 1) };
}

/** What one view remembers of the sprites around it. An eye that has not been anywhere sees a still. */
class FacingMemory {
  constructor() { this.forget(); }

  forget() {
    this.remembered = new Map();
    this.next = new Map();
    this.moved = null;
    this.eye = null;
  }

  /** Begins a frame from `eye`. */
  begin(view) {
    this.view = view;
    this.moved = this.eye && [0, 1, 2].map((i) => view.eye[i] - this.eye[i]);
    const corner = Math.hypot(1, view.tan_half_height, view.tan_half_height * view.width / view.height);
    this.near_reach = NEAR_M * corner;
  }

  /** The pose of the sprite known by `key`, if it does not simply face the eye; `center` from the eye. */
  pose(key, center, radius) {
    const lock_m = lock_distance(radius);
    const distance = Math.sqrt(dot(center, center));
    const within_shell = distance < SHELL * lock_m;
    const polar = this.moved !== null && Math.abs(center[1]) > POLE_FROM * distance;
    const known = this.remembered.get(key);
    if (!(within_shell || distance < 2 * this.near_reach || polar || known)) return null;
    const to_eye = scaled(center, -1);
    const past = known ?? this.past(center);
    const faced = within_shell ? past.faced : unit_or(to_eye, past.faced);
    const { towards, fade } = locked(to_eye, faced, lock_m);
    const up = carried_up(past.up, past.towards, towards);
    const relaxed = dot(up, world_up(towards, up)) > 1 - 1e-12;
    if (within_shell || polar || !relaxed) this.next.set(key, { faced, towards, up });
    const near_fade = smoothstep(this.near_reach, 2 * this.near_reach, dot(towards, to_eye));
    return { towards, up, fade: fade * near_fade, within_shell };
  }

  /** What there would be to remember of a sprite that was far from the eye in the last frame. */
  past(center) {
    const before = this.moved ? add(center, this.moved) : center;
    const towards = unit_or(scaled(before, -1), [0, 0, 1]);
    return { faced: towards, towards, up: still_up(towards, this.view.up) };
  }

  /** Ends a frame; a view that `stands` alone leaves no memory. */
  end(stands) {
    [this.remembered, this.next] = stands ? [new Map(), new Map()] : [this.next, new Map()];
    this.eye = stands ? null : this.view.eye;
  }
}
