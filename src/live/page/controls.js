"use strict";

// Sliders and fields of the machine's constants.

// A scale from a slider's 0..1000 to a constant: even, or by factors.
const evenScale = (from, to) => ({to: (p) => from + (to - from) * p / 1000, of: (x) => (x - from) / (to - from) * 1000});
const factorScale = (from, to) => ({to: (p) => from * (to / from) ** (p / 1000), of: (x) => Math.log(x / from) / Math.log(to / from) * 1000});

// By factors around a number > 0, or else from `from` to `to`.
const scaleAround = (x, from, to) => Number.isFinite(x) && x > 0 ? factorScale(x / 10, x * 10) : factorScale(from, to);

// A number without the digits that a factor adds: 0.0009, not 0.0009000000000000001.
const tidy = (x) => Number(x.toPrecision(15));

// The range of a constant's slider around its number in the machine that the page began with.
const rangeOf = (field, base, state) => {
  if (field.key === "start_position") return evenScale(state.get("wall_lower"), Math.min(state.get("wall_upper"), 1));
  if (field.range === "0..1") return evenScale(0, 1);
  if (field.key === "omega") return evenScale(0.02, state.fastest);
  if (field.unit === "rad") return evenScale(-Math.PI, Math.PI);
  if (field.range === "> 0" && base > 0) return scaleAround(base);
  if (field.range === ">= 0") return evenScale(0, base > 0 ? 3 * base : 1);
  const most = Number.isFinite(base) && base !== 0 ? 3 * Math.abs(base) : 1;
  return evenScale(field.key === "wall_upper" ? state.get("wall_lower") + most / 30 : -most, most);
};

const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// A name as parts of a line that may be broken after "_" and "^", rather than within a word.
const breakable = (text) => text.split(/(?<=[_^])/).flatMap((part, k) => k ? [document.createElement("wbr"), part] : [part]);

// One constant: a slider and a field. `unit`: what the field takes and writes, times `factor` in SI; `quantity`: the number in SI of a text
// with a unit; `beside`: what stands below the unit.
class Control {
  constructor({label, unit, read, write, scale, quantity, factor = 1, hint = "", beside}, changed) {
    Object.assign(this, {unit, read, write, scale, quantity, factor, beside});
    const id = `constant-${Control.many = (Control.many ?? 0) + 1}`;
    this.field = element("input", {type: "text", id, inputMode: "decimal", autocomplete: "off", spellcheck: false});
    this.slider = element("input", {type: "range", min: 0, max: 1000, step: 1});
    this.slider.setAttribute("aria-label", label);
    const name = element("label", {htmlFor: id, title: hint}, element("span", {}, ...breakable(label)));
    this.written = element("span", {className: "unit"});
    this.row = element("div", {className: "control"}, name, this.slider, element("span", {className: "value"}, this.field, this.written));
    this.slider.addEventListener("input", () => {
      const x = this.scale().to(Number(this.slider.value));
      changed(() => this.write(Number(x.toPrecision(4))), this);
    });
    this.field.addEventListener("change", () => changed(() => this.write(this.given()), this));
  }

  // The field's number in SI; with or without a unit.
  given() {
    const text = this.field.value.trim().replace(",", "."), plain = Number(text);
    if (text !== "" && !Number.isNaN(plain)) return tidy(plain * this.factor);
    const si = this.quantity(text);
    if (Number.isNaN(si)) throw new Error(`"${text}" is no number${this.unit && this.unit !== "1" ? `; with a unit it is such as "1 ${this.unit}"` : ""}`);
    return si;
  }

  // Shows what the state has.
  sync(except) {
    const x = this.read(), missing = Number.isNaN(x), text = missing ? "" : number(x / this.factor, 5), {field} = this;
    if (except !== this || document.activeElement !== this.slider) {
      const place = Math.round(Math.min(1000, Math.max(0, this.scale().of(x))));
      this.slider.value = Number.isNaN(place) ? 0 : place;
    }
    this.slider.disabled = missing;
    this.slider.setAttribute("aria-valuetext", missing ? "not given" : `${text} ${this.unit === "1" ? "" : this.unit}`.trim());
    // What somebody is writing stays.
    if (document.activeElement !== field || except === this || field.value === field.defaultValue) field.value = text;
    field.defaultValue = text;
    this.writeUnit(x);
  }

  writeUnit(x) { this.written.replaceChildren(...breakable(this.unit === "1" ? "" : this.unit), ...(this.beside && x > 0 ? [`\n${this.beside(x)}`] : [])); }
}

// A constant that is one of some words.
class Choice {
  constructor(field, {read, write}, changed) {
    Object.assign(this, {read});
    const id = `constant-${field.key}`;
    this.select = element("select", {id}, ...field.choices.map((text, value) => element("option", {textContent: text, value})));
    this.row = element("div", {className: "control"}, element("label", {htmlFor: id, title: field.remark}, element("span", {}, ...breakable(field.key))), this.select);
    this.select.addEventListener("change", () => changed(() => write(Number(this.select.value)), this));
  }

  sync() { this.select.value = this.read(); }
}

// The few constants that matter most.
const mainControls = (state, changed) => {
  const clearanceOf = (get) => get("wall_upper") - get("wall_lower"), of = (key) => ({read: () => state.get(key), write: (x) => state.set({[key]: x})});
  return [
    {label: "Speed", unit: "rad/s", si: "rad/s", ...of("omega"), scale: () => evenScale(0.02, state.fastest), hint: "of the driver plate", beside: (x) => `${number(rpm(x))} rpm`},
    {
      label: "Counting limit", unit: "mm/s", si: "m/s", factor: 1e-3, ...of("counting_limit"), scale: () => scaleAround(state.baseOf("counting_limit"), 1e-4, 1e-1),
      hint: "the slowest impact that counts; fitted to the paper's thresholds, not measured",
    },
    {
      label: "Restitution", unit: "1", si: "1", read: () => state.get("restitution_lower"), scale: () => evenScale(0, 1), hint: "speed after over before an impact, of both walls",
      write: (x) => state.set({restitution_lower: x, restitution_upper: x}),
    },
    {label: "Friction", unit: "1", si: "1", ...of("friction"), scale: () => evenScale(0, 1), hint: "Coulomb coefficient"},
    {
      label: "Clearance", unit: "mm", si: "m", factor: 1e-3, read: () => clearanceOf((key) => state.get(key)), hint: "between the walls; the start keeps its place in it",
      scale: () => scaleAround(clearanceOf((key) => state.baseOf(key)), 1e-4, 1e-2),
      write: (x) => {
        const lower = state.get("wall_lower"), share = (state.get("start_position") - lower) / (state.get("wall_upper") - lower);
        state.set({wall_upper: tidy(lower + x), start_position: tidy(lower + (Number.isFinite(share) ? share : 0.5) * x)});
      },
    },
    {label: "Disturbance", unit: "N", si: "N", ...of("disturbance"), scale: () => evenScale(0, 2), hint: "amplitude of a force that shakes the carrier"},
  ].map((one) => new Control({...one, quantity: (text) => state.machine.quantity(text, one.si)}, changed));
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
        : new Control({label: field.key, unit: field.unit, read, write, scale: () => rangeOf(field, state.base[field.place], state), hint: [field.remark, field.range].filter(Boolean).join(", "), quantity: (text) => state.machine.quantity(text, field.unit)}, changed);
      controls.push(control);
      group.append(control.row);
    }
    root.append(group);
  }
  return controls;
};
