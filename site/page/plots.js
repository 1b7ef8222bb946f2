// Time plots: a strip for each curve, the newest time at the right.

import { prepared } from "./painter.js";

const STRIP = 92;
const LEFT = 64;

/** A number in few digits. */
function short(x) {
  const size = Math.abs(x);
  return size !== 0 && (size >= 1e5 || size < 1e-3) ? x.toExponential(1) : String(Number(x.toPrecision(3)));
}

export class Plots {
  constructor(canvas) {
    this.canvas = canvas;
    this.clear([], 10);
  }

  clear(curves, seconds) {
    this.curves = curves;
    this.seconds = seconds;
    this.samples = [];
    this.canvas.style.height = `${STRIP * Math.max(1, curves.length)}px`;
  }

  add(time, values) {
    this.samples.push([time, ...values]);
    while (this.samples[0][0] < time - this.seconds) {
      this.samples.shift();
    }
  }

  paint() {
    const [width, height] = [this.canvas.clientWidth, STRIP * Math.max(1, this.curves.length)];
    const context = prepared(this.canvas, width, height);
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name);
    const end = Math.max(this.seconds, this.samples.at(-1)?.[0] ?? 0);
    const across = (t) => LEFT + ((t - end + this.seconds) / this.seconds) * (width - LEFT - 6);
    context.font = "13px system-ui, sans-serif";
    for (const [index, curve] of this.curves.entries()) {
      const [top, bottom] = [index * STRIP + 22, (index + 1) * STRIP - 10];
      const values = this.samples.map((sample) => sample[index + 1]).filter(Number.isFinite);
      let [low, high] = [Math.min(...values), Math.max(...values)];
      if (!(high - low > 1e-9 * Math.max(1, Math.abs(high)))) {
        [low, high] = [low - 1, high + 1];
      }
      const up = (x) => bottom - ((x - low) / (high - low)) * (bottom - top);
      context.fillStyle = color("--text");
      context.textAlign = "left";
      context.fillText(curve.unit ? `${curve.name} in ${curve.unit}` : curve.name, LEFT, top - 9);
      context.fillStyle = color("--soft");
      context.textAlign = "right";
      if (values.length > 0) {
        context.fillText(short(high), LEFT - 8, top + 6);
        context.fillText(short(low), LEFT - 8, bottom + 3);
      }
      context.strokeStyle = color("--edge");
      context.lineWidth = 1;
      context.strokeRect(LEFT, top, width - LEFT - 6, bottom - top);
      context.strokeStyle = color(`--curve-${index % 4}`);
      context.lineWidth = 1.8;
      context.lineJoin = "round";
      context.beginPath();
      for (const sample of this.samples) {
        context.lineTo(across(sample[0]), up(sample[index + 1]));
      }
      context.stroke();
    }
  }
}
