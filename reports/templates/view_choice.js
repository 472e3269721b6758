// What a reader has chosen to see of the runs; the link keeps it.

class Choice {
  constructor(table) {
    this.table = table;
    this.orders = ["budget", "target", "rank"];
    this.names = {family: table.families.map((one) => one.family), perturbation: table.perturbations, price: table.prices};
    const joint = table.families.filter((one) => one.joint !== null);
    this.families = [...(joint.length > 1 ? ["all"] : []), ...this.names.family];
    this.usual = {family: this.families[0], variables: "all", budget: "", perturbation: "plain", price: table.prices.includes("measured") ? "measured" : "n", formulation: "best",
                  target: "2", order: "budget", most: "", reference: "", shown: "", entry: "", problem: "", words: ""};
    Object.assign(this, this.usual);
    this.fit();
    this.begun = {...this.usual, perturbation: this.perturbation, price: this.price, budget: this.budget};
  }

  // The entries of the chosen families, whatever their conditions.
  entriesOf(family) {
    const {families, entries, perturbations, prices} = this.table;
    return entries.filter((entry) => family === "all"
      ? families[entry.family].joint === entry.budget && perturbations[entry.perturbation] === "plain" && prices[entry.price] === this.usual.price
      : families[entry.family].family === family);
  }

  // The family of this name, or with an ending if only another part of the plan asks its problems under this perturbation
  // with this budget.
  familyWith(name, perturbation, budget) {
    const fits = (entry) => this.table.perturbations[entry.perturbation] === perturbation && (budget === null || String(entry.budget) === budget);
    return [name, ...this.families.filter((one) => one.startsWith(`${name}-`))].find((family) => this.entriesOf(family).some(fits)) ?? name;
  }

  // The entries under the chosen conditions.
  entries() {
    return this.entriesOf(this.family).filter((entry) => this.table.perturbations[entry.perturbation] === this.perturbation &&
      this.table.prices[entry.price] === this.price && (this.family === "all" || String(entry.budget) === this.budget));
  }

  options() {
    const {table} = this, all = this.entriesOf(this.family), values = (list) => [...new Set(list)];
    const named = all.filter((one) => table.perturbations[one.perturbation] === this.perturbation);
    const priced = named.filter((one) => table.prices[one.price] === this.price), now = this.entries();
    return {
      prices: values(named.map((one) => table.prices[one.price])),
      budgets: this.family === "all" ? [""] : values(priced.map((one) => String(one.budget))).sort((a, b) => b - a),
      formulations: ["best", "all", ...values(now.map((one) => table.formulations[one.formulation])).sort()],
      variables: ["all", ...values(now.flatMap((one) => one.taken.map((problem) => table.problems[problem].variables))).sort((a, b) => a - b).map(String)],
    };
  }

  // Makes the choices fit each other. `kept`: the one that a reader has just made.
  fit(kept) {
    const {table} = this, perturbed = (family) => [...new Set(this.entriesOf(family).map((one) => table.perturbations[one.perturbation]))];
    if (!perturbed(this.family).includes(this.perturbation)) {
      const other = this.families.find((family) => perturbed(family).includes(this.perturbation));
      if (kept === "perturbation" && other) this.family = other;
      else this.perturbation = perturbed(this.family).includes("plain") ? "plain" : perturbed(this.family)[0];
    }
    const first = (key, list, usual) => { if (!list.includes(this[key])) this[key] = list.includes(usual) ? usual : list[0]; };
    first("price", this.options().prices, this.usual.price);
    first("budget", this.options().budgets);
    first("formulation", this.options().formulations, "best");
    first("variables", this.options().variables, "all");
  }

  link() {
    const link = new URLSearchParams();
    for (const [key, usual] of Object.entries(this.begun)) if (this[key] !== usual) link.set(key, this[key]);
    if (this.budget === this.options().budgets[0]) link.delete("budget");  // the largest, which is taken without it
    return String(link);
  }

  // Takes what a link says; returns what is wrong with it, or "".
  follow(text) {
    const link = new URLSearchParams(text), wrong = [];
    Object.assign(this, this.begun);
    for (const [key, value] of link) {
      if (key in this.begun) this[key] = value;
      else wrong.push(`the link has ${key}, which this page does not know`);
    }
    if (link.has("family")) this.family = this.familyWith(this.family, this.perturbation, link.get("budget"));
    const known = {family: this.families, perturbation: this.names.perturbation, price: this.names.price, target: Object.keys(levels), order: this.orders};
    for (const [key, list] of Object.entries(known)) {
      if (list.includes(this[key])) continue;
      wrong.push(`the link has ${key} = ${this[key]}, which these runs do not have`);
      this[key] = this.begun[key];
    }
    if (this.most !== "" && !(Number(this.most) > 0)) {
      wrong.push(`the link has most = ${this.most}, which is no number of evaluations`);
      this.most = "";
    }
    const asked = {...this};
    this.fit(link.has("family") ? undefined : "perturbation");
    for (const key of ["perturbation", "price", "budget", "formulation", "variables"]) {
      if (link.has(key) && asked[key] !== this[key]) wrong.push(`${this.family} has no ${key} ${asked[key]}`);
    }
    return wrong.join("; ");
  }
}

// The contestants of a choice: solvers in their best formulations, or solver-formulation pairs. Each has the
// results of its cells by problem; those that count are of problems that tell something.
const contestantsOf = (table, choice) => {
  const cap = choice.most === "" ? Infinity : Number(choice.most), level = Number(choice.target);
  const byFamily = new Map();
  for (const entry of choice.entries()) {
    const formulation = table.formulations[entry.formulation];
    if (!["best", "all"].includes(choice.formulation) && formulation !== choice.formulation) continue;
    const results = table.cellsOf(entry).filter(({variables}) => choice.variables === "all" || String(variables) === choice.variables)
      .map((cell) => resultOf(cell, level, cap));
    if (results.length === 0) continue;
    const solver = table.solvers[entry.solver].solver, place = `${entry.family} ${solver}`;
    if (!byFamily.has(place)) byFamily.set(place, []);
    const same = byFamily.get(place).find((one) => one.formulation === formulation);  // with another number of instances
    if (same) same.results.push(...results);
    else byFamily.get(place).push({solver, formulation, family: table.families[entry.family].family, results});
  }
  // A formulation is the better, the more problems it accepts, then by success rate, then by evaluations.
  const merit = ({results}) => {
    const counted = results.filter(({cell}) => cell.counts);
    return [counted.length, sum(counted.map((one) => one.share)), -geometricMean(counted.map((one) => one.evaluations))];
  };
  const better = (a, b) => { const i = a.findIndex((x, k) => x !== b[k]); return i >= 0 && a[i] > b[i]; };
  const contestants = new Map();
  for (const all of byFamily.values()) {
    all.sort((a, b) => a.formulation < b.formulation ? -1 : 1);
    const taken = choice.formulation === "best" ? [all.reduce((best, one) => better(merit(one), merit(best)) ? one : best)] : all;
    for (const {solver, formulation, family, results} of taken) {
      const name = choice.formulation === "best" && choice.family === "all" ? solver : `${solver}, ${formulation}`;
      if (!contestants.has(name)) contestants.set(name, {name, solver, results: new Map(), counted: new Map()});
      for (const result of results) {
        const {problem, counts} = result.cell, key = `${family}/${table.problems[problem].problem}`, one = contestants.get(name);
        one.results.set(key, result);
        if (counts) one.counted.set(key, result);
      }
    }
  }
  const all = [...contestants.values()].filter(({counted}) => counted.size > 0), problems = new Set(all.flatMap((one) => [...one.counted.keys()]));
  for (const one of all) Object.assign(one, summaryOf([...one.counted.values()]), {complete: one.counted.size === problems.size});
  const ranked = ranksUnder(table, choice, all, problems, cap);
  return {contestants: all, problems: problems.size, ranked};
};

// The share of the problems that an entry must take to be ranked, as in the tables; of several families all, or the problems
// that an entry does not take would count.
const leastTaken = (choice) => choice.family === "all" ? 1 : .5;

// The ranks of the contestants of a choice; they are kept until another choice changes them.
let keptRanks = {of: null};
const ranksUnder = (table, choice, contestants, problems, cap) => {
  const of = ["family", "variables", "budget", "perturbation", "price", "formulation", "target", "most"].map((key) => choice[key]).join("|");
  if (keptRanks.of !== of) {
    for (const one of contestants) for (const {cell} of one.counted.values()) table.placeRuns(cell.entry);
    const ranked = setRanks(contestants, problems, leastTaken(choice), cap);
    keptRanks = {of, ranked, ranks: new Map(contestants.map(({name, rank, first}) => [name, {rank, first}]))};
  }
  for (const one of contestants) Object.assign(one, keptRanks.ranks.get(one.name));
  return keptRanks.ranked;
};

// The order: by mean rank, those with one first; or those that take all problems first, by success rate, then evaluations, or
// by PAR10.
const inOrder = (contestants, order) => [...contestants].sort((a, b) =>
  (order === "rank" ? (a.rank ?? Infinity) - (b.rank ?? Infinity) || 0 : b.complete - a.complete) ||
  (order === "target" ? a.par10 - b.par10 : b.share - a.share || a.evaluations - b.evaluations) || (a.name < b.name ? -1 : 1));
