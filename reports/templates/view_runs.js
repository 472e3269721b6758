// The runs of a comparison, as src/analysis/comparison/view.h writes them, and what is computed of
// them: success rates, expected running times, ratios. Nothing here knows the page.

const base64Digits = new Map([..."ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"].map((digit, value) => [digit, value]));

// Reads a text of such digits from its beginning.
class DigitReader {
  constructor(text) { this.text = text; this.at = 0; }
  get ended() { return this.at >= this.text.length; }
  digit() { return base64Digits.get(this.text[this.at++]); }
  // A number >= 0, five bits a digit, the lowest first.
  number() {
    let number = 0;
    for (let scale = 1; ; scale *= 32) {
      const digit = this.digit();
      number += digit % 32 * scale;
      if (digit < 32) return number;
    }
  }
}

// Reads numbers of so many bits, the lowest first, from the six of each digit.
class BitReader {
  constructor(text) { this.digits = new DigitReader(text); this.left = 0; this.held = 0; }
  number(bits) {
    for (; this.left < bits; this.left += 6) this.held += this.digits.digit() * 2 ** this.left;
    const number = this.held % 2 ** bits;
    this.held = (this.held - number) / 2 ** bits;
    this.left -= bits;
    return number;
  }
}

// The rows of a table as records.
const records = ({columns, rows}) => rows.map((row) => Object.fromEntries(row.map((value, i) => [columns[i].name, value])));
const numbersIn = (text) => text === "" ? [] : text.split(" ").map(Number);

const short = (x, digits = 3) => Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : "–";

const levels = ["a third of the targets", "two thirds of the targets", "the problem solved"];
const targetsAt = (level, targets) => Math.ceil(targets * (level + 1) / levels.length);

const conditionOf = ({family, perturbation, price, budget}) => [family, perturbation, price, budget].join();

class RunTable {
  constructor({families, problems, solvers, formulations, perturbations, prices, entries, orders, first_instance, command}) {
    const namesIn = (list) => records(list).map(({name}) => name);
    Object.assign(this, {
      families: records(families).map((family) => ({...family, problems: numbersIn(family.problems), silent: numbersIn(family.silent)})),
      problems: records(problems), solvers: records(solvers), entries: records(entries),
      formulations: namesIn(formulations), perturbations: namesIn(perturbations), prices: namesIn(prices),
      orders: records(orders).map(({order}) => order), first_instance, command});
    for (const entry of this.entries) {
      entry.taken = this.families[entry.family].problems.filter((problem, i) => entry.problems === "" || entry.problems[i] === "1");
    }
    this.conditions = new Map();
    for (const entry of this.entries) {
      const condition = conditionOf(entry);
      if (!this.conditions.has(condition)) this.conditions.set(condition, {place: this.conditions.size, entries: []});
      this.conditions.get(condition).entries.push(entry);
    }
  }

  // Gives the runs of all entries under a condition (family, perturbation, price, budget) their places, as
  // src/analysis/comparison/view.h has them: among the runs of other entries with the same problem, instance and
  // seed that miss as many targets, 0 is the best, and equals share theirs.
  placeRuns(entry) {
    if (entry.placed) return;
    const own = this.conditions.get(conditionOf(entry)), bits = new BitReader(this.orders[own.place]), among = new Map();
    for (const one of own.entries) {
      one.placed = true;
      for (const {problem, targets, runs} of this.cellsOf(one)) for (const run of runs) {
        run.place = 0;
        if (run.missing === 0 || run.missing > targets) continue;
        const key = `${problem} ${run.instance} ${run.seed} ${run.missing}`;
        if (!among.has(key)) among.set(key, []);
        const places = among.get(key), code = bits.number(Math.ceil(Math.log2(2 * places.length + 1)));
        if (code % 2) places[(code - 1) / 2].push(run);
        else places.splice(code / 2, 0, [run]);
      }
    }
    for (const places of among.values()) places.forEach((runs, place) => runs.forEach((run) => { run.place = place; }));
  }

  // The cells of an entry, one for each problem that it takes: {entry, problem, price, variables, targets, cluster,
  // runs, counts: whether the problem tells something}.
  cellsOf(entry) {
    if (entry.cells) return entry.cells;
    const missing = new DigitReader(entry.missing), times = new DigitReader(entry.times), spent = new DigitReader(entry.spent), repeats = new DigitReader(entry.repeats);
    let single = repeats.ended ? Infinity : repeats.number();  // runs before the next one that repeats another
    let whole = spent.ended ? Infinity : spent.number();  // runs before the next one that `spent` has
    const {silent} = this.families[entry.family];
    entry.cells = entry.taken.map((problem, i) => {
      const price = entry.shared[i] === "1" ? "n" : this.prices[entry.price];  // a run that is the same at both is stored at n
      const {variables, targets, cluster} = this.problems[problem], budget = entry.budget * variables, runs = [];
      for (let i = 0; i < entry.instances * entry.seeds; ++i) {
        const run = {instance: this.first_instance + Math.floor(i / entry.seeds), seed: i % entry.seeds, missing: missing.digit(), times: [], evaluations: null, repeats: single === 0};
        single = single === 0 ? (repeats.ended ? Infinity : repeats.number()) : single - 1;
        if (run.missing === 63) run.missing += missing.number();
        for (let level = 0, time = 0; level < levels.length && targets - run.missing >= targetsAt(level, targets); ++level) {
          time += times.number();
          run.times.push(time);
        }
        if (run.missing > 0) {
          run.evaluations = budget;
          if (whole === 0) {
            const code = spent.number();
            run.evaluations += code % 2 ? (code + 1) / 2 : -code / 2;
            whole = spent.ended ? Infinity : spent.number();
          } else --whole;
        }
        runs.push(run);
      }
      return {entry, problem, price, variables, targets, cluster, runs, counts: !silent.includes(problem)};
    });
    return entry.cells;
  }
}

// What became of a run at a level within so many evaluations: {reached, evaluations until then, or in all}.
const outcomeOf = (run, level, most) => {
  const time = run.times[level], reached = time !== undefined && time <= most;
  return {reached, evaluations: reached ? time : Math.min(run.evaluations ?? most, most)};
};

const sum = (values) => values.reduce((a, b) => a + b, 0);
// Geometric mean of costs >= 0; one below 1e-6 counts as 1e-6.
const geometricMean = (values) => values.length ? Math.exp(sum(values.map((x) => Math.log(Math.max(x, 1e-6)))) / values.length) : NaN;

// Results of a cell at a level, with at most `cap` evaluations for each variable. Costs are for each variable.
const resultOf = (cell, level, cap) => {
  const {variables, runs} = cell, most = Math.min(cap, cell.entry.budget) * variables;
  const outcomes = runs.map((run) => outcomeOf(run, level, most));
  const once = outcomes.filter((_, i) => !runs[i].repeats), reachedOnce = once.filter(({reached}) => reached).length;
  const solved = outcomes.filter(({reached}) => reached).length, spent = sum(outcomes.map(({evaluations}) => evaluations));
  return {
    cell, outcomes, solved, share: solved / runs.length, distinct: once.length,
    evaluations: Math.max(spent / runs.length, 1) / variables,
    ert: solved ? sum(once.map(({evaluations}) => evaluations)) / reachedOnce / variables : Infinity,  // a run that repeats another counts once
    par10: sum(outcomes.map(({reached, evaluations}) => reached ? Math.max(evaluations, 1) : 10 * most)) / runs.length / variables,
  };
};

// Wilson's interval of 95 %.
const wilson = (successes, trials) => {
  const z = 1.959963984540054, p = successes / trials, scale = 1 + z * z / trials, middle = p + z * z / (2 * trials);
  const half = z * Math.sqrt(Math.max(0, p * (1 - p) / trials + z * z / (4 * trials * trials)));
  return [Math.max(0, (middle - half) / scale), Math.min(1, (middle + half) / scale)];
};

// The quantile of Student's t at 0.975: t = sqrt(degrees) tan(angle), and the density of the angle is a power of its cosine.
const studentQuantile = (degrees) => {
  const steps = 2000, width = Math.PI / 2 / steps, density = (step) => Math.cos((step + 0.5) * width) ** (degrees - 1);
  const whole = sum(Array.from({length: steps}, (_, step) => density(step)));
  let step = 0, below = 0;
  while (below + density(step) < 0.95 * whole) below += density(step++);
  return Math.sqrt(degrees) * Math.tan(width * (step + (0.95 * whole - below) / density(step)));
};

// Lists of the places of equal values.
const placesOf = (values) => {
  const places = new Map();
  values.forEach((value, place) => places.has(value) ? places.get(value).push(place) : places.set(value, [place]));
  return [...places.values()];
};

// The mean of shares with its interval over clusters of problems, as src/analysis/statistics/intervals.cpp has it.
const meanShare = (shares, clusters) => {
  const imagined = 0.1, size = shares.length, mean = Math.min(1, sum(shares) / size), groups = placesOf(clusters), number = groups.length;
  const squares = imagined * (size / number) ** 2 * (mean * mean + (1 - mean) * (1 - mean)) +
    sum(groups.map((places) => sum(places.map((place) => shares[place] - mean)) ** 2));
  let trials = Math.max(size * size / sum(groups.map(({length}) => length ** 2)), mean * (1 - mean) / (number * squares / ((number - 1 + imagined) * size * size)));
  if (number > 1 && number < size) trials *= (1.959963984540054 / studentQuantile(number - 1)) ** 2;
  return [mean, ...wilson(mean * trials, trials)];
};

// Results of a contestant over problems; `results`: one for each problem that it takes.
const summaryOf = (results) => {
  const {share: only, distinct} = results[0];
  const [share, lower, upper] = results.length > 1 ? meanShare(results.map((one) => one.share), results.map(({cell}) => cell.cluster)) : [only, ...wilson(only * distinct, distinct)];
  return {
    share, lower, upper,
    evaluations: geometricMean(results.map((one) => one.evaluations)),
    ert: geometricMean(results.filter((one) => one.solved).map((one) => one.ert)),
    never: results.filter((one) => !one.solved).length,
    par10: geometricMean(results.map((one) => one.par10)),
  };
};

// A contestant beside the reference, on the problems that both take.
const ratioTo = (own, reference) => {
  const pairs = [...own].filter(([key]) => reference.has(key)).map(([key, result]) => [result, reference.get(key)]);
  return {
    problems: pairs.length,
    ratio: geometricMean(pairs.map(([a, b]) => a.par10 / b.par10)),
    fewer: pairs.filter(([a, b]) => a.par10 < b.par10).length,
    more: pairs.filter(([a, b]) => a.par10 > b.par10).length,
    // Of expected running times; 0 where the reference never solves it, infinite where only the reference does.
    ratios: pairs.filter(([a, b]) => a.solved || b.solved).map(([a, b]) => a.solved ? (b.solved ? a.ert / b.ert : 0) : Infinity),
  };
};

// Steps of a distribution: [value, share of the weight up to it], rising.
const distribution = (values) => {
  const steps = [], all = sum(values.map(([, weight]) => weight));
  let reached = 0;
  for (const [value, weight] of [...values].sort(([a], [b]) => a - b)) {
    if (!Number.isFinite(value)) break;
    reached += weight;
    if (steps.length && steps.at(-1)[0] === value) steps.at(-1)[1] = reached / all;
    else steps.push([value, reached / all]);
  }
  return steps;
};

// Evaluations for each variable until the level, over runs; every problem has the same weight.
const runtimes = (results) => distribution(results.flatMap(({cell, outcomes}) => outcomes.map(({reached, evaluations}) =>
  [reached ? Math.max(evaluations, 1) / cell.variables : Infinity, 1 / outcomes.length])));
