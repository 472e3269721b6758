// The leaderboard of what the form chooses.
"use strict";

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

const sortBy = (key) => {
  sorting.down = sorting.by === key ? !sorting.down : !["place", "solver", "evaluations", "seconds"].includes(key);
  sorting.by = key;
  drawBoard();
  document.querySelector(`#board button[data-column="${key}"]`).focus();
};

const drawBoard = () => {
  const list = sorted(withPlaces(chosen()));
  const columns = boardColumns.filter(([key]) => list.some((row) => row[key] !== null));  // of all families some are not known
  const head = columns.map(([key, title, , className]) => {
    const button = make("button", {type: "button"}, title), heading = make("th", {scope: "col", className}, button);
    button.dataset.column = key;
    button.addEventListener("click", () => sortBy(key));
    if (sorting.by === key) heading.setAttribute("aria-sort", sorting.down ? "descending" : "ascending");
    return heading;
  });
  const body = list.map((row, i) => {
    const tie = sorting.by === "place" && list[i + 1]?.shown_place === row.shown_place;
    return make("tr", {className: tie ? "tie" : ""}, ...columns.map(([key, , text, className]) =>
      key === "solver" ? make("th", {scope: "row", className}, text(row)) : make("td", {className}, text(row))));
  });
  fillTable(element("board"), head, body);
  const family = comparison.families[chosenFamily()]?.name;
  offerFiles("board", Object.keys(rows[0]), list.map(({shown_place, ...row}) => ({...row, family})));
};
