// Sliders with number fields, in three groups.

const TITLES = { control: "Control", parameter: "Parameters", start: "Start" };

/** The step of a slider: a five-hundredth of its range, rounded to 1, 2 or 5 of a decimal. */
function step([low, high]) {
  const rough = (high - low) / 500;
  const unit = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((k) => k * unit).find((size) => size >= 0.999 * rough);
}

function made(tag, properties) {
  return Object.assign(document.createElement(tag), properties);
}

export class Sliders {
  constructor(form, changed) {
    this.form = form;
    this.changed = changed;
    this.current = [];
    form.addEventListener("submit", (event) => event.preventDefault());
  }

  values() {
    return new Float64Array(this.current);
  }

  show(quantities) {
    this.current = quantities.map((quantity) => quantity.value);
    this.form.replaceChildren();
    for (const group of ["control", "parameter", "start"]) {
      const members = [...quantities.entries()].filter(([, quantity]) => quantity.group === group);
      if (members.length > 0) {
        const fieldset = document.createElement("fieldset");
        fieldset.append(made("legend", { textContent: TITLES[group] }));
        fieldset.append(...members.map(([index, quantity]) => this.slider(index, quantity)));
        this.form.append(fieldset);
      }
    }
  }

  set(index, quantity, value) {
    this.current[index] = value;
    this.changed(quantity.group);
  }

  slider(index, quantity) {
    const row = made("div", { className: "slider" });
    const id = `slider-${index}`;
    const label = made("label", { htmlFor: id, textContent: quantity.name });
    if (quantity.isSwitch) {
      const box = made("input", { type: "checkbox", id, checked: quantity.value > 0.5 });
      box.addEventListener("change", () => this.set(index, quantity, box.checked ? 1 : 0));
      row.append(label, box);
      return row;
    }
    const name = quantity.unit ? `${quantity.name} in ${quantity.unit}` : quantity.name;
    const [min, max] = quantity.range;
    const range = made("input", { type: "range", id, min, max, step: step(quantity.range) });
    const number = made("input", { type: "number", step: "any", value: quantity.value, id: `number-${index}` });
    range.value = quantity.value;
    range.setAttribute("aria-label", name);
    number.setAttribute("aria-label", `${name}, as a number`);
    range.addEventListener("input", () => {
      number.value = range.value;
      this.set(index, quantity, Number(range.value));
    });
    number.addEventListener("input", () => {
      // An empty field, and text that is no number, are not a number: the model says so.
      const value = number.value === "" ? NaN : Number(number.value);
      range.value = number.value;
      this.set(index, quantity, value);
    });
    label.append(made("span", { className: "unit", textContent: quantity.unit ? ` ${quantity.unit}` : "" }));
    row.append(label, number, range);
    return row;
  }
}
