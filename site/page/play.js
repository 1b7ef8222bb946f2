// The page in the browser: it chooses a model, lets it move in real time, and shows it.

import init, { Player, colors, description } from "./browser.js";
import { Eye } from "./eye.js";
import { paint } from "./painter.js";
import { Plots } from "./plots.js";
import { Sliders } from "./sliders.js";

/** How long the steps of one frame may take, in ms. */
const BUDGET = 7;

const element = (id) => document.getElementById(id);
const dark = window.matchMedia("(prefers-color-scheme: dark)");

class Page {
  constructor(models) {
    this.models = models;
    this.drawing = element("drawing");
    this.eye = new Eye(this.drawing);
    this.plots = new Plots(element("plots"));
    this.sliders = new Sliders(element("sliders"), (group) => this.changed(group));
    this.player = null;
    this.play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches);
    this.time = 0;
    this.last = null;
    this.frames = { since: 0, count: 0 };
    this.colors = colors(dark.matches);
    dark.addEventListener("change", () => {
      this.colors = colors(dark.matches);
    });
    for (const [index, model] of models.entries()) {
      element("model").add(new Option(model.title, index));
    }
    element("model").addEventListener("change", () => {
      window.location.hash = models[Number(element("model").value)].slug;
    });
    window.addEventListener("hashchange", () => this.choose());
    element("play").addEventListener("click", () => this.play(!this.isPlaying));
    element("reset").addEventListener("click", () => this.begin());
    document.addEventListener("keydown", (event) => this.key(event));
    this.choose();
    const frame = (now) => {
      this.frame(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /** Shows the model of the address. */
  choose() {
    const slug = window.location.hash.slice(1);
    const index = Math.max(0, this.models.findIndex((model) => model.slug === slug));
    const model = this.models[index];
    this.index = index;
    this.model = model;
    element("model").value = String(index);
    element("sentence").textContent = model.sentence;
    element("about").href = `models/${model.slug}.html`;
    this.drawing.setAttribute("aria-label", `Drawing of the model: ${model.title}`);
    document.title = `${model.title} · lagrangian`;
    this.sliders.show(model.quantities);
    this.eye.look(model.view);
    this.equations(model.slug);
    this.begin();
  }

  async equations(slug) {
    const answer = await fetch(`equations/${slug}.html`);
    const text = answer.ok ? await answer.text() : "";
    if (this.model.slug === slug) {
      element("equations").innerHTML = text;
    }
  }

  /** Begins the motion with the values of the sliders; what is wrong with them is said, and the last drawing stays. */
  begin() {
    const next = this.attempt(() => new Player(this.index, this.sliders.values()));
    this.player?.free();
    this.player = next;
    this.time = 0;
    this.plots.clear(this.model.curves, 10 * this.model.pace);
    if (next) {
      this.attempt(() => next.show(0));
      this.plots.add(0, next.curves());
    }
  }

  changed(group) {
    if (group === "control" && this.player) {
      this.player.control(this.sliders.values());
    } else {
      this.begin();
    }
  }

  /** Calls the library; its error is shown. */
  attempt(call) {
    const error = element("error");
    try {
      const result = call();
      error.hidden = true;
      return result;
    } catch (reason) {
      error.textContent = String(reason.message ?? reason);
      error.hidden = false;
      return null;
    }
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    element("play").textContent = isPlaying ? "Pause" : "Play";
  }

  key(event) {
    // In a number field and in a list, letters have another meaning.
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches("select, [type=number]")) {
      return;
    }
    if (event.key === "p") {
      this.play(!this.isPlaying);
    } else if (event.key === "r") {
      this.begin();
    }
  }

  /** Goes on to a time, as far as the budget of a frame allows. */
  advance(target) {
    const begin = performance.now();
    while (this.player.reached < target && performance.now() - begin < BUDGET) {
      this.player.step();
    }
    this.time = Math.min(target, this.player.reached);
    this.player.show(this.time);
    this.plots.add(this.time, this.player.curves());
  }

  frame(now) {
    const passed = this.last === null ? 0 : Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    this.count(now);
    if (!this.player) {
      return;
    }
    if (this.isPlaying && passed > 0) {
      const target = this.time + passed * Number(element("speed").value) * this.model.pace;
      if (this.attempt(() => this.advance(target) ?? true) === null) {
        this.player.free();
        this.player = null;
        return;
      }
    }
    const { azimuth, height, zoom } = this.eye;
    const { clientWidth, clientHeight } = this.drawing;
    paint(this.drawing, this.player.picture(azimuth, height, zoom, clientWidth, clientHeight), this.colors);
    this.plots.paint();
    element("time").textContent = this.time.toFixed(2);
    const error = this.player.energyError;
    element("energy").textContent = error === 0 ? "0" : error.toExponential(1).replace("-", "−");
    element("energy").dataset.value = String(error);
  }

  count(now) {
    this.frames.count += 1;
    const passed = now - this.frames.since;
    if (passed > 1000) {
      element("frames").textContent = Math.round((1000 * this.frames.count) / passed).toString();
      this.frames = { since: now, count: 0 };
    }
  }
}

await init({ module_or_path: new URL("browser_bg.wasm", import.meta.url) });
// What the tests of the browser call.
window.lagrangian = { Player, page: new Page(JSON.parse(description())) };
