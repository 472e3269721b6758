"use strict";

// Charts: axes over a picture of its own size, so that texts are as large as those of the page.

const draw = (parent, name, attributes = {}, text) => {
  const part = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, value);
  if (text !== undefined) part.textContent = text;
  parent.append(part);
  return part;
};

// A number with so many digits, as short as it can be.
const shown = (x, digits = 3) => {
  const rounded = Number(x.toPrecision(digits));
  return Math.abs(rounded) >= 1e6 && Number.isFinite(rounded) ? rounded.toExponential().replace("e+", "e") : String(rounded);
};

// Round numbers from a to b, about `many`.
const ticks = (a, b, many) => {
  const raw = (b - a) / many, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((m) => m * power >= raw * 0.999) * power, all = [];
  for (let k = Math.ceil(a / step - 1e-9); k * step <= b + 1e-9 * step; ++k) all.push(Number((k * step).toPrecision(12)));
  return all;
};

class Chart {
  // `figure` has one svg. `axes`: {x: {from, to, label}, y: the same}; rows above the plot for labels.
  constructor(figure, height) {
    this.svg = figure.querySelector("svg");
    this.height = height;
    this.title = draw(this.svg, "title");
    this.title.id = `${figure.id}-title`;
    this.svg.setAttribute("role", "img");
    this.svg.setAttribute("aria-labelledby", this.title.id);
    new ResizeObserver(() => { if (this.svg.clientWidth !== this.width && this.again) this.again(); }).observe(this.svg);
  }

  // Begins again: an empty plot with these axes. `said`: the chart in a sentence.
  begin({x, y, said, rows = 0, left = 46}) {
    this.width = Math.max(280, this.svg.clientWidth);
    Object.assign(this, {left, right: this.width - 12, top: 8 + 16 * rows, bottom: this.height - 40, xAxis: x, yAxis: y});
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.svg.setAttribute("height", this.height);
    this.svg.replaceChildren(this.title);
    if (this.title.textContent !== said) this.title.textContent = said;
    const grid = draw(this.svg, "g", {class: "grid"});
    for (const tick of ticks(x.from, x.to, this.width / 90)) {
      draw(grid, "line", {x1: this.x(tick), x2: this.x(tick), y1: this.top, y2: this.bottom});
      draw(grid, "text", {x: this.x(tick), y: this.bottom + 16, "text-anchor": "middle"}, shown(tick));
    }
    for (const tick of y.ticks ?? ticks(y.from, y.to, (this.bottom - this.top) / 45)) {
      draw(grid, "line", {x1: this.left, x2: this.right, y1: this.y(tick), y2: this.y(tick)});
      draw(grid, "text", {x: this.left - 6, y: this.y(tick) + 4, "text-anchor": "end"}, y.write ? y.write(tick) : shown(tick));
    }
    draw(grid, "text", {x: (this.left + this.right) / 2, y: this.height - 6, "text-anchor": "middle"}, x.label);
    draw(grid, "text", {x: 12, y: (this.top + this.bottom) / 2, transform: `rotate(-90 12 ${(this.top + this.bottom) / 2})`, "text-anchor": "middle"}, y.label);
    this.marks = draw(this.svg, "g");
    return this.marks;
  }

  x(value) { return this.left + (value - this.xAxis.from) / (this.xAxis.to - this.xAxis.from) * (this.right - this.left); }
  y(value) {
    const {from, to, log} = this.yAxis, share = log ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
    return this.bottom - share * (this.bottom - this.top);
  }

  // The value on the x axis under a pointer.
  under(event) {
    const box = this.svg.getBoundingClientRect(), at = (event.clientX - box.left) / box.width * this.width;
    return this.xAxis.from + (at - this.left) / (this.right - this.left) * (this.xAxis.to - this.xAxis.from);
  }

  // A vertical line at x with a label in one of the rows above the plot.
  rule(x, label, kind, row) {
    if (!(x >= this.xAxis.from && x <= this.xAxis.to)) return;
    const at = this.x(x), late = at > (this.left + this.right) / 2;
    draw(this.svg, "line", {class: `rule ${kind}`, x1: at, x2: at, y1: 4 + 16 * row, y2: this.bottom});
    draw(this.svg, "text", {class: `rule-label ${kind}`, x: at + (late ? -5 : 5), y: 14 + 16 * row, "text-anchor": late ? "end" : "start"}, label);
  }
}

// The colour of a number of collisions a turn: its class; from 6 on pairs share one.
const loudness = (perTurn) => `turn-${Math.min(6, Math.ceil(perTurn / 2))}`;

const collisions = (many) => `${shown(many)} collision${many === 1 ? "" : "s"}`;
const inTurns = (omega) => `${shown(omega * 30 / Math.PI)} rpm`;
