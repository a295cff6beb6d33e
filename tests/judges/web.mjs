// Opens exported web pages in headless Chromium, each at a camera, a time of day and a size, and takes a picture of it.
// usage: node web.mjs WIDTHxHEIGHT PAGE:HASH:PNG...
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [size, ...given] = process.argv.slice(2);
const [width, height] = size.split("x").map(Number);
const flags = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const context = await chromium.launchPersistentContext(mkdtempSync(join(tmpdir(), "judge")), {
  executablePath: "/usr/bin/chromium", headless: true, args: flags, viewport: { width, height },
});
let bad = 0;
for (const text of given) {
  const [, file, hash, png] = text.match(/^(.*?):(.*):(.*)$/);
  // A page of its own: what another hash only would change is not loaded again.
  const page = await context.newPage();
  const complain = (what) => { bad++; console.error(`${basename(file)}#${hash}: ${what}`); };
  page.on("pageerror", (error) => complain(error));
  page.on("console", (message) => message.type() === "error" && complain(message.text()));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || request.url().startsWith("blob:") || complain(`it asks for ${request.url()}`));
  await page.goto(`${pathToFileURL(resolve(file))}#${hash}`);
  await page.waitForFunction(() => document.body.dataset.drawn, null, { timeout: 60000 });
  await page.screenshot({ path: png });
  await page.close();
}
await context.close();
process.exit(bad > 0 ? 1 : 0);
