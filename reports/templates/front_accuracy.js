// Speed against accuracy of the solvers that the form chooses.
"use strict";

const {comparison} = site;
const rows = comparison ? comparison.entries : [];
// Rows of all families together are of no one formulation.
const full = (row) => row.budget === 0 ? row.solver : `${row.solver}, ${row.formulation}`;
const shows = (row) => row.formulation.includes(element("shown").value);
const chosenFamily = () => Number(element("family").value);
const chosenBudget = () => Number(element("budget").value);
const chosen = () => rows.filter((row) => row.family === chosenFamily() && row.budget === chosenBudget() && shows(row));

const familyName = ({name}) => name === "all" ? "all problems" : name;

// Where the report speaks of it: of a family on a page of its own.
const placeOf = (row) => {
  const {name} = comparison.families[row.family];
  return name === "all" ? `${comparison.folder}/index.html#speed-accuracy` : `${comparison.folder}/${name}/index.html`;
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
  return {x: row[speed], y: scaled(row[accuracy]), row, bar: {low: scaled(row[`${accuracy}_lower`]), high: scaled(row[`${accuracy}_upper`])}};
};

const accuracyWords = {evaluations: "evaluations for each variable", seconds: "processor time [s]", solved: "success rate [%]",
                       error: "error of the answer (median optimality gap)"};

const accuracyFinding = (front, speed) => {
  const best = front.at(-1);
  if (!best) return "No solver matches, or the comparison has no times: ./ricochet compare makes one with times.";
  return `${familyName(comparison.families[chosenFamily()])}: the most accurate is ${full(best.row)}, at ${number(best.x)} ${speed === "seconds" ? "s" : "evaluations for each variable"}; ` +
    (front.length > 1 ? `the fastest on the Pareto front is ${full(front[0].row)}, at ${number(front[0].x)}.` : "it is also the fastest.");
};

const drawAccuracy = () => {
  const speed = element("speed").value, accuracy = element("accuracy").value;
  const points = chosen().map((row) => pointOf(row, speed, accuracy))
    .filter((point) => point.x > 0 && point.y !== null && Number.isFinite(point.y));
  const front = frontOf(points.filter((point) => point.row.complete), accuracy === "solved" ? (a, b) => a > b : (a, b) => a < b);
  const finding = accuracyFinding(front, speed);
  element("finding").textContent = finding;
  const onFront = new Set(front), told = new Set(front.slice(-5));  // the best few; the paper's and random search are always named
  const kinds = [...new Set(Object.values(comparison.kinds))].sort();
  const kindOf = ({row}) => row.outside ? "yours" : comparison.kinds[row.solver] ?? "solvers";
  const colourOf = (kind) => kind === "yours" ? ink : kind === "solvers" ? quiet : colours[kinds.indexOf(kind) % colours.length];
  const shown = (point) => ({...point, colour: colourOf(kindOf(point)),
    name: told.has(point) || alwaysNamed.includes(point.row.solver) || point.row.outside ? full(point.row) + (point.row.solver === "fireworks" ? " (the paper's)" : "") : undefined});
  charts["accuracy-chart"].draw({
    title: `${accuracyWords[accuracy]} over ${accuracyWords[speed]}, ${points.length} dots. ${finding}`,
    x: {title: accuracyWords[speed], ...around(points.map(({x}) => x))},
    y: {title: accuracyWords[accuracy], ...(accuracy === "error" ? around(points.map(({y}) => y)) : shares)},
    sets: [{data: front.map(shown), colour: ink, line: "steps", radius: 5, bars: true},
           ...[...new Set(points.map(kindOf))].sort().map((kind) => ({data: points.filter((point) => !onFront.has(point) && kindOf(point) === kind).map(shown),
             colour: colourOf(kind), nameColour: ink, kind: kinds.length > 0 && kind, radius: 3.5}))],
    tell: ({row}) => [full(row), `${number(row.evaluations)} evaluations for each variable, ${number(row.seconds)} s`,
                      `solved ${percent(row.solved)} [${percent(row.solved_lower)}, ${percent(row.solved_upper)}]`, `median error ${number(row.error)}`],
    follow: ({row}) => { location.href = placeOf(row); },
  });
};
