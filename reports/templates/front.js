// The charts and the leaderboard of the front page. Its data stand in the page; Chart.js draws.
// Without this script the page shows the same rows in pictures that stand still.
"use strict";

// A list of objects of the same names may stand as a table, {columns, rows}.
const unpacked = (data) => {
  if (Array.isArray(data)) return data.map(unpacked);
  if (data === null || typeof data !== "object") return data;
  if (data.columns && data.rows && Object.keys(data).length === 2) {
    return data.rows.map((row) => Object.fromEntries(data.columns.map((name, i) => [name, unpacked(row[i])])));
  }
  return Object.fromEntries(Object.entries(data).map(([name, value]) => [name, unpacked(value)]));
};

const site = unpacked(JSON.parse(document.getElementById("site-data").textContent));
const element = (id) => document.getElementById(id);
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const dark = matchMedia("(prefers-color-scheme: dark)");

// After Okabe and Ito, as in all reports; paler in the dark.
const palette = () => dark.matches
  ? ["#4ba3dd", "#f08a3c", "#2fc298", "#e08fbd", "#c78fe0", "#aab2ba", "#74d0f0", "#d9c14a"]
  : ["#0072b2", "#d55e00", "#009e73", "#b0568a", "#7b3294", "#555555", "#2a7f9e", "#8a6d00"];

const number = (value, digits = 3) =>
  value === null ? "–" : Number(value.toPrecision(digits)).toLocaleString("en", {maximumSignificantDigits: digits});
const percent = (share) => share === null ? "–" : `${Math.round(100 * share)} %`;

// ---- charts ----

// A place for a name near its point: within the area, and on nothing that is there. Far ones need a line.
const roomFor = (width, at, area, taken) => {
  const height = 14;
  return [[7, 0], [-width - 7, 0], [7, -12], [7, 12], [-width - 7, -12], [-width - 7, 12], [-width / 2, -14], [-width / 2, 14],
          [14, -26], [14, 26], [-width - 14, -26], [-width - 14, 26], [14, -42], [14, 42], [-width - 14, -42], [-width - 14, 42]]
    .map(([dx, dy]) => ({left: at.x + dx, top: at.y + dy - height / 2, right: at.x + dx + width, bottom: at.y + dy + height / 2, far: Math.abs(dy) > 20}))
    .find((b) => b.left >= area.left && b.right <= area.right && b.top >= area.top && b.bottom <= area.bottom &&
      !taken.some((t) => b.left < t.right && b.right > t.left && b.top < t.bottom && b.bottom > t.top));
};

// Intervals around points, and names beside them where there is room.
const namesAndIntervals = {
  id: "namesAndIntervals",
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x, y}} = chart;
    ctx.save();
    ctx.font = `12px ${Chart.defaults.font.family}`;
    ctx.textBaseline = "middle";
    const taken = chart.data.datasets.filter((set, index) => set.pointRadius > 0 && !set.crowd && chart.isDatasetVisible(index))
      .flatMap((set) => set.data.map((point) => [x.getPixelForValue(point.x), y.getPixelForValue(point.y)]))
      .map(([left, top]) => ({left: left - 3, top: top - 3, right: left + 3, bottom: top + 3}));
    chart.data.datasets.forEach((set, index) => {
      if (!chart.isDatasetVisible(index)) return;
      const colours = set.intervalColour || set.borderColor;
      for (const point of set.data) {
        if (point.low === undefined || point.low === null || point.high === null) continue;
        ctx.strokeStyle = colours;
        ctx.beginPath();
        ctx.moveTo(x.getPixelForValue(point.x), y.getPixelForValue(Math.max(point.low, y.min)));
        ctx.lineTo(x.getPixelForValue(point.x), y.getPixelForValue(Math.min(point.high, y.max)));
        if (point.from !== undefined) {
          ctx.moveTo(x.getPixelForValue(Math.max(point.from, x.min)), y.getPixelForValue(point.y));
          ctx.lineTo(x.getPixelForValue(Math.min(point.to, x.max)), y.getPixelForValue(point.y));
        }
        ctx.stroke();
      }
    });
    chart.data.datasets.forEach((set, index) => {
      if (!chart.isDatasetVisible(index)) return;
      for (const point of set.data) {
        const at = {x: x.getPixelForValue(point.x), y: y.getPixelForValue(point.y)};
        // Where the name has no room, the short one may.
        const [text, box] = [point.name, point.short].filter(Boolean)
          .map((name) => [name, roomFor(ctx.measureText(name).width, at, area, taken)]).find(([, found]) => found) ?? [];
        if (!box) continue;
        taken.push(box);
        if (box.far) {  // a line leads from the dot to the name
          ctx.strokeStyle = colour("--quiet");
          ctx.lineWidth = 0.6;
          ctx.beginPath();
          ctx.moveTo(at.x, at.y);
          ctx.lineTo(box.left > at.x ? box.left : box.right, (box.top + box.bottom) / 2);
          ctx.stroke();
          ctx.lineWidth = 1;
        }
        ctx.fillStyle = colour("--paper");
        ctx.globalAlpha = 0.75;
        ctx.fillRect(box.left - 1, box.top, box.right - box.left + 2, box.bottom - box.top);
        ctx.globalAlpha = 1;
        ctx.fillStyle = set.nameColour || set.borderColor;
        ctx.fillText(text, box.left, (box.top + box.bottom) / 2);
      }
    });
    ctx.restore();
  },
};

// Labels of a logarithmic axis: the powers of ten, and more of each the fewer there are.
// The ends of the axis are no ticks of their own: rounded, they would look like their neighbours.
const tidyTicks = (scale) => {
  const decades = Math.log10(scale.max / scale.min), every = Math.ceil(decades / 8);
  const kept = decades > 2.5 ? [1] : decades > 0.9 ? [1, 2, 5] :
    decades > 0.4 ? [1, 2, 3, 5, 7] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
  scale.ticks = scale.ticks.filter(({value}) => {
    const exponent = Math.floor(Math.log10(value) + 1e-9), digit = value / 10 ** exponent;
    return kept.some((one) => Math.abs(digit - one) < 1e-6) && (kept.length > 1 || exponent % every === 0);
  });
};
const tickLabel = (value) => value >= 1e-3 && value < 1e6 ? String(Number(value.toPrecision(2))) : value.toExponential().replace("e+", "e");

const axis = (title, logarithmic, more = {}) => ({
  type: logarithmic ? "logarithmic" : "linear",
  title: {display: true, text: title, color: colour("--ink")},
  grid: {color: colour("--rule"), borderColor: colour("--quiet")},
  ticks: {color: colour("--quiet"), maxRotation: 0, ...(logarithmic ? {callback: tickLabel} : {})},
  ...(logarithmic ? {afterBuildTicks: tidyTicks} : {}),
  ...more,
});

// Shares end at 0 and 100, with a little room for the dots there.
const shareAxis = {min: -3, max: 104, afterBuildTicks: (scale) => { scale.ticks = [0, 20, 40, 60, 80, 100].map((value) => ({value})); }};

// The ends of a logarithmic axis, with room for the dots at them.
const around = (values) => values.length ? {min: Math.min(...values) / 1.3, max: Math.max(...values) * 1.3} : {};

const charts = {};

// Redraws a chart; `click` gets the point under the pointer. A legend shows the datasets that have a `kind`.
const draw = (id, datasets, x, y, describe, click) => {
  charts[id]?.destroy();
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.font.size = 12;
  charts[id] = new Chart(element(id), {
    type: "scatter",
    data: {datasets},
    options: {
      animation: false, maintainAspectRatio: false, parsing: false, normalized: true,
      interaction: {mode: "nearest", intersect: true},
      scales: {x, y},
      plugins: {
        legend: {display: datasets.some((set) => set.kind), position: "top", align: "start", onClick: () => {},
                 labels: {color: colour("--ink"), boxWidth: 8, boxHeight: 8, usePointStyle: true, filter: ({datasetIndex}) => datasets[datasetIndex].kind}},
        tooltip: {callbacks: {label: (item) => describe(item.raw, item.dataset)}, displayColors: false},
      },
      onClick: (event, hits, chart) => {
        if (click && hits.length) click(chart.data.datasets[hits[0].datasetIndex].data[hits[0].index]);
      },
    },
    plugins: [namesAndIntervals],
  });
  offerChart(id, x, y, describe);
};

// Buttons in a corner of the chart: its dots as a CSV file, and the picture as a PNG file.
const offerChart = (id, x, y, describe) => {
  const canvas = element(id), buttons = document.createElement("p");
  const quoted = (value) => /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  const csv = () => {
    const lines = charts[id].data.datasets.flatMap((set) => set.data.map((point) =>
      [String([describe(point, set)].flat()[0]), String(point.x), String(point.y)].map(quoted).join(",")));
    return "data:text/csv;charset=utf-8," + encodeURIComponent([["name", x.title.text, y.title.text].map(quoted).join(","), ...lines].join("\n") + "\n");
  };
  buttons.className = "chart-data";
  for (const [label, address] of [["CSV", csv], ["PNG", () => canvas.toDataURL("image/png")]]) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.setAttribute("aria-label", `${label} of this chart: ${y.title.text} over ${x.title.text}`);
    button.addEventListener("click", () => {
      const link = document.createElement("a");
      link.href = address();
      link.download = `${id}.${label.toLowerCase()}`;
      link.click();
    });
    buttons.append(button);
  }
  canvas.parentElement.querySelector(".chart-data")?.remove();
  canvas.after(buttons);
};

const fill = (select, entries) => {
  const before = select.value;
  select.replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
  if (entries.some(([value]) => String(value) === before)) select.value = before;
};

// ---- which solver? ----

const cell = (kind, text, alignment) => {
  const made = document.createElement(kind);
  made.textContent = text;
  made.className = alignment;
  return made;
};

const chooser = site.chooser;
const extentText = ({least, most}) => least === most ? String(most) : `${least} to ${most}`;
const solvedText = ({solved, lower, upper}) =>
  `${Math.round(100 * solved)}${lower === null ? "" : ` [${Math.round(100 * lower)}, ${Math.round(100 * upper)}]`}`;

// How far a number lies outside of an extent, as a ratio's logarithm; 0 inside.
const outsideBy = (value, {least, most}) => value < least ? Math.log(least / value) : value > most ? Math.log(value / most) : 0;

// The situations that match the choice: those with the nearest numbers of variables and, of a family,
// the nearest budget.
const matching = (choice) => {
  const kinds = chooser.situations.filter((one) => one.perturbation === choice.trouble &&
    (choice.constraints === "none" ? one.constraints.least === 0 : one.constraints.most > 0) &&
    (!choice.objective || (choice.objective === "count") === one.counts) &&
    one.entries.some((entry) => choice.gradient || !entry.gradient));
  const nearest = Math.min(...kinds.map((one) => outsideBy(choice.variables, one.variables)));
  const near = kinds.filter((one) => outsideBy(choice.variables, one.variables) === nearest);
  const each = choice.evaluations / choice.variables;
  const off = (one) => Math.abs(Math.log(one.budget / each));
  return near.filter((one) => near.every((other) => other.family !== one.family || off(other) >= off(one)));
};

const choiceSentence = (choice, found) => {
  const own = `${choice.variables} variable${choice.variables === 1 ? "" : "s"}, ${choice.evaluations} evaluations (${number(choice.evaluations / choice.variables)} a variable)`;
  if (!found.length) return `${own}: no such problem was run.`;
  const [one] = found, entry = one.entries.find((e) => choice.gradient || !e.gradient);
  const near = outsideBy(choice.variables, one.variables) > 0 ? ` The nearest that were run have ${extentText(one.variables)} variables.` : "";
  const easy = one.random ? ` Random search needs only ${number(one.random, 2)} evaluations there.` : "";
  const others = found.length > 1 ? `; ${found.length - 1} other kind${found.length > 2 ? "s" : ""} of problems below` : "";
  return `${own}: ${entry.solver}, formulation ${entry.formulation}, solved ${solvedText(entry)} % on ${one.problems} problem${one.problems === 1 ? "" : "s"} (${one.title || one.family})${others}.${near}${easy}`;
};

const drawChoice = () => {
  const value = (name) => element(`choose-${name}`).value;
  const choice = {variables: Math.max(1, Number(value("variables")) || 1), evaluations: Math.max(1, Number(value("evaluations")) || 1),
                  gradient: value("gradient") === "yes", constraints: value("constraints"), objective: value("objective"), trouble: value("trouble")};
  const found = matching(choice);
  element("choice").textContent = choiceSentence(choice, found);
  const head = document.createElement("tr"), body = document.createElement("tbody"), top = document.createElement("thead");
  for (const [title, side] of [["kind of problem", "left"], ["best entries", "left"], ["solved [%]", "right"], ["P(best)", "right"], ["problems", "right"], ["variables", "right"], ["evaluations a variable", "right"]]) {
    const heading = cell("th", title, side);
    heading.scope = "col";
    head.append(heading);
  }
  for (const one of found) {
    for (const [i, entry] of one.entries.filter((e) => choice.gradient || !e.gradient).slice(0, 3).entries()) {
      const line = document.createElement("tr"), name = cell("th", `${entry.solver}, ${entry.formulation}`, "left"), kind = cell("td", "", "left");
      name.scope = "row";
      if (i === 0) {
        const link = document.createElement("a");
        link.href = `${one.folder}/index.html`;
        link.textContent = one.title ? `${one.title} (${one.family})` : one.family;
        kind.append(link);
      }
      const runs = one.runs === null ? "" : `, ${one.runs} runs`;
      line.append(kind, name, cell("td", solvedText(entry), "right"), cell("td", entry.best === null ? "–" : entry.best.toFixed(2), "right"),
                  cell("td", `${entry.problems ?? one.problems} of ${one.problems}${runs}`, "right"), cell("td", extentText(one.variables), "right"), cell("td", String(one.budget), "right"));
      body.append(line);
    }
  }
  top.append(head);
  element("choices").replaceChildren(top, body);
};

// What the address asks for: ?variables=4&evaluations=400&trouble=noisy
const readChoice = () => {
  for (const [name, value] of new URLSearchParams(location.search)) {
    const field = element(`choose-${name}`);
    if (field) field.value = value;
  }
};

// ---- the comparison ----

const comparison = site.comparison;
const rows = comparison ? comparison.entries : [];
// Rows of all families together are of no one formulation.
const full = (row) => row.budget === 0 ? row.solver : `${row.solver}, ${row.formulation}`;
const shows = (row) => {
  const wanted = element("shown").value;
  return !wanted || row.formulation.includes(wanted);
};

const fitting = () => comparison.families.map((family, index) => [family, index]).filter(([family]) => {
  const variables = element("by-variables").value, constraints = element("by-constraints").value;
  return (!variables || (variables === "one") === (family.variables.most === 1)) &&
    (!constraints || (constraints === "none") === (family.constraints.most === 0));
});

// Where the report speaks of it: of a family on a page of its own.
const placeOf = (row) => {
  const {name} = comparison.families[row.family];
  return name === "all" ? `${comparison.folder}/index.html#speed-accuracy` : `${comparison.folder}/${name}/index.html`;
};

const chosen = () => {
  const family = Number(element("family").value), budget = Number(element("budget").value);
  return rows.filter((row) => row.family === family && row.budget === budget && shows(row));
};

// Solvers that are named wherever they lie.
const alwaysNamed = ["fireworks", "random-search"];

// The Pareto front.
const frontOf = (points, better) => {
  const front = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || (better(a.y, b.y) ? -1 : 1))) {
    if (!front.length || better(point.y, front.at(-1).y)) front.push(point);
  }
  return front;
};

const pointOf = (row, speed, accuracy) => {
  const scale = accuracy === "solved" ? 100 : 1;
  const least = accuracy === "solved" ? -Infinity : 1e-12;  // a logarithmic axis has no 0
  const scaled = (value) => value === null ? null : Math.max(scale * value, least);
  return {x: row[speed], y: scaled(row[accuracy]), low: scaled(row[`${accuracy}_lower`]),
          high: scaled(row[`${accuracy}_upper`]), row};
};

const drawAccuracy = () => {
  const speed = element("speed").value, accuracy = element("accuracy").value;
  const points = chosen().map((row) => pointOf(row, speed, accuracy))
    .filter((point) => point.x > 0 && point.y !== null && Number.isFinite(point.y));
  const better = accuracy === "solved" ? (a, b) => a > b : (a, b) => a < b;
  const front = frontOf(points.filter((point) => point.row.complete), better);
  const onFront = new Set(front);
  const named = (point) => ({...point, name: full(point.row) + (point.row.solver === "fireworks" ? " (the paper's)" : "")});
  const told = new Set(front.slice(-5));  // the best few; the paper's and random search are always named
  const nameOf = (point) => told.has(point) || alwaysNamed.includes(point.row.solver) || point.row.outside ? named(point) : point;
  const bare = (point) => told.has(point) ? point : {...point, low: null};
  const colours = palette(), kinds = [...new Set(Object.values(comparison.kinds))].sort(), ink = colour("--ink");
  const kindOf = (point) => point.row.outside ? "yours" : comparison.kinds[point.row.solver] ?? "solvers";
  const colourOf = (kind) => kind === "yours" ? ink : kind === "solvers" ? colour("--quiet") : colours[kinds.indexOf(kind) % colours.length];
  const dot = {showLine: false, pointRadius: 4, pointHoverRadius: 7, pointHitRadius: 6};
  const byKind = [...new Set(points.map(kindOf))].sort();
  const words = {evaluations: "evaluations for each variable", seconds: "processor time [s]", solved: "success rate [%]",
                 error: "error of the answer (median optimality gap)"};
  element("accuracy-chart").parentElement.hidden = points.length === 0;
  draw("accuracy-chart", [
    {...dot, label: "front", data: front.map(nameOf), borderColor: ink, backgroundColor: ink, nameColour: ink, showLine: true,
     stepped: "before", borderWidth: 1, pointRadius: 5, pointBackgroundColor: front.map((point) => colourOf(kindOf(point))), intervalColour: colour("--quiet")},
    ...byKind.map((kind) => ({...dot, label: kind, kind: kinds.length > 0, data: points.filter((point) => !onFront.has(point) && kindOf(point) === kind).map((point) => nameOf(bare(point))),
                              borderColor: colourOf(kind), backgroundColor: colourOf(kind), nameColour: ink, pointRadius: 3.5})),
  ], axis(words[speed], true, around(points.map(({x}) => x))),
  axis(words[accuracy], accuracy === "error", accuracy === "error" ? around(points.map(({y}) => y)) : shareAxis),
  (point) => [full(point.row), `${number(point.row.evaluations)} evaluations for each variable, ${number(point.row.seconds)} s`,
              `solved ${percent(point.row.solved)} [${percent(point.row.solved_lower)}, ${percent(point.row.solved_upper)}]`,
              `median error ${number(point.row.error)}`],
  (point) => { location.href = placeOf(point.row); });
  const best = front.at(-1);
  const family = comparison.families[Number(element("family").value)]?.name;
  element("finding").textContent = best
    ? `${family}: the most accurate is ${full(best.row)}, at ${number(best.x)} ${speed === "seconds" ? "s" : "evaluations for each variable"}; ` +
      (front.length > 1 ? `the fastest on the Pareto front is ${full(front[0].row)}, at ${number(front[0].x)}.` : "it is also the fastest.")
    : "No solver matches, or the comparison has no times: ./ricochet compare makes one with times.";
  element("accuracy-chart").setAttribute("aria-label",
    `${words[accuracy]} over ${words[speed]}, ${points.length} dots. ${element("finding").textContent}`);
};

// ---- the leaderboard ----

const boardColumns = [
  ["place", "place", (row) => row.shown_place, "right"],
  ["solver", "solver, formulation", (row) => full(row), "left"],
  ["best", "P(best), problems", (row) => `${row.best === null ? "–" : row.best.toFixed(2)}, ${comparison.families[row.family].problems}`, "right"],
  ["targets", "targets [%]", (row) => row.targets === null ? "–" : `${Math.round(100 * row.targets)} [${Math.round(100 * row.lower)}, ${Math.round(100 * row.upper)}]`, "right"],
  ["returned", "solved [%]", (row) => row.returned === null ? "–" : String(Math.round(100 * row.returned)), "right"],
  ["evaluations", "evaluations", (row) => number(row.evaluations), "right"],
  ["seconds", "ms", (row) => row.seconds === null ? "–" : number(1000 * row.seconds, 2), "right"],
];
const sorting = {by: "place", down: false};

// The same rank and chance: the same place. Entries without a rank have none.
const withPlaces = (list) => {
  let first = null;
  return list.map((row) => {
    if (!first || first.rank !== row.rank || first.best !== row.best) first = row;
    return {...row, shown_place: row.rank === null ? "–" : String(first.place)};
  });
};

const sorted = (list) => [...list].sort((a, b) => {
  const [one, two] = sorting.by === "solver" ? [full(a), full(b)] : [a[sorting.by], b[sorting.by]];
  if (one === two) return a.place - b.place;
  if (one === null || two === null) return one === null ? 1 : -1;
  return (one < two ? -1 : 1) * (sorting.down ? -1 : 1);
});

const drawBoard = () => {
  const list = sorted(withPlaces(chosen()));
  const head = document.createElement("tr");
  for (const [key, title, , alignment] of boardColumns) {
    const heading = cell("th", "", alignment), button = document.createElement("button");
    heading.scope = "col";
    button.type = "button";
    button.textContent = title;
    button.dataset.column = key;
    button.addEventListener("click", () => {
      sorting.down = sorting.by === key ? !sorting.down : !["place", "solver", "evaluations", "seconds"].includes(key);
      sorting.by = key;
      drawBoard();
      document.querySelector(`#board button[data-column="${key}"]`).focus();
    });
    if (sorting.by === key) heading.setAttribute("aria-sort", sorting.down ? "descending" : "ascending");
    heading.append(button);
    head.append(heading);
  }
  const body = document.createElement("tbody");
  list.forEach((row, i) => {
    const line = document.createElement("tr");
    if (sorting.by === "place" && list[i + 1]?.shown_place === row.shown_place) line.className = "tie";
    for (const [key, , text, alignment] of boardColumns) {
      const made = cell(key === "solver" ? "th" : "td", text(row), alignment);
      if (key === "solver") made.scope = "row";
      line.append(made);
    }
    body.append(line);
  });
  const top = document.createElement("thead");
  top.append(head);
  element("board").replaceChildren(top, body);
  offer(list);
};

// A list of rows as files that two links offer.
const offerFiles = (what, names, list) => {
  const quoted = (value) => /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  const lines = [names.join(",")].concat(list.map((row) => names.map((name) => quoted(String(row[name] ?? ""))).join(",")));
  element(`${what}-csv`).href = "data:text/csv;charset=utf-8," + encodeURIComponent(lines.join("\n") + "\n");
  element(`${what}-json`).href = "data:application/json;charset=utf-8," + encodeURIComponent(JSON.stringify(list, null, 1));
};

// The rows that are shown, with all their columns.
const offer = (list) => {
  const names = Object.keys(rows[0]).filter((name) => name !== "family");
  const family = comparison.families[Number(element("family").value)]?.name;
  offerFiles("board", ["family", ...names], list.map((row) => ({family, ...Object.fromEntries(names.map((name) => [name, row[name]]))})));
};

// ---- targets reached ----

const unpicked = new Set();

// All problems together have no curves: those of the first family stand in their place.
const curvesFor = (family, budget) => {
  const own = comparison.curves.filter((curve) => curve.family === family && curve.budget === budget);
  if (own.length || budget || !comparison.curves.length) return own;
  const first = comparison.curves[0].family;
  const largest = Math.max(...comparison.curves.filter((curve) => curve.family === first).map((curve) => curve.budget));
  return curvesFor(first, largest);
};

const drawCurves = () => {
  const family = Number(element("family").value), budget = Number(element("budget").value);
  const curves = curvesFor(family, budget).filter(shows);
  element("curves-of").textContent = curves.length
    ? `Of ${comparison.families[curves[0].family].name}, with ${curves[0].budget} evaluations for each variable.` : "";
  const colours = palette();
  const curveColour = (curve, i) => curve.solver === "fireworks" ? colour("--ink") : colours[i % colours.length];
  element("curve-picks").replaceChildren(...curves.map((curve, i) => {
    const item = document.createElement("li"), label = document.createElement("label");
    const box = document.createElement("input"), swatch = document.createElement("span");
    box.type = "checkbox";
    box.checked = !unpicked.has(full(curve));
    box.addEventListener("change", () => {
      unpicked[box.checked ? "delete" : "add"](full(curve));
      drawCurves();
      element("curve-picks").querySelectorAll("input")[i].focus();
    });
    swatch.className = "swatch";
    swatch.style.background = curveColour(curve, i);
    label.append(box, " ", swatch, full(curve));
    item.append(label);
    return item;
  }));
  element("no-curves").hidden = curves.length > 0;
  element("curve-chart").parentElement.hidden = curves.length === 0;
  const datasets = curves.map((curve, i) => {
    const data = curve.points.map(([x, share]) => ({x, y: 100 * share, curve}));
    if (data.length) data.at(-1).name = full(curve);
    const own = curveColour(curve, i);
    return {label: full(curve), data, hidden: unpicked.has(full(curve)), showLine: true, stepped: "before", borderColor: own,
            backgroundColor: own, borderWidth: 2, pointRadius: 0, pointHitRadius: 8, borderDash: i % 2 ? [6, 3] : []};
  });
  if (!element("reached").hidden) draw("curve-chart", datasets, axis("evaluations for each variable", true), axis("targets reached [%]", false, shareAxis),
    (point) => `${full(point.curve)}: ${Math.round(point.y)} % after ${number(point.x)}`);
  element("curve-chart").setAttribute("aria-label", `Share of targets reached over evaluations, of ${curves.length} solvers.`);
};

// The leaderboard or the targets reached.
const showBeside = (id) => {
  for (const [place, button] of [["leaderboard", "show-board"], ["reached", "show-reached"]]) {
    element(place).hidden = place !== id;
    element(button).setAttribute("aria-pressed", String(place === id));
  }
  drawCurves();
};

// ---- the motion ----

const drawMotion = () => {
  const view = site.motion.charts[Number(element("scene").value)];
  const logarithmic = view.y.scale === "logarithmic", colours = palette();
  const datasets = view.series.map((series, i) => {
    const own = series.pale ? colour("--ink") : colours[i % colours.length];
    const data = series.samples.map(({position, value, name}) => ({x: position, y: value, series, control: name}));
    Object.assign(data.at(-1), {name: [series.label, data.at(-1).control].filter(Boolean).join(" "), short: series.label});
    if (data.length > 1) data[0].name = data[0].control;
    return {label: series.label, data, showLine: data.length > 1, borderColor: own, backgroundColor: own, borderWidth: 1.5,
            pointRadius: series.pale ? 6 : 3, pointStyle: series.pale ? "rectRot" : "circle", pointHitRadius: 6};
  });
  // The reference lies on the lowest error that is drawn: it needs room below to be pointed at.
  const points = datasets.flatMap(({data}) => data), lowest = Math.min(...points.map(({y}) => y));
  draw("motion-chart", datasets, axis(view.x.label, true, around(points.map(({x}) => x))),
    axis(view.y.label, logarithmic, {min: logarithmic ? lowest / 10 : -5}),
    (point) => [[point.series.label, point.control].filter(Boolean).join(", tolerance or step "), `time ${number(point.x)}`,
                point.series.pale ? "exact: it is the reference" : `error ${number(point.y)}`],
    () => { location.href = `${site.motion.folder}/index.html#${view.name}`; });
  element("motion-chart").setAttribute("aria-label",
    `${view.title}: ${view.y.label} over ${view.x.label}, of ${view.series.map((series) => series.label).join(", ")}.`);
};

// ---- solver and simulation ----

const pairs = site.pairs;
const simulationNames = pairs ? [...new Set(pairs.simulations.map(({simulation}) => simulation))] : [];
const unpickedSimulations = new Set();
const resolution = 1e-10;  // [rad/s]: a logarithmic axis has no 0, and no threshold is known better

// The same colours as where the motion stands alone; its levels have shapes of their own.
const lookOf = (name) => {
  const colours = palette(), methods = site.motion ? site.motion.charts[0].series.map(({label}) => label) : [];
  const one = pairs.simulations.find(({simulation}) => simulation === name), place = methods.indexOf(name);
  if (one.reference) return {own: colour("--ink"), shape: "rectRot"};
  if (place >= 0) return {own: colours[place % colours.length], shape: "circle"};
  const level = simulationNames.filter((other) => !methods.includes(other)).indexOf(name);
  return {own: [colours[0], colour("--quiet")][level % 2], shape: "triangle"};
};

// What a solver spends with a simulation until it has the threshold, and the error of that threshold.
const pairOf = (solver, simulation, alone) => {
  const spent = solver.own + solver.evaluations * simulation.seconds;
  const error = (own) => Math.min(alone ? Math.max(own, resolution) : own + pairs.tolerance, pairs.range);
  return {solver, simulation, x: spent / solver.solved, from: spent / solver.solved_upper, to: spent / solver.solved_lower,
          y: error(simulation.error), low: error(simulation.error_least), high: error(simulation.error)};
};

const pairName = ({solver, simulation}) => `${solver.solver}, ${simulation.simulation}${simulation.control ? ` ${simulation.control}` : ""}`;
const timeText = (seconds) => seconds < 0.1 ? `${number(1000 * seconds, 2)} ms` : `${number(seconds, 2)} s`;

const errorText = (error) => error > 0 && error < 1e-4 ? error.toExponential(0) : number(error, 2);

const findingOfPairs = (count, front) => {
  const told = (point) => `${pairName(point)} (within ${errorText(point.y)} rad/s after ${timeText(point.x)})`;
  if (!front.length) return "No simulation is chosen.";
  if (front.length === 1) return `Of ${count} pairs ${told(front[0])} is the fastest and the most accurate.`;
  return `Of ${count} pairs the most accurate is ${told(front.at(-1))}; the fastest is ${told(front[0])}.`;
};

const offerPairs = (points) => {
  const list = points.map(({solver, simulation, x, from, to}) => ({
    solver: solver.solver, formulation: solver.formulation, simulation: simulation.simulation, control: simulation.control, evaluations: solver.evaluations,
    solver_seconds: solver.own, solved: solver.solved, simulation_seconds: simulation.seconds, seconds: x, seconds_lower: from,
    seconds_upper: to, simulation_error: simulation.error, simulation_error_least: simulation.error_least,
    error: simulation.error + pairs.tolerance}));
  offerFiles("pairs", list.length ? Object.keys(list[0]) : [], list);
};

const drawPairs = () => {
  const alone = element("pair-error").value === "simulation", wanted = element("pair-solver").value;
  const solvers = pairs.solvers.filter((solver) => !wanted || solver.solver === wanted);
  const all = solvers.flatMap((solver) =>
    pairs.simulations.filter((one) => !unpickedSimulations.has(one.simulation)).map((simulation) => pairOf(solver, simulation, alone)));
  // The solver changes the time alone: of each simulation the pair with the fastest stands for all.
  const points = [...new Set(all.map(({simulation}) => simulation))].map((simulation) =>
    all.filter((pair) => pair.simulation === simulation).reduce((a, b) => b.x < a.x ? b : a));
  const within = points.filter(({y}) => y < pairs.range);
  const front = frontOf(within.length ? within : points, (a, b) => a < b), onFront = new Set(front);
  const bare = ({solver, simulation, x, y}) => ({solver, simulation, x, y});
  const ink = colour("--ink");
  const dots = simulationNames.map((name) => {
    const {own, shape} = lookOf(name);
    return {label: name, data: points.filter((point) => point.simulation.simulation === name && !onFront.has(point)).map(bare), showLine: false,
            borderColor: own, backgroundColor: own + (own.length === 7 ? "99" : ""), pointStyle: shape, pointRadius: 3.5, pointHoverRadius: 6};
  });
  const leading = {label: "front", data: front.map((point) => ({...point, name: pairName(point)})), showLine: true, stepped: "before",
                   borderColor: ink, borderWidth: 1.5, nameColour: ink, pointRadius: 5, pointHoverRadius: 7,
                   pointBackgroundColor: front.map((point) => lookOf(point.simulation.simulation).own),
                   pointStyle: front.map((point) => lookOf(point.simulation.simulation).shape)};
  const {min, max} = around(points.map(({y}) => y));
  draw("pairs-chart", [leading, ...dots], axis("processor time to the threshold [s]", true, around(points.map(({x}) => x))),
    axis(alone ? "simulation's error [rad/s]" : "error, at most [rad/s]", true, {min: min / 1.5, max}),
    ({solver, simulation, x, y}) => [pairName({solver, simulation}),
      `${timeText(x)}: ${number(solver.evaluations)} evaluations of ${number(1e6 * simulation.seconds, 2)} µs, ${timeText(solver.own)} of its own`,
      `solved ${percent(solver.solved)} [${percent(solver.solved_lower)}, ${percent(solver.solved_upper)}]`,
      `error at most ${errorText(y)} rad/s; the simulation's: ${simulation.reference ? "none, it is the reference" : `${errorText(simulation.error_least)} to ${errorText(simulation.error)}`}`],
    () => { location.href = `${pairs.folder}/index.html#thresholds`; });
  element("pairs-finding").textContent = findingOfPairs(all.length, front);
  element("pairs-note").textContent = `A dot: a simulation with ${wanted ? "this solver" : "the solver that is fastest with it"}; the file has all ${all.length} pairs. Problems: ${pairs.family} (${pairs.cases.join(", ")}), with as many evaluations as in the comparison; failed runs are repeated. Error: the simulation's ` +
    `largest of the cases${alone ? "" : ` + ${pairs.tolerance} rad/s, the tolerance of a solved problem`}, at most ${number(pairs.range)} rad/s, the fastest threshold. Bars across: interval of the success rate. Bars down: to the smallest error of the cases.`;
  element("pairs-chart").setAttribute("aria-label", `Error of the threshold over processor time, ${points.length} dots. ${element("pairs-finding").textContent}`);
  offerPairs(all);
};

const offerSimulations = () => {
  element("pair-picks").replaceChildren(...simulationNames.map((name) => {
    const item = document.createElement("li"), label = document.createElement("label");
    const box = document.createElement("input"), swatch = document.createElement("span");
    box.type = "checkbox";
    box.checked = !unpickedSimulations.has(name);
    box.addEventListener("change", () => {
      unpickedSimulations[box.checked ? "delete" : "add"](name);
      drawPairs();
    });
    const {own, shape} = lookOf(name);
    swatch.className = `swatch ${shape}`;
    swatch.style.background = own;
    label.append(box, " ", swatch, name);
    item.append(label);
    return item;
  }));
};

// ---- all of it ----

const drawComparison = () => {
  drawAccuracy();
  drawBoard();
  drawCurves();
};

const offerBudgets = () => {
  const family = Number(element("family").value);
  const budgets = [...new Set(rows.filter((row) => row.family === family).map((row) => row.budget))].sort((a, b) => b - a);
  fill(element("budget"), budgets.map((budget) => [budget, budget === 0 ? "the largest" : String(budget)]));
  drawComparison();
};

const offerFamilies = () => {
  const words = ({least, most}) => least === most ? String(most) : `${least} to ${most}`;
  fill(element("family"), fitting().map(([family, index]) =>
    [index, `${family.name} (${words(family.variables)} variable${family.variables.most === 1 ? "" : "s"})`]));
  offerBudgets();
};

const start = () => {
  document.documentElement.classList.add("moves");
  if (chooser && chooser.situations.length) {
    readChoice();
    element("choose").addEventListener("input", drawChoice);
    element("choose").addEventListener("submit", (event) => event.preventDefault());
    drawChoice();
  }
  if (comparison) {
    for (const id of ["by-variables", "by-constraints"]) element(id).addEventListener("change", offerFamilies);
    element("family").addEventListener("change", offerBudgets);
    for (const id of ["budget", "shown"]) element(id).addEventListener("change", drawComparison);
    for (const id of ["speed", "accuracy"]) element(id).addEventListener("change", drawAccuracy);
    element("show-board").addEventListener("click", () => showBeside("leaderboard"));
    element("show-reached").addEventListener("click", () => showBeside("reached"));
    offerFamilies();
  }
  if (pairs) {
    fill(element("pair-solver"), [["", "the fastest"], ...pairs.solvers.map(({solver}) => [solver, solver])]);
    for (const id of ["pair-solver", "pair-error"]) element(id).addEventListener("change", drawPairs);
    offerSimulations();
    drawPairs();
  }
  if (site.motion) {
    fill(element("scene"), site.motion.charts.map((chart, index) => [index, chart.title]));
    element("scene").addEventListener("change", drawMotion);
    drawMotion();
  }
  dark.addEventListener("change", () => {
    if (comparison) drawComparison();
    if (site.motion) drawMotion();
    if (pairs) {
      offerSimulations();
      drawPairs();
    }
  });
};

start();
