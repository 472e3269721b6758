// Shares of targets reached over evaluations, beside the leaderboard.
"use strict";

const unpickedCurves = new Set();

// All problems together have no curves: those of the first family stand in their place.
const curvesFor = (family, budget) => {
  const own = comparison.curves.filter((curve) => curve.family === family && curve.budget === budget);
  if (own.length || budget || !comparison.curves.length) return own;
  const first = comparison.curves[0].family;
  const largest = Math.max(...comparison.curves.filter((curve) => curve.family === first).map((curve) => curve.budget));
  return curvesFor(first, largest);
};

const drawCurves = () => {
  const curves = curvesFor(chosenFamily(), chosenBudget()).filter(shows);
  element("curves-of").textContent = curves.length
    ? `Of ${comparison.families[curves[0].family].name}, with ${curves[0].budget} evaluations for each variable.` : "";
  const colourOf = (curve, i) => curve.solver === "fireworks" ? ink : colours[i % colours.length];
  offerPicks(element("curve-picks"), curves.map(full), unpickedCurves, (name, i) => ({colour: colourOf(curves[i], i), shape: "line"}), drawCurves);
  element("no-curves").hidden = curves.length > 0;
  const sets = curves.map((curve, i) => {
    const data = curve.points.map(([x, share]) => ({x, y: 100 * share, curve}));
    if (data.length) data.at(-1).name = full(curve);
    return {data, line: "steps", colour: colourOf(curve, i), dash: i % 2 ? "6 3" : ""};
  });
  const drawn = sets.filter((set, i) => !unpickedCurves.has(full(curves[i])));
  const ends = sets.flatMap(({data}) => data.map(({x}) => x));
  charts["curve-chart"].draw({
    title: `Share of targets reached over evaluations, of ${drawn.length} solvers.`,
    x: {title: "evaluations for each variable", logarithmic: true, min: Math.min(...ends), max: Math.max(...ends)},
    y: {title: "targets reached [%]", ...shares},
    sets: drawn,
    tell: ({curve, x, y}) => [full(curve), `${Math.round(y)} % after ${number(x)}`],
  });
};

// The leaderboard or the targets reached.
const showBeside = (id) => {
  for (const [place, button] of [["leaderboard", "show-board"], ["reached", "show-reached"]]) {
    element(place).hidden = place !== id;
    element(button).setAttribute("aria-pressed", String(place === id));
  }
};
