// The form above the comparison of solvers: what it chooses, its parts show.
"use strict";

const drawComparison = () => {
  drawAccuracy();
  drawBoard();
  drawCurves();
};

const offerBudgets = () => {
  const budgets = [...new Set(rows.filter((row) => row.family === chosenFamily()).map((row) => row.budget))].sort((a, b) => b - a);
  fill(element("budget"), budgets.map((budget) => [budget, budget === 0 ? "the largest" : String(budget)]));
  drawComparison();
};

const offerFamilies = () => {
  const variables = element("by-variables").value, constraints = element("by-constraints").value;
  const fitting = [...comparison.families.entries()].filter(([, family]) =>
    (!variables || (variables === "one") === (family.variables.most === 1)) &&
    (!constraints || (constraints === "none") === (family.constraints.most === 0)));
  fill(element("family"), fitting.map(([index, family]) =>
    [index, `${familyName(family)} (${extentText(family.variables)} variable${family.variables.most === 1 ? "" : "s"})`]));
  offerBudgets();
};

if (comparison) {
  for (const id of ["by-variables", "by-constraints"]) element(id).addEventListener("change", offerFamilies);
  element("family").addEventListener("change", offerBudgets);
  for (const id of ["budget", "shown"]) element(id).addEventListener("change", drawComparison);
  for (const id of ["speed", "accuracy"]) element(id).addEventListener("change", drawAccuracy);
  element("show-board").addEventListener("click", () => showBeside("leaderboard"));
  element("show-reached").addEventListener("click", () => showBeside("reached"));
  offerFamilies();
}
