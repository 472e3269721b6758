// Step curves over a logarithmic axis, as large as their place on the page, in the colours of the other charts.

const viewColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#555555"], viewDashes = ["", "8 3", "2 3"];
const lookOf = (i) => ({stroke: viewColours[i % viewColours.length], "stroke-dasharray": viewDashes[Math.floor(i / viewColours.length) % viewDashes.length]});

const addSvg = (parent, name, attributes, text) => {
  const part = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, value);
  if (text !== undefined) part.textContent = text;
  parent.append(part);
  return part;
};

const short = (x, digits = 3) => Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : "–";

class StepChart {
  constructor(figure) {
    this.figure = figure;
    this.svg = figure.querySelector("svg");
    this.caption = figure.querySelector("figcaption");
    new ResizeObserver(() => { if (this.shown && this.svg.clientWidth !== this.width) this.draw(this.shown); }).observe(figure);
  }

  // `series`: {name, look: a number, steps: [[x, share], ...]}. `rule`: a vertical line.
  draw(shown) {
    this.shown = shown;
    const {title, x, from, to, series, rule, y, caption} = shown, height = 330, left = 44, top = 34, bottom = height - 42;
    this.width = Math.max(280, this.svg.clientWidth);
    const right = this.width - 14, place = (value) => left + Math.log(value / from) / Math.log(to / from) * (right - left);
    const rise = (share) => bottom - share * (bottom - top), svg = this.svg;
    svg.replaceChildren();
    svg.setAttribute("viewBox", `0 0 ${this.width} ${height}`);
    svg.setAttribute("role", "img");
    const best = series.map(({name, steps}) => `${name} ${Math.round(100 * (steps.at(-1)?.[1] ?? 0))} %`).join(", ");
    addSvg(svg, "title", {id: `${this.figure.id}-title`}, `${title}. At the right end: ${best}.`);
    addSvg(svg, "text", {x: left, y: 16, class: "view-title"}, title);
    for (let share = 0; share <= 1; share += .25) {
      addSvg(svg, "path", {d: `M${left},${rise(share)}H${right}`, stroke: "#e4e4e4", fill: "none"});
      addSvg(svg, "text", {x: left - 6, y: rise(share) + 4, "text-anchor": "end"}, String(100 * share));
    }
    const ticks = [];
    for (let power = Math.floor(Math.log10(from)); power <= Math.log10(to); ++power) for (const step of [1, 2, 5]) ticks.push(step * 10 ** power);
    let free = 0;
    for (const tick of ticks.filter((value) => value >= from * .999 && value <= to * 1.001)) {
      addSvg(svg, "path", {d: `M${place(tick)},${top}V${bottom}`, stroke: "#e4e4e4", fill: "none"});
      if (place(tick) < free) continue;
      addSvg(svg, "text", {x: place(tick), y: bottom + 16, "text-anchor": "middle"}, short(tick));
      free = place(tick) + 38;
    }
    addSvg(svg, "text", {x: (left + right) / 2, y: height - 8, "text-anchor": "middle"}, x);
    addSvg(svg, "text", {x: 12, y: (top + bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 12 ${(top + bottom) / 2})`}, y);
    if (rule) addSvg(svg, "path", {d: `M${place(rule)},${top}V${bottom}`, stroke: "#222222", "stroke-dasharray": "5 3", fill: "none"});
    series.forEach(({name, look, steps}) => {
      let line = `M${left},${rise(0)}`;
      for (const [value, share] of steps) line += `H${place(Math.min(to, Math.max(from, value))).toFixed(1)}V${rise(share).toFixed(1)}`;
      addSvg(addSvg(svg, "path", {d: `${line}H${right}`, fill: "none", "stroke-width": 1.7, ...lookOf(look)}), "title", {}, name);
    });
    this.numbers(series, x, y);
    this.legend(series, caption);
  }

  // For the button CSV: a row for every step.
  numbers(series, x, y) {
    const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
    const rows = series.flatMap(({name, steps}) => steps.map(([value, share]) => [quoted(name), value, 100 * share].join()));
    this.figure.querySelector("script.chart-csv").textContent = JSON.stringify([["entry", quoted(x), quoted(y)].join(), ...rows, ""].join("\n"));
  }

  legend(series, caption) {
    const keys = document.createElement("ul");
    keys.className = "view-keys";
    series.forEach(({name, look}) => {
      const item = document.createElement("li"), mark = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      mark.setAttribute("aria-hidden", "true");  // its name stands beside it
      mark.setAttribute("role", "img");
      mark.setAttribute("viewBox", "0 0 28 10");
      addSvg(mark, "title", {}, `line of ${name}`);
      addSvg(mark, "path", {d: "M0,5H28", "stroke-width": 2.4, ...lookOf(look)});
      item.append(mark, name);
      keys.append(item);
    });
    this.caption.replaceChildren(caption, keys);
  }
}
