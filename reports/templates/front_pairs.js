// Solver and simulation combined: what a threshold costs, and how exact it is.
"use strict";

const {pairs} = site;
const simulationNames = pairs ? [...new Set(pairs.simulations.map(({simulation}) => simulation))] : [];
const unpickedSimulations = new Set();
const resolution = 1e-10;  // [rad/s]: a logarithmic axis has no 0, and no threshold is known better

// The same colours as where the motion stands alone; its levels have shapes of their own.
const simulationLook = (name) => {
  const methods = site.motion ? site.motion.charts[0].series.map(({label}) => label) : [], place = methods.indexOf(name);
  if (pairs.simulations.find(({simulation}) => simulation === name).reference) return {colour: ink, shape: "diamond"};
  if (place >= 0) return {colour: colours[place % colours.length], shape: "circle"};
  const level = simulationNames.filter((other) => !methods.includes(other)).indexOf(name);
  return {colour: [colours[0], colours[5]][level % 2], shape: "triangle"};
};

// What a solver spends with a simulation until it has the threshold, and the error of that threshold.
const pairOf = (solver, simulation, alone) => {
  const spent = solver.own + solver.evaluations * simulation.seconds;
  const error = (own) => Math.min(alone ? Math.max(own, resolution) : own + pairs.tolerance, pairs.range);
  return {solver, simulation, x: spent / solver.solved, y: error(simulation.error),
          bar: {low: error(simulation.error_least), high: error(simulation.error), from: spent / solver.solved_upper, to: spent / solver.solved_lower}};
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
  const list = points.map(({solver, simulation, x, bar: {from, to}}) => ({
    solver: solver.solver, formulation: solver.formulation, simulation: simulation.simulation, control: simulation.control, evaluations: solver.evaluations,
    solver_seconds: solver.own, solved: solver.solved, simulation_seconds: simulation.seconds, seconds: x, seconds_lower: from,
    seconds_upper: to, simulation_error: simulation.error, simulation_error_least: simulation.error_least,
    error: simulation.error + pairs.tolerance}));
  offerFiles("pairs", list.length ? Object.keys(list[0]) : [], list);
};

const drawPairs = () => {
  const alone = element("pair-error").value === "simulation", wanted = element("pair-solver").value;
  const solvers = pairs.solvers.filter((solver) => !wanted || solver.solver === wanted);
  const simulations = pairs.simulations.filter((one) => !unpickedSimulations.has(one.simulation));
  const all = solvers.flatMap((solver) => simulations.map((simulation) => pairOf(solver, simulation, alone)));
  // The solver changes the time alone: of each simulation the pair with the fastest stands for all.
  const points = simulations.map((simulation) => all.filter((pair) => pair.simulation === simulation).reduce((a, b) => b.x < a.x ? b : a));
  const within = points.filter(({y}) => y < pairs.range);
  const front = frontOf(within.length ? within : points, (a, b) => a < b), onFront = new Set(front);
  const look = ({simulation}) => simulationLook(simulation.simulation);
  const finding = findingOfPairs(all.length, front);
  element("pairs-finding").textContent = finding;
  element("pairs-note").textContent = `A dot: a simulation with ${wanted ? "this solver" : "the solver that is fastest with it"}; the file has all ${all.length} pairs. Problems: ${pairs.family} (${pairs.cases.join(", ")}), with as many evaluations as in the comparison; failed runs are repeated. Error: the simulation's ` +
    `largest of the cases${alone ? "" : ` + ${pairs.tolerance} rad/s, the tolerance of a solved problem`}, at most ${number(pairs.range)} rad/s, the fastest threshold. Bars across: interval of the success rate. Bars down: to the smallest error of the cases.`;
  offerPairs(all);
  const {min, max} = around(points.map(({y}) => y));
  charts["pairs-chart"].draw({
    title: `Error of the threshold over processor time, ${points.length} dots. ${finding}`,
    x: {title: "processor time to the threshold [s]", ...around(points.map(({x}) => x))},
    y: {title: alone ? "simulation's error [rad/s]" : "error, at most [rad/s]", logarithmic: true, min: min / 1.5, max},
    sets: [{data: front.map((point) => ({...point, name: pairName(point), ...look(point)})), colour: ink, line: "steps", radius: 5, bars: true},
           ...simulationNames.map((name) => ({data: points.filter((point) => point.simulation.simulation === name && !onFront.has(point)),
                                              radius: 3.5, faint: true, ...simulationLook(name)}))],
    tell: ({solver, simulation, x, y}) => [pairName({solver, simulation}),
      `${timeText(x)}: ${number(solver.evaluations)} evaluations of ${number(1e6 * simulation.seconds, 2)} µs, ${timeText(solver.own)} of its own`,
      `solved ${percent(solver.solved)} [${percent(solver.solved_lower)}, ${percent(solver.solved_upper)}]`,
      `error at most ${errorText(y)} rad/s; the simulation's: ${simulation.reference ? "none, it is the reference" : `${errorText(simulation.error_least)} to ${errorText(simulation.error)}`}`],
    follow: () => { location.href = `${pairs.folder}/index.html#thresholds`; },
  });
};

if (pairs) {
  fill(element("pair-solver"), [["", "the fastest"], ...pairs.solvers.map(({solver}) => [solver, solver])]);
  for (const id of ["pair-solver", "pair-error"]) element(id).addEventListener("change", drawPairs);
  offerPicks(element("pair-picks"), simulationNames, unpickedSimulations, simulationLook, drawPairs);
  drawPairs();
}
