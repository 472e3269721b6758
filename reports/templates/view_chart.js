// Step curves over a logarithmic axis, as large as their place on the page, in the colours of the other charts.

const viewColours = ["#0072b2", "#d55e00", "#00a56a", "#7b2475", "#dd6ba0", "#6b4f00", "#606060"], viewDashes = ["", "8 3", "2 3"];
const lookOf = (i) => ({stroke: viewColours[i % viewColours.length], "stroke-dasharray": viewDashes[Math.floor(i / viewColours.length) % viewDashes.length]});

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
    const {title, x, from, to, series, rule, y, caption} = shown, height = 330, top = 34, bottom = height - 42, svg = this.svg;
    this.width = Math.max(280, this.svg.clientWidth);
    const area = {left: 44, top, right: this.width - 14, bottom};
    svg.replaceChildren();
    svg.setAttribute("viewBox", `0 0 ${this.width} ${height}`);
    svg.setAttribute("role", "img");
    const best = series.map(({name, steps}) => `${name} ${Math.round(100 * (steps.at(-1)?.[1] ?? 0))} %`).join(", ");
    addSvg(svg, "title", {id: `${this.figure.id}-title`}, `${title}. At the right end: ${best}.`);
    addSvg(svg, "text", {x: area.left, y: 16, class: "view-title"}, title);
    const axes = {x: {title: x, logarithmic: true, min: from, max: to}, y: {title: y, min: 0, max: 100}};
    const at = drawAxes(svg, area, {...axes, width: this.width, height});
    if (rule) addSvg(svg, "path", {d: `M${rounded(at.x(rule))},${top}V${bottom}`, stroke: "#222222", "stroke-dasharray": "5 3", fill: "none"});
    series.forEach(({name, look, steps}) => {
      let line = `M${area.left},${bottom}`;
      for (const [value, share] of steps) line += `H${rounded(at.x(value))}V${rounded(at.y(100 * share))}`;
      addSvg(addSvg(svg, "path", {d: `${line}H${area.right}`, fill: "none", "stroke-width": 1.7, ...lookOf(look)}), "title", {}, name);
    });
    this.numbers(series, x, y);
    this.legend(series, caption);
  }

  // For the button CSV: a row for every step.
  numbers(series, x, y) {
    const rows = series.flatMap(({name, steps}) => steps.map(([value, share]) => [name, value, 100 * share]));
    this.figure.querySelector("script.chart-csv").textContent = JSON.stringify(csvOf(["entry", x, y], rows));
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
