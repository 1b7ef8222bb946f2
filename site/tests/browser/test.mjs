// The page in a browser: node site/tests/browser/test.mjs, after `cargo run --release -p lagrangian-site` and
// `npm install --prefix site/tests/browser`. It serves target/site itself.
//
// Options: --native FILE compares accelerations with the output of the example `accelerations`, --screenshots FOLDER takes
// screenshots, --chromium PATH names the browser.

import assert from "node:assert/strict";
import { createServer } from "node:http";
import { readFile, mkdir } from "node:fs/promises";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";

const { values: options } = parseArgs({
  options: {
    site: { type: "string", default: fileURLToPath(new URL("../../../target/site", import.meta.url)) },
    native: { type: "string" },
    screenshots: { type: "string" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
  },
});

/** How far the balance of the energy may be missed, relative to the largest kinetic energy. */
const DRIFT = 1e-10;
/** How long each model moves, in ms. */
const SECONDS = 2500;
/** Frames per second that a machine without a graphics card, and busy with other work, must show. */
const SLOWEST = 20;

const KINDS = { ".html": "text/html; charset=utf-8", ".css": "text/css", ".js": "text/javascript", ".wasm": "application/wasm" };

const server = createServer(async (request, response) => {
  const name = new URL(request.url, "http://localhost").pathname.slice(1) || "index.html";
  try {
    const content = await readFile(join(options.site, name));
    response.writeHead(200, { "content-type": KINDS[extname(name)] ?? "application/octet-stream" }).end(content);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const address = `http://127.0.0.1:${server.address().port}`;

const browser = await chromium.launch({
  executablePath: options.chromium,
  args: [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
  ],
});

const complaints = [];
async function opened(path, settings = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...settings });
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) {
      complaints.push(`${path}: ${message.text()}`);
    }
  });
  page.on("pageerror", (error) => complaints.push(`${path}: ${error.message}`));
  page.on("response", (response) => {
    if (response.status() >= 400) {
      complaints.push(`${path}: ${response.url()} is ${response.status()}`);
    }
  });
  await page.goto(`${address}/${path}`);
  if (path.startsWith("play.html")) {
    await page.waitForFunction(() => window.lagrangian !== undefined);
  }
  return page;
}

const number = async (page, id) => Number((await page.textContent(`#${id}`)).replace("−", "-"));
const energy = (page) => page.$eval("#energy", (element) => Number(element.dataset.value));
const passed = (text) => console.log(`ok  ${text}`);

async function eachModelMoves(page, models) {
  const slowest = { rate: Infinity };
  for (const [index, model] of models.entries()) {
    await page.selectOption("#model", String(index));
    await page.waitForTimeout(SECONDS);
    assert.equal(await page.isVisible("#error"), false, `${model.slug}: ${await page.textContent("#error")}`);
    const [time, error, rate] = [await number(page, "time"), await energy(page), await number(page, "frames")];
    assert.ok(time > 0.3 * model.pace, `${model.slug} is at ${time}`);
    assert.ok(error < DRIFT, `${model.slug} misses its energy by ${error}`);
    assert.ok((await page.$$("#equations math")).length > 0, `${model.slug} has no equations`);
    console.log(`    ${model.slug.padEnd(22)} time ${time.toFixed(2).padStart(7)}  energy error ${error.toExponential(1)}  ${rate} frames/s`);
    if (rate < slowest.rate) {
      Object.assign(slowest, { rate, slug: model.slug });
    }
  }
  assert.ok(slowest.rate >= SLOWEST, `${slowest.slug} shows ${slowest.rate} frames per second`);
  passed(`${models.length} models move; the slowest, ${slowest.slug}, shows ${slowest.rate} frames per second`);
}

/** How long it takes to compute a second of each motion, and to paint a frame, in ms. */
async function costs(page, models) {
  for (const [index, model] of models.entries()) {
    const [motion, frame] = await page.evaluate(([index, seconds]) => {
      const player = new window.lagrangian.Player(index, new Float64Array());
      const begin = performance.now();
      while (player.reached < seconds) {
        player.step();
      }
      const middle = performance.now();
      for (let i = 0; i < 60; i += 1) {
        player.picture(0.01 * i, 0.3, 1, 780, 540);
      }
      const end = performance.now();
      player.free();
      return [middle - begin, (end - middle) / 60];
    }, [index, model.pace]);
    console.log(`    ${model.slug.padEnd(22)} ${motion.toFixed(1).padStart(6)} ms for a second, ${frame.toFixed(2)} ms for a picture`);
    assert.ok(motion < 1000, `${model.slug} is slower than the clock`);
  }
  passed("all motions are computed faster than the clock");
}

/** Compares accelerations with those of native code: all bits are equal. */
async function accelerations(page, models) {
  const native = JSON.parse(await readFile(options.native, "utf8"));
  for (const expected of native) {
    const index = models.findIndex((model) => model.slug === expected.slug);
    const found = await page.evaluate(([index, states, coordinates]) => {
      const player = new window.lagrangian.Player(index, new Float64Array());
      const found = Array.from(player.accelerations(new Float64Array(states), coordinates));
      player.free();
      return found;
    }, [index, expected.states, expected.coordinates]);
    assert.equal(found.length, expected.accelerations.length);
    const different = found.filter((x, i) => !Object.is(x, expected.accelerations[i])).length;
    assert.equal(different, 0, `${expected.slug}: ${different} of ${found.length} numbers differ`);
  }
  passed(`accelerations of ${native.length} models at 1000 states have the bits of native code`);
}

async function keyboard(page, models) {
  await page.focus("#model");
  await page.keyboard.press("Home");
  await page.waitForFunction((title) => document.title.startsWith(title), models[0].title);
  await page.keyboard.press("ArrowDown");
  await page.waitForFunction((title) => document.title.startsWith(title), models[1].title);
  await page.focus("#slider-0");
  const before = await page.inputValue("#number-0");
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await page.inputValue("#number-0"), before);
  await page.focus("#play");
  assert.notEqual(await page.$eval("#play", (element) => getComputedStyle(element).outlineStyle), "none");
  await page.keyboard.press("Enter");
  assert.equal(await page.textContent("#play"), "Play");
  const time = await page.textContent("#time");
  await page.waitForTimeout(300);
  assert.equal(await page.textContent("#time"), time);
  await page.focus("#drawing");
  const azimuth = () => page.evaluate(() => window.lagrangian.page.eye.azimuth);
  const [turned, zoom] = [await azimuth(), await page.evaluate(() => window.lagrangian.page.eye.zoom)];
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("+");
  assert.notEqual(await azimuth(), turned);
  assert.notEqual(await page.evaluate(() => window.lagrangian.page.eye.zoom), zoom);
  await page.keyboard.press("p");
  assert.equal(await page.textContent("#play"), "Pause");
  passed("the keyboard chooses a model, moves a slider, pauses, turns the drawing and zooms");
}

async function nonsense(page, models) {
  for (const [slug, id, value] of [
    ["simple-pendulum", "#number-0", "0"],
    ["simple-pendulum", "#number-0", "-1"],
    ["simple-pendulum", "#number-1", "0"],
    ["simple-pendulum", "#number-3", ""],
    ["symmetric-top", "#number-4", "0"],
    ["rattleback", "#number-0", "-2"],
  ]) {
    const index = models.findIndex((model) => model.slug === slug);
    await page.selectOption("#model", String(index));
    await page.waitForFunction((slug) => window.lagrangian.page.model.slug === slug, slug);
    const good = await page.inputValue(id);
    await page.fill(id, value);
    await page.waitForSelector("#error:not([hidden])", { timeout: 5000 });
    const sentence = await page.textContent("#error");
    assert.ok(sentence.length > 20, sentence);
    console.log(`    ${slug}, ${value === "" ? "nothing" : value}: ${sentence}`);
    await page.fill(id, good);
    await page.waitForSelector("#error", { state: "hidden", timeout: 5000 });
    const time = () => page.evaluate(() => window.lagrangian.page.time);
    const mended = await time();
    await page.waitForTimeout(500);
    assert.ok((await time()) > mended, `${slug} does not go on`);
  }
  passed("nonsense is refused with a sentence, and the motion goes on when it is mended");
}

async function phone() {
  for (const path of ["index.html", "play.html", "models/general-top.html", "models/stewart-platform.html"]) {
    const page = await opened(path, { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true });
    await page.waitForTimeout(500);
    const [wide, shown] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= 390 && shown <= 390, `${path} is ${wide} px wide`);
    await page.context().close();
  }
  passed("nothing is wider than a phone");
}

async function screenshots() {
  await mkdir(options.screenshots, { recursive: true });
  for (const [name, path, settings] of [
    ["gallery", "index.html", {}],
    ["gallery-dark", "index.html", { colorScheme: "dark" }],
    ["play", "play.html#rattleback", {}],
    ["play-dark", "play.html#slung-load", { colorScheme: "dark" }],
    ["play-phone", "play.html#cart-pole", { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }],
    ["model", "models/general-top.html", {}],
  ]) {
    const page = await opened(path, settings);
    await page.waitForTimeout(4000);
    await page.screenshot({ path: join(options.screenshots, `${name}.png`), fullPage: name === "model" || name === "play-phone" });
    await page.context().close();
  }
}

try {
  const page = await opened("play.html");
  const models = await page.evaluate(() => window.lagrangian.page.models);
  await eachModelMoves(page, models);
  await costs(page, models);
  if (options.native) {
    await accelerations(page, models);
  }
  await keyboard(page, models);
  await nonsense(page, models);
  await phone();
  for (const model of models) {
    await (await opened(`models/${model.slug}.html`)).context().close();
  }
  if (options.screenshots) {
    await screenshots();
  }
  assert.deepEqual(complaints, []);
  passed("the console is clean");
} finally {
  await browser.close();
  server.close();
}
