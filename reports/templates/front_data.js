// The data of the front page, which stand in the page, as words, tables and files.
"use strict";

document.documentElement.classList.add("moves");

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

const number = (value, digits = 3) =>
  value === null ? "–" : Number(value.toPrecision(digits)).toLocaleString("en", {maximumSignificantDigits: digits});
const percent = (share) => share === null ? "–" : `${Math.round(100 * share)} %`;
const extentText = ({least, most}) => least === most ? String(most) : `${least} to ${most}`;

const make = (kind, properties = {}, ...parts) => {
  const made = Object.assign(document.createElement(kind), properties);
  made.append(...parts);
  return made;
};

// On a narrow screen a row is a block of labels and values, see look.css; the roles keep it a table.
const fillTable = (table, head, lines) => {
  table.className = "folding";
  table.replaceChildren(make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...lines));
  head.forEach((heading, i) => table.style.setProperty(`--${i + 1}`, JSON.stringify(heading.textContent)));
  table.setAttribute("role", "table");
  for (const [parts, role] of Object.entries({"thead, tbody": "rowgroup", tr: "row", "thead th": "columnheader", "tbody th": "rowheader", td: "cell"})) {
    for (const part of table.querySelectorAll(parts)) part.setAttribute("role", role);
  }
};

const fill = (select, entries) => {
  const before = select.value;
  select.replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
  if (entries.some(([value]) => String(value) === before)) select.value = before;
};

// Boxes that choose among names; `look`: {colour, shape} of each. Those in `unpicked` are not drawn.
const offerPicks = (list, names, unpicked, look, redraw) => {
  list.replaceChildren(...names.map((name, i) => {
    const box = make("input", {type: "checkbox", checked: !unpicked.has(name)}), {colour, shape} = look(name, i);
    box.addEventListener("change", () => {
      unpicked[box.checked ? "delete" : "add"](name);
      redraw();
      list.querySelectorAll("input")[i].focus();
    });
    const swatch = make("span", {className: `swatch ${shape}`});
    swatch.style.background = colour === ink ? "var(--ink)" : colour;
    return make("li", {}, make("label", {}, box, " ", swatch, name));
  }));
};

// A list of objects as files that two links offer.
const offerFiles = (what, names, list) => {
  const address = (type, text) => `data:${type};charset=utf-8,${encodeURIComponent(text)}`;
  element(`${what}-csv`).href = address("text/csv", csvOf(names, list.map((row) => names.map((name) => row[name]))));
  element(`${what}-json`).href = address("application/json", JSON.stringify(list, null, 1));
};
