// What the charts that scripts draw share: parts of an SVG, scales, ticks, axes, and their numbers as a CSV file.
"use strict";

const textSize = 12, font = "system-ui, sans-serif", quiet = "#444444";
const ruler = document.createElement("canvas").getContext("2d");
ruler.font = `${textSize}px ${font}`;
const widthOf = (text) => ruler.measureText(text).width;
const rounded = (value) => Math.round(10 * value) / 10;

const addSvg = (parent, name, attributes, text) => {
  const part = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, typeof value === "number" ? rounded(value) : value);
  if (text !== undefined) part.textContent = text;
  parent.append(part);
  return part;
};

// Of an axis {logarithmic, min, max}: the powers of ten, and more of each the fewer there are; round numbers on a linear axis.
const ticksOf = ({logarithmic, min, max}) => {
  const ticks = [];
  if (logarithmic) {
    const decades = Math.log10(max / min), every = Math.ceil(decades / 8);
    const kept = decades > 2.5 ? [1] : decades > 0.9 ? [1, 2, 5] : decades > 0.4 ? [1, 2, 3, 5, 7] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
    for (let power = Math.floor(Math.log10(min)); power <= Math.log10(max); ++power) {
      if (kept.length > 1 || power % every === 0) ticks.push(...kept.map((digit) => digit * 10 ** power));
    }
  } else {
    const rough = (max - min) / 6, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].find((one) => one * power >= rough) * power;
    for (let place = Math.ceil(min / step); place * step <= max; ++place) ticks.push(place * step);
  }
  return ticks.filter((value) => value >= min && value <= max);
};
const tickLabel = (value) => value === 0 || (value >= 1e-3 && value < 1e6) ? String(Number(value.toPrecision(2))) : value.toExponential(0).replace("e+", "e");

// Where a value of an axis stands between two pixels; what lies outside stands at the end.
const scaleOf = ({logarithmic, min, max}, from, to) => {
  const part = logarithmic ? (value) => Math.log(value / min) / Math.log(max / min) : (value) => (value - min) / (max - min);
  return (value) => from + Math.min(1, Math.max(0, part(value))) * (to - from);
};

// Draws grid, labels, frame and titles of the axes `x`, `y`: {title, logarithmic, min, max}, around an area of pixels. `buttons`:
// pixels at the right that the title of x leaves free. Returns the scales {x, y}.
const drawAxes = (group, {left, top, right, bottom}, {x, y, width, height, buttons = 0}) => {
  const scales = {x: scaleOf(x, left, right), y: scaleOf(y, bottom, top)};
  const grid = addSvg(group, "path", {stroke: "#e4e4e4", fill: "none"}), middle = (top + bottom) / 2;
  let lines = "", free = 0;
  for (const tick of ticksOf(x)) {
    const at = scales.x(tick), label = tickLabel(tick), half = widthOf(label) / 2 + 3;
    if (at - half < free || at + half > width) continue;
    lines += `M${rounded(at)},${top}V${bottom}`;
    addSvg(group, "text", {x: at, y: bottom + 16, "text-anchor": "middle", fill: quiet}, label);
    free = at + half;
  }
  free = height;
  for (const tick of ticksOf(y)) {
    const at = scales.y(tick);
    if (at + textSize > free) continue;
    lines += `M${left},${rounded(at)}H${right}`;
    addSvg(group, "text", {x: left - 6, y: at + 4, "text-anchor": "end", fill: quiet}, tickLabel(tick));
    free = at;
  }
  grid.setAttribute("d", lines);
  addSvg(group, "path", {d: `M${left},${top}V${bottom}H${right}`, stroke: "#888888", fill: "none"});
  const centre = Math.min((left + right) / 2, width - buttons - widthOf(x.title) / 2);
  addSvg(group, "text", {x: centre, y: height - 6, "text-anchor": "middle", fill: "black"}, x.title);
  addSvg(group, "text", {x: 12, y: middle, "text-anchor": "middle", transform: `rotate(-90 12 ${rounded(middle)})`, fill: "black"}, y.title);
  return scales;
};

const csvOf = (names, rows) => {
  const quoted = (value) => /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  return [names, ...rows].map((row) => row.map((value) => quoted(String(value ?? ""))).join(",") + "\n").join("");
};
