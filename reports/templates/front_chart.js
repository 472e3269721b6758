// A chart of points and lines over two axes, as an SVG as large as its place on the page. chart_data.js offers its
// numbers, its picture and a print of it.
"use strict";

// After Okabe and Ito, as in all reports; the looks make them paler in the dark.
const colours = ["#0072b2", "#d55e00", "#009e73", "#b0568a", "#7b3294", "#555555", "#2a7f9e", "#8a6d00"];
const ink = "#222222";

// Ends of a logarithmic axis, with room for the dots at them.
const around = (values) => ({logarithmic: true, min: Math.min(...values) / 1.3, max: Math.max(...values) * 1.3});
// Shares end at 0 and 100, with a little room for the dots there.
const shares = {min: -3, max: 104};

// A place for a name near its point: within the area, and on nothing that is there. Far ones need a line.
const roomFor = (width, {x, y}, area, taken) =>
  [[7, 0], [-width - 7, 0], [7, -12], [7, 12], [-width - 7, -12], [-width - 7, 12], [-width / 2, -14], [-width / 2, 14],
   [14, -26], [14, 26], [-width - 14, -26], [-width - 14, 26], [14, -42], [14, 42], [-width - 14, -42], [-width - 14, 42]]
    .map(([dx, dy]) => ({left: x + dx, top: y + dy - 7, right: x + dx + width, bottom: y + dy + 7, far: Math.abs(dy) > 20}))
    .find((b) => b.left >= area.left && b.right <= area.right && b.top >= area.top && b.bottom <= area.bottom &&
      !taken.some((t) => b.left < t.right && b.right > t.left && b.top < t.bottom && b.bottom > t.top));

const outlines = {
  circle: (x, y, r) => `M${x - r},${y}a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0z`,
  diamond: (x, y, r) => `M${x - r},${y}L${x},${y - r}L${x + r},${y}L${x},${y + r}z`,
  triangle: (x, y, r) => `M${x},${y - r}L${x + r},${y + .8 * r}H${x - r}z`,
};

class PointChart {
  constructor(id) {
    this.svg = element(id);
    this.title = this.svg.querySelector("title");
    this.tip = make("p", {className: "tip", hidden: true});
    this.svg.after(this.tip);
    this.svg.addEventListener("pointermove", (event) => this.tellNearest(event));
    this.svg.addEventListener("pointerleave", () => { this.tip.hidden = true; });
    this.svg.addEventListener("click", (event) => { const mark = this.nearest(event); if (mark) this.shown.follow?.(mark.point); });
    new ResizeObserver(() => {
      const {clientWidth, clientHeight} = this.svg;
      if (this.shown && clientWidth && (clientWidth !== this.width || clientHeight !== this.height)) this.draw(this.shown);
    }).observe(this.svg);
  }

  // `x`, `y`: {title, logarithmic, min, max}. `sets`: {data: [{x, y, name, short, colour, shape, bar}], colour, nameColour, shape, radius,
  // faint, kind, line, dash, bars}:
  // `line` is "steps" or "straight"; `bars` draws the interval `bar`: {low, high, from, to} of each point; a legend shows the sets that have a `kind`.
  // Without points there is no chart. `tell`: lines on a point, the first names it; `follow`: a click on it.
  draw(shown) {
    this.shown = shown;
    this.marks = [];
    this.svg.parentElement.hidden = shown.sets.every(({data}) => data.length === 0);
    if (this.svg.parentElement.hidden) return;
    this.width = this.svg.clientWidth || 560;
    this.height = this.svg.clientHeight || 250;
    const {height} = this;
    this.title.textContent = shown.title;
    this.svg.replaceChildren(this.title);
    for (const [key, value] of Object.entries({viewBox: `0 0 ${this.width} ${height}`, "font-family": font, "font-size": textSize})) this.svg.setAttribute(key, value);
    const group = addSvg(this.svg, "g", {});
    addSvg(group, "title", {}, "");  // the picture's title is no tooltip of its parts
    addSvg(group, "rect", {width: this.width, height, fill: "#ffffff"});
    const keys = document.createElementNS("http://www.w3.org/2000/svg", "g");
    const area = {left: 58, top: this.legend(keys), right: this.width - 12, bottom: height - 38};
    const buttons = 142;  // they stand beside the title
    Object.assign(this, drawAxes(group, area, {x: shown.x, y: shown.y, width: this.width, height, buttons}));
    group.append(keys);
    this.marks = shown.sets.flatMap((set) => set.data.map((point) => ({x: this.x(point.x), y: this.y(point.y), point, set})));
    for (const set of shown.sets) this.line(group, set);
    for (const mark of this.marks.filter(({set}) => set.bars)) this.bar(group, mark);
    for (const {x, y, point, set} of this.marks.filter((mark) => mark.set.radius)) {
      const colour = point.colour ?? set.colour;
      addSvg(group, "path", {d: outlines[point.shape ?? set.shape ?? "circle"](rounded(x), rounded(y), set.radius), fill: colour, stroke: set.colour, "fill-opacity": set.faint ? .6 : 1});
    }
    this.names(group, area);
    const rows = this.marks.map(({point}) => [shown.tell(point)[0], point.x, point.y, point.bar?.low, point.bar?.high]);
    this.svg.parentElement.querySelector(".chart-csv").textContent = JSON.stringify(csvOf(["name", shown.x.title, shown.y.title, "lower", "upper"], rows));
  }

  // Returns where the area begins.
  legend(group) {
    let x = 58, y = 10;
    const named = this.shown.sets.filter(({kind}) => kind);
    for (const {kind, colour} of named) {
      if (x > 58 && x + widthOf(kind) + 12 > this.width) [x, y] = [58, y + 15];
      addSvg(group, "path", {d: outlines.circle(x + 4, y, 4), fill: colour});
      addSvg(group, "text", {x: x + 12, y: y + 4, fill: "black"}, kind);
      x += widthOf(kind) + 24;
    }
    return named.length ? y + 16 : 8;
  }

  line(group, set) {
    if (!set.line || set.data.length < 2) return;
    const ends = this.marks.filter((mark) => mark.set === set).map(({x, y}) => [rounded(x), rounded(y)]);
    const d = "M" + ends.map(([x, y], i) => i === 0 ? `${x},${y}` : set.line === "steps" ? `H${x}V${y}` : `L${x},${y}`).join("");
    addSvg(group, "path", {d, stroke: set.colour, fill: "none", "stroke-width": 1.5, ...(set.dash ? {"stroke-dasharray": set.dash} : {})});
  }

  bar(group, {x, y, point: {bar}}) {
    if (bar.low === null || bar.high === null) return;
    let d = `M${rounded(x)},${rounded(this.y(bar.low))}V${rounded(this.y(bar.high))}`;
    if (bar.from) d += `M${rounded(this.x(bar.from))},${rounded(y)}H${rounded(this.x(bar.to))}`;
    addSvg(group, "path", {d, stroke: "#888888"});
  }

  // Names beside points where there is room; where the name has none, the short one may have.
  names(group, area) {
    const taken = this.marks.filter(({set}) => set.radius).map(({x, y}) => ({left: x - 3, top: y - 3, right: x + 3, bottom: y + 3}));
    for (const mark of this.marks) {
      const {point, set} = mark;
      const [text, box] = [point.name, point.short].filter(Boolean).map((name) => [name, roomFor(widthOf(name), mark, area, taken)]).find(([, found]) => found) ?? [];
      if (!box) continue;
      taken.push(box);
      const middle = (box.top + box.bottom) / 2;
      if (box.far) addSvg(group, "path", {d: `M${rounded(mark.x)},${rounded(mark.y)}L${rounded(box.left > mark.x ? box.left : box.right)},${rounded(middle)}`, stroke: "#888888", "stroke-width": .6});
      addSvg(group, "rect", {x: box.left - 1, y: box.top, width: box.right - box.left + 2, height: box.bottom - box.top, fill: "#ffffff", "fill-opacity": .75});
      addSvg(group, "text", {x: box.left, y: middle + 4, fill: set.nameColour ?? set.colour}, text);
    }
  }

  // The point under the pointer, if any.
  nearest({clientX, clientY}) {
    const {left, top} = this.svg.getBoundingClientRect(), away = ({x, y}) => Math.hypot(x - clientX + left, y - clientY + top);
    return this.marks.filter((mark) => away(mark) < 10).sort((a, b) => away(a) - away(b))[0];
  }

  tellNearest(event) {
    const mark = this.nearest(event);
    this.tip.hidden = !mark;
    this.svg.style.cursor = mark && this.shown.follow ? "pointer" : "";
    if (!mark) return;
    this.tip.textContent = this.shown.tell(mark.point).join("\n");
    this.tip.style.left = `${Math.max(0, Math.min(mark.x + 10, this.width - this.tip.offsetWidth))}px`;
    this.tip.style.top = `${mark.y > this.tip.offsetHeight + 10 ? mark.y - this.tip.offsetHeight - 8 : mark.y + 12}px`;
  }
}

const charts = Object.fromEntries([...document.querySelectorAll(".drawing > svg")].map(({id}) => [id, new PointChart(id)]));
