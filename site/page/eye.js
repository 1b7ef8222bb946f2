// Where the drawing is seen from: turned by mouse, touch and arrow keys.

const HIGHEST = 1.5;

export class Eye {
  constructor(canvas) {
    this.pointers = new Map();
    this.look([0.3, 0.2]);
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, event);
    });
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.scale(Math.exp(-0.0015 * event.deltaY));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  look([azimuth, height]) {
    [this.azimuth, this.height, this.zoom] = [azimuth, height, 1];
  }

  turn(azimuth, height) {
    this.azimuth += azimuth;
    this.height = Math.max(-HIGHEST, Math.min(HIGHEST, this.height + height));
  }

  scale(factor) {
    this.zoom = Math.max(0.3, Math.min(6, this.zoom * factor));
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      return;
    }
    if (this.pointers.size === 1) {
      this.turn(-0.008 * (event.clientX - before.clientX), 0.008 * (event.clientY - before.clientY));
    } else {
      const [other] = [...this.pointers.values()].filter((pointer) => pointer.pointerId !== event.pointerId);
      const distance = (pointer) => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
      this.scale(distance(event) / Math.max(1, distance(before)));
    }
    this.pointers.set(event.pointerId, event);
  }

  key(event) {
    const steps = { ArrowLeft: [0.08, 0], ArrowRight: [-0.08, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };
    if (steps[event.key]) {
      this.turn(...steps[event.key]);
      event.preventDefault();
    } else if (event.key === "+" || event.key === "=") {
      this.scale(1.15);
    } else if (event.key === "-" || event.key === "−") {
      this.scale(1 / 1.15);
    }
  }
}
