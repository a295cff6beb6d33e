// The page: its controls, its clock, and when a frame is drawn. The address may say what it shows first:
// #camera=NAME&time=HH:MM&clock=SECONDS, and &still=1 for that one picture without controls.

const by_id = (id) => document.getElementById(id);
const two_digits = (number) => String(number).padStart(2, "0");
const clock_text = (hour) => {
  const minutes = Math.round(hour * 60) % 1440;
  return `${two_digits(Math.floor(minutes / 60))}:${two_digits(minutes % 60)}`;
};
const HINTS = {
  fly: "Drag to look around, W A S D Q E to fly, Shift for faster, wheel or two fingers to go on.",
  orbit: "Drag to go round, wheel or two fingers to come nearer.",
};

class Page {
  constructor(scene) {
    this.scene = scene;
    this.canvas = by_id("picture");
    this.gpu = new Gpu(this.canvas, scene);
    this.list = new DrawList(scene);
    this.memory = new FacingMemory();
    this.eye = new Eye();
    this.start();
  }

  /** As the file says, or the address. */
  start() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const { camera, clock_s, time_h } = HEADER.start;
    const named = HEADER.cameras.findIndex((each) => each.name === asked.get("camera"));
    this.eye.become(HEADER.cameras[named < 0 ? camera : named]);
    this.clock_s = Number(asked.get("clock") ?? clock_s) || 0;
    const time = asked.get("time")?.match(/^(\d\d?):(\d\d)$/);
    this.hour = time ? Math.min(Number(time[1]) + Number(time[2]) / 60, 23.99) : time_h === null ? null : time_h % 24;
    this.still = asked.get("still") === "1";
    this.playing = false;
    this.last_ms = null;
  }

  /** Shows controls, and listens. */
  control() {
    document.title = `${HEADER.name} – Cloudwright`;
    by_id("name").textContent = HEADER.name;
    // On a phone the panel would hide half of the picture.
    by_id("panel").hidden = Math.min(innerWidth, innerHeight) < 500;
    by_id("fold").hidden = false;
    by_id("fold").onclick = () => (by_id("panel").hidden = !by_id("panel").hidden);
    HEADER.cameras.forEach(({ name }, index) => by_id("camera").add(new Option(name, index)));
    by_id("camera").value = HEADER.cameras.findIndex(({ name }) => name === this.eye.name);
    by_id("camera").onchange = () => {
      this.eye.become(HEADER.cameras[by_id("camera").value]);
      this.memory.forget();
      this.ask();
    };
    by_id("hour").oninput = () => this.show_hour(Number(by_id("hour").value));
    by_id("own_hour").onclick = () => this.show_hour(null);
    by_id("clock_row").hidden = by_id("play").hidden = HEADER.end_s <= 0;
    by_id("clock").max = HEADER.end_s;
    by_id("clock").oninput = () => {
      this.clock_s = Number(by_id("clock").value);
      this.ask();
    };
    by_id("play").onclick = () => {
      this.playing = !this.playing;
      by_id("play").textContent = this.playing ? "Pause" : "Play";
      this.ask();
    };
    by_id("orbit").onclick = () => this.orbit(this.eye.orbit_m === null);
    this.orbit(false);
    this.eye.listen(this.canvas, () => this.ask());
    addEventListener("resize", () => this.ask());
    addEventListener("hashchange", () => location.reload());
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => location.reload());
    this.canvas.focus();
  }

  orbit(on) {
    this.eye.orbit(on);
    by_id("orbit").setAttribute("aria-pressed", on);
    by_id("hint").textContent = on ? HINTS.orbit : HINTS.fly;
  }

  /** Another hour than the scene's own, or null for that. */
  show_hour(hour) {
    this.hour = hour;
    this.ask();
  }

  /** Has a frame drawn soon; none is while nothing moves. */
  ask() {
    this.asked ??= requestAnimationFrame((now_ms) => {
      this.asked = null;
      this.frame(now_ms);
    });
  }

  frame(now_ms) {
    const seconds = this.last_ms === null ? 0 : Math.min((now_ms - this.last_ms) / 1000, 0.5);
    if (this.playing) this.clock_s = (this.clock_s + seconds) % HEADER.end_s;
    const goes_on = this.eye.fly(seconds) || this.playing;
    this.draw();
    this.last_ms = goes_on ? now_ms : null;
    if (goes_on) this.ask();
  }

  draw() {
    const canvas = this.canvas;
    // More pixels than two by two for each of the page's show nothing more of clouds.
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(1, Math.round(side * ratio)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const view = this.eye.view(width, height, this.still);
    const light = this.scene.light(this.clock_s, this.hour);
    const air = this.scene.air(this.clock_s);
    const has_new_levels = this.scene.set_levels(this.clock_s);
    this.list.make(view, this.clock_s, light, air, this.memory);
    this.gpu.draw(view, light, air, this.list, veil_of(this.list, light, air), has_new_levels);
    this.tell(light.hour);
  }

  tell(hour) {
    by_id("hour").value = hour;
    by_id("hour_text").textContent = clock_text(hour);
    by_id("own_hour").hidden = this.hour === null;
    by_id("clock").value = this.clock_s;
    by_id("clock_text").textContent = `${this.clock_s.toFixed(1)} s`;
  }
}

try {
  if (!window.DecompressionStream) throw new Error("This browser is too old for this page: it cannot unpack its data.");
  const page = new Page(new Scene(await sections()));
  if (!page.still) page.control();
  page.draw();
  document.body.dataset.drawn = "yes";
} catch (error) {
  by_id("trouble").textContent = error.message;
  by_id("trouble").hidden = false;
  document.body.dataset.drawn = "no";
  console.error(error);
}
