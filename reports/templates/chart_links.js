// In a heat map whose cells stand for runs, a link lies over one of the cells: the one under the pointer, or the one that
// the arrow keys have chosen. Cells without a value lead nowhere.
"use strict";

for (const data of document.querySelectorAll("figure > script.chart-links")) {
  const figure = data.parentElement, svg = figure.querySelector(":scope > svg"), link = document.createElement("a");
  const {box: [left, right, top, bottom], rows, columns} = JSON.parse(data.textContent);
  const lines = JSON.parse(figure.querySelector("script.chart-csv").textContent).split("\n").slice(1);
  const valueAt = (row, column) => { const line = lines[row * columns.length + column]; return line.slice(line.lastIndexOf(",") + 1); };
  let row = 0, column = 0;
  const lay = () => {
    const picture = svg.getBoundingClientRect(), frame = figure.getBoundingClientRect(), scale = picture.width / svg.viewBox.baseVal.width;
    const x = (at) => picture.left - frame.left + figure.scrollLeft + scale * (left + (right - left) * at / columns.length);
    const y = (at) => picture.top - frame.top + scale * (top + (bottom - top) * at / rows.length);
    Object.assign(link.style, {left: `${x(column)}px`, top: `${y(row)}px`, width: `${x(column + 1) - x(column)}px`, height: `${y(row + 1) - y(row)}px`});
  };
  const choose = (toRow, toColumn) => {
    [row, column] = [toRow, toColumn];
    link.href = rows[row][1] + columns[column][1];
    link.title = `${rows[row][0]}, ${columns[column][0]}: ${Number(Number(valueAt(row, column)).toPrecision(3))} %`;
    link.setAttribute("aria-label", `Runs of ${link.title}. Arrow keys choose another cell.`);
    lay();
  };
  // The cell at a place of the screen, if it has a value.
  const at = ({clientX, clientY}) => {
    const picture = svg.getBoundingClientRect(), scale = picture.width / svg.viewBox.baseVal.width;
    const i = Math.floor(((clientY - picture.top) / scale - top) / (bottom - top) * rows.length);
    const k = Math.floor(((clientX - picture.left) / scale - left) / (right - left) * columns.length);
    return i >= 0 && i < rows.length && k >= 0 && k < columns.length && valueAt(i, k) !== "" ? [i, k] : null;
  };
  const arrows = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]};
  link.addEventListener("keydown", (event) => {
    if (!(event.key in arrows)) return;
    event.preventDefault();
    const [down, across] = arrows[event.key];
    for (let i = row + down, k = column + across; i >= 0 && i < rows.length && k >= 0 && k < columns.length; i += down, k += across) {
      if (valueAt(i, k) !== "") return choose(i, k);
    }
  });
  figure.addEventListener("pointermove", (event) => { const cell = at(event); if (cell) choose(...cell); });
  svg.addEventListener("click", (event) => { const cell = at(event); if (cell) { choose(...cell); link.click(); } });  // by a finger
  const first = lines.findIndex((line) => line !== "" && !line.endsWith(","));
  if (first < 0) continue;
  link.className = "cell-link";
  svg.after(link);
  figure.querySelector("figcaption").append(" A cell leads to its runs; the arrow keys choose one, too.");
  choose(Math.floor(first / columns.length), first % columns.length);
  new ResizeObserver(lay).observe(svg);
}
