// What three.js reads of glTF files in headless Chromium: counts, and a picture from each file's first camera. A file is
// given with the sprites and cameras that it has to have.
// usage: node three.mjs OUT_FOLDER FILE:SPRITES:CAMERAS...
import { createServer } from "node:http";
import { readFileSync, writeFileSync, mkdtempSync } from "node:fs";
import { basename, join } from "node:path";
import { tmpdir } from "node:os";
import { chromium } from "playwright-core";

const [out, ...given] = process.argv.slice(2);
const wanted = given.map((text) => text.match(/^(.*):(\d+):(\d+)$/).slice(1)).map(([file, sprites, cameras]) => ({ file, sprites: Number(sprites), cameras: Number(cameras) }));
const files = wanted.map(({ file }) => file);
const modules = join(import.meta.dirname, "node_modules/three");
const page_text = `<!doctype html><canvas id=c width=960 height=540></canvas>
<script type=importmap>{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script>
<script type=module>
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
window.show = async (url) => {
  const gltf = await new GLTFLoader().loadAsync(url);
  let sprites = 0, vertices = 0, cameras = 0, lights = 0;
  gltf.scene.traverse((o) => {
    if (o.isInstancedMesh) sprites += o.count;
    else if (o.isMesh) { vertices += o.geometry.attributes.position.count; sprites += o.geometry.attributes.position.count / 4; }
    if (o.isCamera) cameras++;
    if (o.isLight) lights++;
  });
  const renderer = new THREE.WebGLRenderer({ canvas: document.getElementById("c"), antialias: false, preserveDrawingBuffer: true });
  renderer.setSize(960, 540, false);
  const scene = new THREE.Scene(); scene.add(gltf.scene); scene.background = new THREE.Color(0.33, 0.52, 0.8);
  scene.updateMatrixWorld(true);
  const camera = gltf.cameras[0]; camera.aspect = 960/540; camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  return { sprites, vertices, cameras, lights, channels: gltf.animations.reduce((n, a) => n + a.tracks.length, 0) };
};
window.ready = true;
</script>`;
const server = createServer((request, response) => {
  const url = decodeURIComponent(request.url);
  try {
    if (url === "/") return response.setHeader("content-type", "text/html").end(page_text);
    if (url.startsWith("/three/")) return response.setHeader("content-type", "text/javascript").end(readFileSync(join(modules, url.slice(7))));
    response.end(readFileSync(files[Number(url.slice(6))]));
  } catch { response.statusCode = 404; response.end(); }
}).listen(0);
const flags = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const context = await chromium.launchPersistentContext(mkdtempSync(join(tmpdir(), "judge")), { executablePath: "/usr/bin/chromium", headless: true, args: flags });
const page = await context.newPage();
page.on("pageerror", (e) => console.error(String(e)));
await page.goto(`http://localhost:${server.address().port}/`);
await page.waitForFunction(() => window.ready);
let bad = 0;
for (let i = 0; i < files.length; i++) {
  const counts = await page.evaluate((i) => window.show(`/file/${i}`), i);
  const right = counts.sprites === wanted[i].sprites && counts.cameras === wanted[i].cameras;
  console.log(`${basename(files[i])}: ${JSON.stringify(counts)}${right ? "" : ` instead of ${JSON.stringify(wanted[i])}`}`);
  bad += right ? 0 : 1;
  const data = await page.evaluate(() => document.getElementById("c").toDataURL());
  writeFileSync(join(out, basename(files[i], ".glb") + ".png"), Buffer.from(data.split(",")[1], "base64"));
  await page.reload(); await page.waitForFunction(() => window.ready);
}
await context.close();
server.close();
process.exit(bad > 0 ? 1 : 0);
