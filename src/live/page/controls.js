"use strict";

// Sliders and fields of the machine's constants.

const rpm = (omega) => omega * 30 / Math.PI;

// A scale from a slider's 0..1000 to a constant: even, or by factors.
const evenScale = (from, to) => ({to: (p) => from + (to - from) * p / 1000, of: (x) => (x - from) / (to - from) * 1000});
const factorScale = (from, to) => ({to: (p) => from * (to / from) ** (p / 1000), of: (x) => Math.log(x / from) / Math.log(to / from) * 1000});

// The range of a constant's slider around its number in the machine that the page began with.
const scaleOf = (field, base, state) => {
  if (field.key === "start_position") return evenScale(state.get("wall_lower"), Math.min(state.get("wall_upper"), 1));
  if (field.range === "0..1") return evenScale(0, 1);
  if (field.key === "omega") return evenScale(0.02, state.fastest);
  if (field.unit === "rad") return evenScale(-Math.PI, Math.PI);
  if (field.range === "> 0" && base > 0) return factorScale(base / 10, base * 10);
  if (field.range === ">= 0") return evenScale(0, base > 0 ? 3 * base : 1);
  const most = Number.isFinite(base) && base !== 0 ? 3 * Math.abs(base) : 1;
  return evenScale(field.key === "wall_upper" ? state.get("wall_lower") + most / 30 : -most, most);
};

const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// One constant: a slider and a field. `unit`: what the field takes and writes, times `factor` in SI.
class Control {
  constructor({label, unit, read, write, scale, factor = 1, hint = ""}, changed) {
    Object.assign(this, {unit, read, write, scale, factor});
    const id = `constant-${Control.many = (Control.many ?? 0) + 1}`;
    this.field = element("input", {type: "text", id, inputMode: "decimal", autocomplete: "off", spellcheck: false});
    this.slider = element("input", {type: "range", min: 0, max: 1000, step: 1});
    this.slider.setAttribute("aria-label", label);
    const name = element("label", {htmlFor: id, textContent: label, title: hint});
    const written = unit && unit !== "1" ? [element("span", {className: "unit", textContent: unit})] : [];
    this.row = element("div", {className: "control"}, name, this.slider, element("span", {className: "value"}, this.field, ...written));
    this.slider.addEventListener("input", () => {
      const x = this.scale().to(Number(this.slider.value));
      changed(() => this.write(Number(x.toPrecision(4))), this);
    });
    this.field.addEventListener("change", () => changed(() => this.write(this.given()), this));
  }

  // The field's number in SI; with or without a unit.
  given() {
    const text = this.field.value.trim().replace(",", "."), plain = Number(text);
    if (text !== "" && !Number.isNaN(plain)) return plain * this.factor;
    const si = this.quantity?.(text);
    if (si === undefined || Number.isNaN(si)) throw new Error(`"${text}" is no number${this.unit && this.unit !== "1" ? `; with a unit it is such as "1 ${this.unit}"` : ""}`);
    return si;
  }

  // Shows what the state has.
  sync(except) {
    const x = this.read(), missing = Number.isNaN(x), text = missing ? "" : shown(x / this.factor, 5);
    if (except !== this || document.activeElement !== this.slider) {
      const place = Math.round(Math.min(1000, Math.max(0, this.scale().of(x))));
      this.slider.value = Number.isNaN(place) ? 0 : place;
    }
    this.slider.disabled = missing;
    this.slider.setAttribute("aria-valuetext", missing ? "not given" : `${text} ${this.unit === "1" ? "" : this.unit}`.trim());
    if (document.activeElement !== this.field || except === this) this.field.value = text;
  }
}

// A constant that is one of some words.
class Choice {
  constructor(field, {read, write}, changed) {
    Object.assign(this, {read});
    const id = `constant-${field.key}`;
    this.select = element("select", {id}, ...field.choices.map((text, value) => element("option", {textContent: text, value})));
    this.row = element("div", {className: "control"}, element("label", {htmlFor: id, textContent: field.key, title: field.remark}), this.select);
    this.select.addEventListener("change", () => changed(() => write(Number(this.select.value)), this));
  }

  sync() { this.select.value = this.read(); }
}

// The few constants that matter most.
const mainControls = (state, changed) => {
  const set = (key) => (x) => state.set({[key]: x}), get = (key) => () => state.get(key);
  const controls = [
    new Control({label: "Speed", unit: "rad/s", read: get("omega"), write: set("omega"), scale: () => evenScale(0.02, state.fastest), hint: "of the driver plate"}, changed),
    new Control({
      label: "Restitution", unit: "1", read: get("restitution_lower"), scale: () => evenScale(0, 1), hint: "speed after over before an impact, of both walls",
      write: (x) => state.set({restitution_lower: x, restitution_upper: x}),
    }, changed),
    new Control({label: "Friction", unit: "1", read: get("friction"), write: set("friction"), scale: () => evenScale(0, 1), hint: "Coulomb coefficient"}, changed),
    new Control({
      label: "Clearance", unit: "mm", factor: 1e-3, read: () => state.get("wall_upper") - state.get("wall_lower"), hint: "between the walls; the start keeps its place in it",
      scale: () => factorScale(1e-4, 1e-2),
      write: (x) => {
        const lower = state.get("wall_lower"), share = (state.get("start_position") - lower) / (state.get("wall_upper") - lower);
        state.set({wall_upper: lower + x, start_position: lower + (Number.isFinite(share) ? share : 0.5) * x});
      },
    }, changed),
    new Control({label: "Disturbance", unit: "N", read: get("disturbance"), write: set("disturbance"), scale: () => evenScale(0, 2), hint: "amplitude of a force that shakes the carrier"}, changed),
  ];
  const units = ["rad/s", "1", "1", "m", "N"];
  controls.forEach((control, k) => { control.quantity = (text) => state.machine.quantity(text, units[k]); });
  return controls;
};

// All constants, by the tables of a machine file.
const allControls = (state, root, changed) => {
  const controls = [];
  for (const table of ["scene", "window", "count", "model"]) {
    const group = element("fieldset", {}, element("legend", {textContent: `[${table}]`}));
    for (const field of state.machine.fields.filter((one) => one.table === table)) {
      const read = () => state.get(field.key);
      const write = (x) => state.set(field.key === "revolutions" ? {revolutions: x, seconds: NaN} : field.key === "seconds" ? {seconds: x, revolutions: NaN} : {[field.key]: x});
      const control = field.choices ? new Choice(field, {read, write}, changed)
        : new Control({label: field.key, unit: field.unit, read, write, scale: () => scaleOf(field, state.base[field.place], state), hint: [field.remark, field.range].filter(Boolean).join(", ")}, changed);
      if (!field.choices) control.quantity = (text) => state.machine.quantity(text, field.unit);
      controls.push(control);
      group.append(control.row);
    }
    root.append(group);
  }
  return controls;
};
