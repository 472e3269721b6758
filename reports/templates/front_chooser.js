// Which solver for your problem? A form and the first solvers of the kinds of problems that match it.
"use strict";

const {chooser} = site;
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

const choiceColumns = [["kind of problem", "left"], ["best entries", "left"], ["solved [%]", "right"], ["P(best)", "right"], ["problems", "right"],
                       ["variables", "right"], ["evaluations a variable", "right"]];

const drawChoice = () => {
  const value = (name) => element(`choose-${name}`).value;
  const choice = {variables: Math.max(1, Number(value("variables")) || 1), evaluations: Math.max(1, Number(value("evaluations")) || 1),
                  gradient: value("gradient") === "yes", constraints: value("constraints"), objective: value("objective"), trouble: value("trouble")};
  const found = matching(choice);
  element("choice").textContent = choiceSentence(choice, found);
  const lines = found.flatMap((one) => one.entries.filter((e) => choice.gradient || !e.gradient).slice(0, 3).map((entry, i) => {
    const kind = i > 0 ? [] : [make("a", {href: `${one.folder}/index.html`}, one.title ? `${one.title} (${one.family})` : one.family)];
    const texts = [solvedText(entry), entry.best === null ? "–" : entry.best.toFixed(2),
                   `${entry.problems ?? one.problems} of ${one.problems}${one.runs === null ? "" : `, ${one.runs} runs`}`, extentText(one.variables), one.budget];
    return make("tr", {}, make("td", {className: "left"}, ...kind), make("th", {scope: "row", className: "left"}, `${entry.solver}, ${entry.formulation}`),
                ...texts.map((text) => make("td", {className: "right"}, text)));
  }));
  const head = choiceColumns.map(([title, className]) => make("th", {scope: "col", className}, title));
  fillTable(element("choices"), head, lines);
};

// What the address asks for: ?variables=4&evaluations=400&trouble=noisy
const readChoice = () => {
  for (const [name, value] of new URLSearchParams(location.search)) {
    const field = element(`choose-${name}`);
    if (field) field.value = value;
  }
};

if (chooser && chooser.situations.length) {
  readChoice();
  element("choose").addEventListener("input", drawChoice);
  element("choose").addEventListener("submit", (event) => event.preventDefault());
  drawChoice();
}
