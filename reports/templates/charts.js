// The charts that scripts draw: axes, lines, steps, points, rules, names, a legend, and what is told of the point under the
// pointer. A chart is an SVG as large as its place on the page; its numbers are offered as a CSV file. Colours are
// attributes, so that a saved picture has them: look.css replaces them in the dark, and a page by the class of a set.
"use strict";

const textSize = 12, font = "system-ui, sans-serif", quiet = "#444444", ink = "#222222";
// Of the first, second, ... line: as in the pictures of all reports, where a test looks at them with the eyes of dichromats.
const colours = ["#0072b2", "#d55e00", "#00a56a", "#7b2475", "#dd6ba0", "#6b4f00", "#606060"], dashes = ["", "8 3", "2 3"];
const lineLook = (place) => ({colour: colours[place % colours.length], dash: dashes[Math.floor(place / colours.length) % dashes.length]});
const ruler = document.createElement("canvas").getContext("2d");
ruler.font = `${textSize}px ${font}`;
const widthOf = (text) => ruler.measureText(text).width;
const rounded = (value) => Math.round(10 * value) / 10;

const addSvg = (parent, name, attributes = {}, text) => {
  const part = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined) part.setAttribute(key, typeof value === "number" ? rounded(value) : value);
  }
  if (text !== undefined) part.textContent = text;
  parent.append(part);
  return part;
};

// Of an axis {logarithmic, min, max}: the powers of ten, and more of each the fewer there are; on a linear axis `many` round
// numbers, or some more.
const ticksOf = ({logarithmic, min, max}, many = 6) => {
  const ticks = [];
  if (logarithmic) {
    const decades = Math.log10(max / min), every = Math.ceil(decades / 8);
    const kept = decades > 2.5 ? [1] : decades > 0.9 ? [1, 2, 5] : decades > 0.4 ? [1, 2, 3, 5, 7] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
    for (let power = Math.floor(Math.log10(min)); power <= Math.log10(max); ++power) {
      if (kept.length > 1 || power % every === 0) ticks.push(...kept.map((digit) => digit * 10 ** power));
    }
  } else {
    const rough = (max - min) / many, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find((one) => one * power >= 0.999 * rough) * power;
    for (let place = Math.ceil(min / step - 1e-9); place * step <= max + 1e-9 * step; ++place) ticks.push(place * step);
  }
  return ticks.map((value) => Number(value.toPrecision(12))).filter((value) => value >= min && value <= max);
};
const tickLabel = (value) => value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6) ? String(Number(value.toPrecision(6))) : value.toExponential(0).replace("e+", "e");

// Where a value of an axis stands between two pixels; what lies outside stands at the end. `inverse`: the value at a pixel.
const scaleOf = ({logarithmic, min, max}, from, to) => {
  const part = logarithmic ? (value) => Math.log(value / min) / Math.log(max / min) : (value) => (value - min) / (max - min);
  const inverse = (pixel) => { const share = (pixel - from) / (to - from); return logarithmic ? min * (max / min) ** share : min + share * (max - min); };
  return Object.assign((value) => from + Math.min(1, Math.max(0, part(value))) * (to - from), {inverse});
};

// Labels {value, text} of an axis about `pixels` long, one each `apart` pixels; by `factor` in the unit of its second scale.
const labelsOf = (axis, pixels, apart, factor = 1) => {
  const ticks = (factor === 1 && axis.ticks) || ticksOf({...axis, min: axis.min * factor, max: axis.max * factor}, pixels / apart);
  return ticks.map((tick) => ({value: tick / factor, text: (axis.write ?? tickLabel)(tick)}));
};
const widest = (labels) => Math.max(0, ...labels.map(({text}) => widthOf(text)));

// Draws grid, labels, frame and titles of the axes `x`, `y` around an area of pixels. An axis: {title, min, max, logarithmic}, and
// perhaps `ticks`, their text by `write`, its own `unit` and a `second` unit {unit, factor}, whose scale is at the other side of y and below
// x. Returns the scales {x, y}.
const drawAxes = (group, {left, top, right, bottom}, {x, y, width, height}) => {
  const scales = {x: scaleOf(x, left, right), y: scaleOf(y, bottom, top)};
  const grid = addSvg(group, "path", {stroke: "#e4e4e4", fill: "none"}), middle = (top + bottom) / 2;
  const note = (at, level, text, anchor = "middle", more = {}) => addSvg(group, "text", {x: at, y: level, "text-anchor": anchor, fill: quiet, ...more}, text);
  let lines = "";
  [x, x.second].forEach((scale, row) => {
    if (!scale) return;
    const level = bottom + 16 + 15 * row;
    let free = 0;
    if (scale.unit && x.second) free = left - 9, note(free, level, scale.unit, "end");
    for (const {value, text} of labelsOf(x, right - left, 80, scale.factor)) {
      const at = scales.x(value), half = widthOf(text) / 2 + 3;
      if (at - half < free || at + half > width) continue;
      lines += row ? `M${rounded(at)},${bottom}v4` : `M${rounded(at)},${top}V${bottom}`;
      note(at, level, text);
      free = at + half;
    }
  });
  [y, y.second].forEach((scale, side) => {
    if (!scale) return;
    let free = height;
    for (const {value, text} of labelsOf(y, bottom - top, 34, scale.factor)) {
      const at = scales.y(value);
      if (at + textSize > free) continue;
      lines += side ? `M${right},${rounded(at)}h4` : `M${left},${rounded(at)}H${right}`;
      note(side ? right + 7 : left - 6, at + 4, text, side ? "start" : "end");
      free = at;
    }
  });
  grid.setAttribute("d", lines);
  addSvg(group, "path", {d: `M${left},${top}V${bottom}H${right}${y.second ? `V${top}` : ""}`, stroke: "#888888", fill: "none"});
  note(Math.min((left + right) / 2, width - widthOf(x.title) / 2), height - 6, x.title, "middle", {fill: "black"});
  note(12, middle, y.title, "middle", {transform: `rotate(-90 12 ${rounded(middle)})`, fill: "black"});
  if (y.second) note(width - 4, middle, y.second.unit, "middle", {transform: `rotate(-90 ${width - 4} ${rounded(middle)})`, fill: "black"});
  return scales;
};

const csvOf = (names, rows) => {
  const quoted = (value) => /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  return [names, ...rows].map((row) => row.map((value) => quoted(String(value ?? ""))).join(",") + "\n").join("");
};

const outlines = {
  circle: (x, y, r) => `M${x - r},${y}a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0z`,
  square: (x, y, r) => `M${x - r},${y - r}h${2 * r}v${2 * r}h${-2 * r}z`,
  triangle: (x, y, r) => `M${x},${y - r}L${x + r},${y + .8 * r}H${x - r}z`,
};

// A place for a name near its point, `away` pixels further than usual: within the area, and on nothing that is there. Far ones need a line.
const roomFor = (width, {x, y}, away, area, taken) =>
  [[7, 0], [-width - 7, 0], [7, -12], [7, 12], [-width - 7, -12], [-width - 7, 12], [-width / 2, -14], [-width / 2, 14],
   [14, -26], [14, 26], [-width - 14, -26], [-width - 14, 26], [14, -42], [14, 42], [-width - 14, -42], [-width - 14, 42]]
    .map(([dx, dy]) => [x + dx + Math.sign(dx) * away, dy])
    .map(([left, dy]) => ({left, top: y + dy - 7, right: left + width, bottom: y + dy + 7, far: Math.abs(dy) > 20}))
    .find((b) => b.left >= area.left && b.right <= area.right && b.top >= area.top && b.bottom <= area.bottom &&
      !taken.some((t) => b.left < t.right && b.right > t.left && b.top < t.bottom && b.bottom > t.top));

class Chart {
  // `height` [px]: of the picture, with one row of a legend.
  constructor(svg, height) {
    const title = svg.querySelector("title") ?? addSvg(svg, "title", {id: `${svg.id || svg.parentElement.id}-title`});
    Object.assign(this, {svg, title, height, tip: Object.assign(document.createElement("p"), {className: "tip", hidden: true})});
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-labelledby", title.id);
    svg.after(this.tip);
    svg.addEventListener("pointermove", (event) => this.tellNearest(event));
    svg.addEventListener("pointerleave", () => { this.tip.hidden = true; });
    new ResizeObserver(() => {
      if (this.shown && svg.clientWidth && svg.clientWidth !== this.width) this.draw(this.shown);
    }).observe(svg);
  }

  // `title`: the chart in a sentence; `heading`: what stands above it. `x`, `y`: see drawAxes(). `sets`, from the lowest up:
  // {data: [{x, y, name, className}], colour, nameColour, shape, radius, kind, line, dash, told, className}. `line` is
  // "steps" or "straight", and its tooltip `told`; a legend shows the sets that have a `kind`. `rules`: vertical lines
  // {x, label, row, dash, className}, with labels in rows above the area. `below`, `above`: draw a page's own marks into the
  // group that they get, by x() and y() of this chart. `tell`: lines on a point, of which the first names it. `numbers`:
  // [names, rows] of the CSV file, in place of all points.
  draw(shown) {
    const {svg} = this, {x, y, sets = [], rules = []} = shown, width = svg.clientWidth || 560;
    Object.assign(this, {shown, width});
    const labelWidth = (factor) => widest(labelsOf(y, this.height - 50, 34, factor)), units = x.second ? [x, x.second].map(({unit}) => ({text: unit})) : [];
    const left = Math.max((y.title ? 30 : 10) + labelWidth(1), 14 + widest(units)), right = width - (y.second ? 28 + labelWidth(y.second.factor) : 12);
    const keys = document.createElementNS("http://www.w3.org/2000/svg", "g"), headed = shown.heading ? 20 : 0, legend = this.legend(keys, left, headed + 10);
    const rows = Math.max(0, ...rules.filter(({label}) => label).map(({row = 0}) => row + 1)), height = this.height + Math.max(0, legend - 26);
    const area = this.area = {left, top: headed + legend + 16 * rows, right, bottom: height - (x.second ? 53 : 38)};
    if (this.title.textContent !== shown.title) this.title.textContent = shown.title;
    svg.replaceChildren(this.title);
    for (const [key, value] of Object.entries({viewBox: `0 0 ${width} ${height}`, "font-family": font, "font-size": textSize, height})) svg.setAttribute(key, value);
    const group = addSvg(svg, "g");
    addSvg(group, "title", {}, "");  // the picture's title is no tooltip of its parts
    addSvg(group, "rect", {width, height, fill: "#ffffff"});
    if (headed) addSvg(group, "text", {x: left, y: 15, class: "chart-heading", "font-weight": 600, fill: "black"}, shown.heading);
    Object.assign(this, drawAxes(group, area, {x, y, width, height}));
    group.append(keys);
    shown.below?.(addSvg(group, "g"));
    this.marks = sets.flatMap((set) => set.data.map((point) => ({x: this.x(point.x), y: this.y(point.y), point, set})));
    for (const set of sets) this.line(group, set);
    for (const mark of this.marks.filter(({set}) => set.radius)) this.point(group, mark);
    this.names(group, area);
    for (const rule of rules) this.rule(group, rule);
    shown.above?.(addSvg(group, "g"));
    const file = svg.parentElement.querySelector(".chart-csv");
    if (file) file.textContent = JSON.stringify(csvOf(...shown.numbers ?? [["name", x.title, y.title], this.marks.map(({point}) => [shown.tell?.(point)[0], point.x, point.y])]));
  }

  // Returns the height of the legend: 26 px of one row, and 15 px of each further one.
  legend(group, left, top) {
    let x = left, y = top;
    const named = (this.shown.sets ?? []).filter(({kind}) => kind);
    for (const {kind, colour, shape, line, dash, className} of named) {
      const wide = line ? 22 : 8;
      if (x > left && x + wide + 4 + widthOf(kind) > this.width) [x, y] = [left, y + 15];
      const d = line ? `M${rounded(x)},${y}h${wide}` : outlines[shape ?? "circle"](x + 4, y, 4);
      addSvg(group, "path", {d, class: `key ${className ?? ""}`, ...(line ? {stroke: colour, fill: "none", "stroke-width": 2.4, "stroke-dasharray": dash || undefined} : {fill: colour})});
      addSvg(group, "text", {x: x + wide + 4, y: y + 4, fill: "black"}, kind);
      x += wide + 16 + widthOf(kind);
    }
    return named.length ? y - top + 26 : 8;
  }

  line(group, set) {
    if (!set.line || set.data.length < 2) return;
    const ends = this.marks.filter((mark) => mark.set === set).map(({x, y}) => [rounded(x), rounded(y)]);
    const d = "M" + ends.map(([x, y], i) => i === 0 ? `${x},${y}` : set.line === "steps" ? `H${x}V${y}` : `L${x},${y}`).join("");
    const path = addSvg(group, "path", {d, class: `line ${set.className ?? ""}`, stroke: set.colour, fill: "none", "stroke-width": "1.7", "stroke-dasharray": set.dash || undefined});
    if (set.told) addSvg(path, "title", {}, set.told);
  }

  point(group, {x, y, point, set}) {
    const d = outlines[set.shape ?? "circle"](rounded(x), rounded(y), set.radius);
    addSvg(group, "path", {d, class: point.className ?? set.className, fill: set.colour, stroke: set.colour});
  }

  rule(group, {x, label, row = 0, dash, className = ""}) {
    if (!(x >= this.shown.x.min && x <= this.shown.x.max)) return;
    const {left, top, right, bottom} = this.area, at = this.x(x), late = at > (left + right) / 2, level = this.shown.heading ? 34 + 16 * row : 14 + 16 * row;
    addSvg(group, "path", {class: `rule ${className}`, d: `M${rounded(at)},${label ? level - 10 : top}V${bottom}`, stroke: ink, "stroke-width": "1.7", "stroke-dasharray": dash, fill: "none"});
    if (!label) return;
    addSvg(group, "text", {class: `rule-label ${className}`, x: at + (late ? -5 : 5), y: level, "text-anchor": late ? "end" : "start", fill: ink, "font-weight": 600}, label);
  }

  // Names beside points where there is room.
  names(group, area) {
    const taken = this.marks.filter(({set}) => set.radius).map(({x, y}) => ({left: x - 3, top: y - 3, right: x + 3, bottom: y + 3}));
    for (const mark of this.marks.filter(({point}) => point.name)) {
      const {point: {name}, set} = mark, box = roomFor(widthOf(name), mark, Math.max(0, (set.radius ?? 0) - 5), area, taken);
      if (!box) continue;
      taken.push(box);
      const middle = (box.top + box.bottom) / 2;
      if (box.far) addSvg(group, "path", {d: `M${rounded(mark.x)},${rounded(mark.y)}L${rounded(box.left > mark.x ? box.left : box.right)},${rounded(middle)}`, stroke: "#888888", "stroke-width": ".6"});
      addSvg(group, "rect", {x: box.left - 1, y: box.top, width: box.right - box.left + 2, height: box.bottom - box.top, fill: "#ffffff", "fill-opacity": ".75"});
      addSvg(group, "text", {x: box.left, y: middle + 4, fill: set.nameColour ?? set.colour}, name);
    }
  }

  // Where a pointer is, as values {x, y} of the axes.
  values({clientX, clientY}) {
    const {left, top} = this.svg.getBoundingClientRect();
    return {x: this.x.inverse(clientX - left), y: this.y.inverse(clientY - top)};
  }

  // The point under the pointer, if any.
  nearest({clientX, clientY}) {
    const {left, top} = this.svg.getBoundingClientRect(), away = ({x, y}) => Math.hypot(x - clientX + left, y - clientY + top);
    return this.marks?.filter((mark) => away(mark) < 10).sort((a, b) => away(a) - away(b))[0];
  }

  tellNearest(event) {
    const mark = this.shown?.tell && this.nearest(event);
    this.tip.hidden = !mark;
    if (!mark) return;
    this.tip.textContent = this.shown.tell(mark.point).join("\n");
    this.tip.style.left = `${Math.max(0, Math.min(mark.x + 10, this.width - this.tip.offsetWidth))}px`;
    this.tip.style.top = `${mark.y > this.tip.offsetHeight + 10 ? mark.y - this.tip.offsetHeight - 8 : mark.y + 12}px`;
  }
}
