// The reader's own view of a comparison: filters the runs that stand in the page, and asks no server.

const byId = (id) => document.getElementById(id);
const table = new RunTable(JSON.parse(byId("view-data").textContent)), choice = new Choice(table), form = byId("view-form");
const percent = (share) => `${Math.round(100 * share)}`, drawnAtMost = 7;

const element = (name, attributes = {}, ...inside) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === "onclick" || key === "onchange") made[key] = value;
    else if (value !== undefined) made.setAttribute(key, value);
  }
  made.append(...inside);
  return made;
};

// Fills a block with a table; a column: {title, left, sorted, value(row)}. A screen shows the first rows of a longer one.
const rowsAtFirst = 10, unfolded = new Set();
const drawTable = (block, caption, columns, rows) => {
  const side = (column) => column.left ? "left" : "right", folds = rows.length > rowsAtFirst + 2, id = `${block.id}-rows`;
  const fold = element("input", {type: "checkbox", id, onchange: (event) => event.target.checked ? unfolded.add(id) : unfolded.delete(id)});
  fold.checked = unfolded.has(id);
  const head = element("tr", {}, ...columns.map((one) => element("th", {scope: "col", class: side(one), "aria-sort": one.sorted}, one.title)));
  const lines = rows.map((row, k) => element("tr", folds && k >= rowsAtFirst ? {class: "later"} : {}, ...columns.map((one, i) => element(i ? "td" : "th", i ? {class: side(one)} : {scope: "row", class: side(one)}, one.value(row)))));
  const table = element("table", {class: "many"}, element("caption", {}, caption), element("thead", {}, head), element("tbody", {}, ...lines));
  block.replaceChildren(...(folds ? [fold, element("label", {for: id}, `Show all ${rows.length} rows`)] : []), table);
};

const fillSelect = (name, values, label = (value) => value) => {
  const select = form.elements[name], wanted = values.map((value) => element("option", {value}, label(value)));
  const there = [...select.options].map((one) => one.value);
  if (there.length !== values.length || there.some((value, i) => value !== values[i])) select.replaceChildren(...wanted);
  select.value = choice[name];
  select.disabled = values.length < 2;
};

const familyLabel = (name) => {
  if (name === "all") return "all families that most solvers take";
  const {problems} = table.families.find((one) => one.family === name);
  return `${name} (${problems.length} problem${problems.length === 1 ? "" : "s"})`;
};
const formulationLabel = (name) => ({best: "the best of each solver", all: "all, each an entry of its own"}[name] ?? name);

const fillForm = (contestants) => {
  const {prices, budgets, formulations, variables} = choice.options();
  fillSelect("family", choice.families, familyLabel);
  fillSelect("variables", variables);
  fillSelect("budget", budgets, (value) => value || "the budget of each family");
  fillSelect("perturbation", choice.names.perturbation);
  fillSelect("formulation", formulations, formulationLabel);
  fillSelect("price", prices, (value) => value === "n" ? "n evaluations" : value);
  fillSelect("target", Object.keys(levels), (level) => levels[level]);
  fillSelect("order", choice.orders, (order) => ({budget: "success rate (fixed budget)", target: "evaluations, PAR10 (fixed target)", rank: "mean rank"}[order]));
  fillSelect("reference", ["", ...contestants.map((one) => one.name).sort()], (name) => name || "the first of the table");
  for (const name of ["most", "words"]) if (form.elements[name] !== document.activeElement) form.elements[name].value = choice[name];
};

// ---- what is shown ----

const [ecdf, ratios] = ["view-ecdf", "view-ratios"].map((id) => ({chart: new Chart(byId(id).querySelector("svg"), 330), caption: byId(id).querySelector("figcaption")}));

// Draws step curves {name, look: a number, steps: [[x, share], ...]} from one end of a logarithmic axis to the other.
const drawSteps = ({chart, caption}, {heading, x, from, to, curves, y, rules, told}) => {
  const share = (one) => 100 * one, percentOf = ({steps}) => Math.round(share(steps.at(-1)?.[1] ?? 0));
  const ends = curves.map((one) => `${one.name} ${percentOf(one)} %`).join(", ");
  chart.draw({
    heading, rules, title: `${heading}. At the right end: ${ends}.`,
    x: {title: x, logarithmic: true, min: from, max: to}, y: {title: y, min: 0, max: 100},
    sets: curves.map(({name, look, steps}) => ({kind: name, told: name, line: "steps", ...lineLook(look),
      data: [[from, 0], ...steps, [to, steps.at(-1)?.[1] ?? 0]].map(([at, reached]) => ({x: at, y: share(reached), of: name}))})),
    tell: ({of, x: at, y: reached}) => [of, `${short(reached)} % at ${short(at)}`],
    numbers: [["entry", x, y], curves.flatMap(({name, steps}) => steps.map(([at, reached]) => [name, at, share(reached)]))],
  });
  caption.textContent = told;
};

const drawCharts = (drawn, reference, problems) => {
  const results = (one) => [...one.counted.values()], target = levels[choice.target];
  const ends = drawn.flatMap((one) => results(one).map(({cell}) => Math.min(cell.entry.budget, Number(choice.most) || Infinity)));
  const curves = drawn.map((one, look) => ({name: one.name, look, steps: runtimes(results(one))}));
  const first = curves.flatMap(({steps}) => steps.length ? [steps[0][0]] : []), to = Math.max(...ends, 1);
  drawSteps(ecdf, {heading: `ECDF of runtimes: ${target}`, x: "evaluations for each variable", y: "runs [%]", from: Math.min(1, to / 2, ...first), to, curves,
    told: `Share of the runs that reach the target by then, mean over the problems that each entry takes, at most ${problems}.`});
  drawSteps(ratios, {heading: `ERT over that of ${reference.name}`, x: "ratio of expected running times", y: "problems [%]", from: 1 / 32, to: 32, rules: [{x: 1, dash: "5 3"}],
    curves: drawn.map((one, look) => ({name: one.name, look, steps: distribution(one.beside.ratios.map((ratio) => [Math.max(ratio, 1 / 32), 1])).filter(([ratio]) => ratio <= 32)}))
      .filter((_, i) => drawn[i] !== reference),
    told: "Share of the problems that both take, and one of them solves, on which an entry's expected running time is at most so many times the reference's. What stands at the left end: the reference never solves these, or needs more than 32 times as much."});
};

const shownEntries = (ordered, chosen) => {
  const asked = choice.shown === "" ? [] : choice.shown.split("|");
  const known = ordered.filter((one) => asked.includes(one.name));
  return known.length ? known : [...new Set([...ordered.slice(0, 5), ...(chosen ? [chosen] : [])])];
};

const setShown = (names) => { choice.shown = names.join("|"); show(); };

const rankWords = () => `Mean rank: over the problems that the entry takes and their runs, among the entries that take ${leastTaken(choice) === 1 ? "all of them" : "at least half of all"}; 1 is the best. P(best): the probability of the least mean rank on problems like these. `;

const drawEntries = (ordered, drawn, problems, ranked) => {
  const words = choice.words.toLowerCase(), listed = ordered.filter((one) => one.name.toLowerCase().includes(words));
  const columns = [
    {title: "entry", left: true, value: (one) => element("button", {type: "button", "aria-expanded": String(one.name === choice.entry), onclick: () => openEntry(one.name)}, one.name)},
    {title: "drawn", value: (one) => element("input", {type: "checkbox", "aria-label": `draw ${one.name}`, ...(drawn.includes(one) ? {checked: ""} : {}),
      onchange: (event) => {
        const names = drawn.map(({name}) => name).filter((name) => name !== one.name);
        setShown(event.target.checked ? [...names, one.name].slice(-drawnAtMost) : names);
      }})},
    {title: "problems", value: (one) => `${one.counted.size} of ${problems}`},
    {title: "success rate [%]", sorted: choice.order === "budget" ? "descending" : undefined, value: (one) => `${percent(one.share)} [${percent(one.lower)}, ${percent(one.upper)}]`},
    ...(ranked ? [
      {title: `mean rank of ${ranked}`, sorted: choice.order === "rank" ? "ascending" : undefined, value: (one) => short(one.rank)},
      {title: "P(best)", value: (one) => one.first === undefined ? "–" : one.first.toFixed(2)},
    ] : []),
    {title: "evaluations a variable", value: (one) => short(one.evaluations)},
    {title: "ERT a variable", value: (one) => one.never < one.counted.size ? `${short(one.ert)} on ${one.counted.size - one.never}` : "–"},
    {title: "PAR10 a variable", sorted: choice.order === "target" ? "ascending" : undefined, value: (one) => short(one.par10)},
    {title: "PAR10 over the reference's", value: (one) => one.beside.problems ? short(one.beside.ratio) : "–"},
    {title: "PAR10 lower, higher on", value: (one) => `${one.beside.fewer}, ${one.beside.more} of ${one.beside.problems}`},
  ];
  drawTable(byId("view-entries"),
    `${listed.length} entries. Success rate: mean over the problems that the entry takes, with its 95 % interval. ${ranked ? rankWords() : ""}Evaluations until the target, or in all: geometric mean. ERT: expected evaluations until the target, ` +
    "with restarts, on so many problems with a run that reached it. PAR10 charges a run that does not ten times its budget. An entry's name opens its problems.", columns, listed);
};

const drawProblems = (one, reference) => {
  const block = byId("view-problems");
  block.hidden = !one;
  if (!one) return;
  block.querySelector("h3").textContent = `Problems of ${one.name}`;
  const rows = [...one.results].map(([key, result]) => ({key, result, beside: reference.results.get(key)}));
  drawTable(block.querySelector(".scroll"), `Beside ${reference.name}. A problem's name opens the runs.`, [
    {title: "problem", left: true, value: ({key, result}) => element("button", {type: "button", "aria-expanded": String(key === choice.problem), onclick: () => openProblem(key)}, table.problems[result.cell.problem].problem)},
    {title: "formulation", left: true, value: ({result}) => table.formulations[result.cell.entry.formulation]},
    {title: "variables", value: ({result}) => String(result.cell.variables)},
    {title: "runs with the target", value: ({result}) => `${result.solved} of ${result.outcomes.length}`},
    {title: "ERT", value: ({result}) => result.solved ? short(result.ert * result.cell.variables) : "never"},
    {title: "ERT of the reference", value: ({beside}) => beside ? (beside.solved ? short(beside.ert * beside.cell.variables) : "never") : "–"},
  ], rows);
};

// The commands for a run: one that makes it again, and one that makes it again and compares it with a store.
const quoted = (text) => /^[\w.,:=+/-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
const commandsOf = (cell, run) => {
  const {entry} = cell, solver = table.solvers[entry.solver], family = table.families[entry.family], commands = [];
  const problem = table.problems[cell.problem].problem, formulation = table.formulations[entry.formulation];
  const perturbation = table.perturbations[entry.perturbation], {price} = cell;
  if (family.suite && !solver.outside && price === "n") {
    commands.push(`./ricochet solve ${quoted(solver.solver)} ${quoted(problem)} --formulation ${quoted(formulation)}${perturbation === "plain" ? "" : ` --perturbation ${perturbation}`} ` +
      `--budget ${entry.budget * cell.variables} --instance ${run.instance} --seed ${run.seed}`);
  }
  const key = [problem, formulation, perturbation, solver.solver, entry.budget, price, run.instance, run.seed];
  commands.push(`./ricochet replay mine/runs.sqlite ${quoted(key.join("/"))}`);
  return commands;
};

const drawRuns = (result) => {
  const block = byId("view-runs");
  block.hidden = !result;
  if (!result) return;
  const {cell, outcomes} = result, name = table.problems[cell.problem].problem;
  block.querySelector("h3").textContent = `Runs of ${table.solvers[cell.entry.solver].solver}, ${table.formulations[cell.entry.formulation]}, on ${name}`;
  block.querySelector("p").textContent = `solve makes a run again; replay also compares it with the stored one, bit by bit. The store is made by ${table.command}; runs of the plan reference are in the included archive, too: write archive in place of mine/runs.sqlite.`;
  block.querySelector("pre").textContent = cell.runs.flatMap((run) => commandsOf(cell, run)).join("\n");
  const rows = cell.runs.map((run, i) => ({run, outcome: outcomes[i]}));
  drawTable(block.querySelector(".scroll"), "One line for each run. Targets: those that the returned point reaches, with the whole budget.", [
    {title: "instance", value: ({run}) => String(run.instance)},
    {title: "seed", value: ({run}) => String(run.seed)},
    {title: "target reached", left: true, value: ({outcome}) => outcome.reached ? "yes" : "no"},
    {title: "evaluations until then, or in all", value: ({outcome}) => String(outcome.evaluations)},
    {title: "targets", value: ({run}) => run.missing > cell.targets ? "infeasible" : `${cell.targets - run.missing} of ${cell.targets}`},
    ...(cell.runs.some((run) => run.repeats) ? [{title: "repeats an earlier run", left: true, value: ({run}) => run.repeats ? "yes" : ""}] : []),
  ], rows);
};

// First is who has the least mean rank, here as everywhere.
const ahead = {rank: "is first", budget: "solves most", target: "has the least PAR10"};

const sentence = (ordered, problems) => {
  const all = ordered.filter((one) => one.complete), [first, second] = ordered;
  if (!first) return "No entry is left.";
  const rate = choice.target === "2" ? "success rate" : `with ${levels[choice.target]} in`, among = [
    ...(choice.family === "all" ? [] : [` of ${choice.family}`]), ...(choice.variables === "all" ? [] : [` with ${choice.variables} variable${choice.variables === "1" ? "" : "s"}`]),
    ...(choice.perturbation === "plain" ? [] : [` under ${choice.perturbation}`])].join("");
  const rank = (one) => one.rank ? `mean rank ${short(one.rank)}${one.first === undefined ? "" : `, P(best) ${one.first.toFixed(2)}`}` : "not ranked";
  const number = (one) => choice.order === "rank" ? `${rank(one)}, ${rate} ${percent(one.share)} %` : choice.order === "budget" ? `${rate} ${percent(one.share)} % [${percent(one.lower)}, ${percent(one.upper)}]` : `PAR10 ${short(one.par10)} evaluations a variable, ${rate} ${percent(one.share)} %`;
  const sure = second && choice.order === "budget" && second.complete === first.complete && second.upper >= first.lower && first.lower < first.share
    ? " The intervals overlap: the runs do not tell which is better." : "";
  const [least] = inOrder(ordered, "rank"), other = choice.order !== "rank" && least.rank && least !== first
    ? ` By mean rank ${least.name} is first, on ${least.counted.size} of ${problems} problem${problems === 1 ? "" : "s"}: ${rank(least)}.` : "";
  return `${first.name} ${ahead[choice.order]} on ${first.counted.size} problem${first.counted.size === 1 ? "" : "s"}${among}, ${number(first)}` +
    `${second ? `; then ${second.name}, ${number(second)}` : ""}.${sure}${other} ${all.length} of ${ordered.length} entries take all ${problems} problems.`;
};

// Drawing a table again keeps the focus of the keyboard.
const nameOf = (one) => one.getAttribute("aria-label") ?? one.textContent;
const keepingFocus = (draw) => {
  const active = document.activeElement, block = active?.closest?.("#view-entries, #view-problems");
  draw();
  if (!block || active.isConnected) return;
  [...block.querySelectorAll(active.localName)].find((one) => nameOf(one) === nameOf(active))?.focus();
};

let following = "";  // the link as it was last read or written
const show = (complaint = "") => {
  const {contestants, problems, ranked} = contestantsOf(table, choice), ordered = inOrder(contestants, choice.order);
  fillForm(contestants);
  const reference = ordered.find((one) => one.name === choice.reference) ?? ordered[0];
  byId("view-complaint").textContent = complaint;
  byId("view-answer").textContent = sentence(ordered, problems);
  for (const id of ["view-charts", "view-entries"]) byId(id).hidden = !reference;
  if (reference) {
    for (const one of ordered) one.beside = ratioTo(one.counted, reference.counted);
    const chosen = ordered.find((one) => one.name === choice.entry) ?? ordered.find((one) => one.solver === choice.entry);
    if (chosen) choice.entry = chosen.name;
    const drawn = shownEntries(ordered, chosen);
    drawCharts(drawn, reference, problems);
    keepingFocus(() => {
      drawEntries(ordered, drawn, problems, ranked);
      drawProblems(chosen, reference);
    });
    drawRuns(chosen?.results.get(choice.problem));
  }
  following = choice.link();
  if (location.hash.replace(/^#/, "") !== following && (following || location.hash.includes("="))) history.replaceState(null, "", `#${following}`);
};

const openAt = (id, block = "nearest") => { const heading = byId(id).querySelector("h3"); heading.focus(); heading.scrollIntoView({block}); };
const openEntry = (name) => {
  choice.entry = choice.entry === name ? "" : name;
  choice.problem = "";
  show();
  if (choice.entry) openAt("view-problems");
};
const openProblem = (key) => {
  choice.problem = choice.problem === key ? "" : key;
  show();
  if (choice.problem) openAt("view-runs");
};

// What a link to a place of the page says is none of a view.
const follow = () => {
  const link = location.hash.replace(/^#/, "");
  if (link !== "" && !link.includes("=")) return show();
  show(choice.follow(link));
  if (choice.problem) openAt("view-runs", "start");
  else if (choice.entry) openAt("view-problems", "start");
};

form.addEventListener("input", ({target}) => {
  if (!(target.name in choice.begun)) return;
  choice[target.name] = target.value;
  if (target.name !== "words") choice.problem = "";
  choice.fit(target.name);
  show();
});
form.addEventListener("submit", (event) => event.preventDefault());
byId("view-usual").addEventListener("click", () => { Object.assign(choice, choice.begun); show(); });
byId("view-first").addEventListener("click", () => setShown([]));
addEventListener("hashchange", () => { if (location.hash.replace(/^#/, "") !== following) follow(); });
form.hidden = false;
follow();
