// Where the eye is and where it looks; how mouse, keys and fingers move it. Angles are degrees, as in the scene's cameras.

const radians = (deg) => (deg * Math.PI) / 180;
// The eye stays so far above the ground, metres.
const LEAST_HEIGHT_M = 2;
const SPEED_MPS = 120;
const FASTER = 6;
const KEYS = {
  KeyW: [0, 0, 1], ArrowUp: [0, 0, 1], KeyS: [0, 0, -1], ArrowDown: [0, 0, -1],
  KeyA: [-1, 0, 0], ArrowLeft: [-1, 0, 0], KeyD: [1, 0, 0], ArrowRight: [1, 0, 0],
  KeyE: [0, 1, 0], PageUp: [0, 1, 0], KeyQ: [0, -1, 0], PageDown: [0, -1, 0],
};

class Eye {
  constructor() {
    // How far ahead lies what it goes round, metres; null while it flies.
    this.orbit_m = null;
    this.held = new Set();
    this.fingers = new Map();
  }

  /** Takes the place of a camera. */
  become(camera) {
    Object.assign(this, camera, { position: [...camera.position] });
    if (this.orbit_m !== null) this.orbit(true);
  }

  /** Its axes: right, up and forward. */
  axes() {
    const [heading, pitch, roll] = [this.heading_deg, this.pitch_deg, this.roll_deg].map(radians);
    const forward = [Math.sin(heading) * Math.cos(pitch), Math.sin(pitch), -Math.cos(heading) * Math.cos(pitch)];
    const level_right = [Math.cos(heading), 0, Math.sin(heading)];
    const level_up = cross(level_right, forward);
    return {
      right: add(scaled(level_right, Math.cos(roll)), scaled(level_up, -Math.sin(roll))),
      up: add(scaled(level_up, Math.cos(roll)), scaled(level_right, Math.sin(roll))),
      forward,
    };
  }

  /** What it sees in a picture of that many pixels. */
  view(width, height, stands) {
    const tan_half_height = Math.tan(radians(this.field_of_view_deg / 2));
    return { ...this.axes(), eye: [...this.position], tan_half_height, width, height, stands };
  }

  /** Goes round the clouds before it, or flies again. */
  orbit(on) {
    if (!on) {
      this.orbit_m = null;
      return;
    }
    const { forward } = this.axes();
    const ahead = HEADER.clouds.map(({ origin }) => dot(add(origin, scaled(this.position, -1)), forward)).filter((m) => m > 0);
    ahead.sort((a, b) => a - b);
    this.orbit_m = Math.max(ahead[ahead.length >> 1] ?? 3000, 200);
  }

  /** Turns by so many pixels of a picture `height` pixels high. */
  turn(x, y, height) {
    const deg = this.field_of_view_deg / height;
    const middle = this.orbit_m !== null && add(this.position, scaled(this.axes().forward, this.orbit_m));
    // The picture goes along with the pointer; what is gone round turns faster.
    const way = middle ? 3 : -1;
    this.heading_deg += way * x * deg;
    this.pitch_deg = clamp(this.pitch_deg - way * y * deg, -89.9, 89.9);
    if (middle) this.position = add(middle, scaled(this.axes().forward, -this.orbit_m));
    this.keep_above_ground();
  }

  /** Moves by metres along its right, the world's up and forward. */
  move([right_m, up_m, ahead_m]) {
    const { right, forward } = this.axes();
    const step = add(add(scaled(right, right_m), [0, up_m, 0]), scaled(forward, ahead_m));
    this.position = add(this.position, step);
    this.keep_above_ground();
  }

  /** Nearer, by a share of the way to what it goes round, or by some seconds of flight. */
  zoom(share) {
    if (this.orbit_m === null) return this.move([0, 0, share * SPEED_MPS * 4]);
    const nearer_m = this.orbit_m * (1 - Math.exp(-share));
    this.orbit_m -= nearer_m;
    this.move([0, 0, nearer_m]);
  }

  keep_above_ground() {
    const ground_m = HEADER.ground_altitude_m;
    if (ground_m !== null) this.position[1] = Math.max(this.position[1], ground_m + LEAST_HEIGHT_M);
  }

  /** Flies on by what is held down; whether anything is. */
  fly(seconds) {
    const ways = [...this.held].filter((code) => KEYS[code]).map((code) => KEYS[code]);
    if (ways.length === 0) return false;
    const faster = this.held.has("ShiftLeft") || this.held.has("ShiftRight") ? FASTER : 1;
    this.move(scaled(ways.reduce(add), SPEED_MPS * faster * seconds));
    return true;
  }

  /** Listens on the canvas; calls `changed` when it has moved, or is about to. */
  listen(canvas, changed) {
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      canvas.focus();
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    for (const kind of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(kind, (event) => this.fingers.delete(event.pointerId));
    }
    canvas.addEventListener("pointermove", (event) => {
      const before = this.fingers.get(event.pointerId);
      if (!before) return;
      this.dragged(event.pointerId, before, [event.clientX, event.clientY], canvas.clientHeight);
      changed();
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / 100 : event.deltaY / 3;
      this.zoom(-lines * 0.15);
      changed();
    }, { passive: false });
    addEventListener("keydown", (event) => {
      const is_a_controls = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
      if (is_a_controls || event.ctrlKey || event.metaKey || event.altKey) return;
      this.held.add(event.code);
      if (KEYS[event.code]) event.preventDefault();
      changed();
    });
    addEventListener("keyup", (event) => this.held.delete(event.code));
    addEventListener("blur", () => this.held.clear());
  }

  /** One finger turns; two zoom by how far they are apart, and carry the eye along. */
  dragged(finger, before, now, height) {
    const others = [...this.fingers].filter(([id]) => id !== finger);
    this.fingers.set(finger, now);
    const [x, y] = [now[0] - before[0], now[1] - before[1]];
    if (others.length === 0) return this.turn(x, y, height);
    const [, other] = others[0];
    const apart = ([px, py]) => Math.hypot(px - other[0], py - other[1]);
    this.zoom(((apart(now) - apart(before)) / height) * 3);
    const metres = ((this.orbit_m ?? 1000) / height) * 0.5;
    this.move([-x * metres, y * metres, 0]);
  }
}
