"use strict";

// Collisions a turn in the long run, over restitution and speed: one column of regimes for each
// restitution, as it is solved.
class MapChart {
  constructor(figure, choose) {
    this.chart = new Chart(figure.querySelector("svg"), 330);
    this.columns = [];
    this.chart.svg.addEventListener("click", (event) => {
      const {x, y} = this.chart.values(event);
      choose(x, y);
    });
  }

  // Begins a map whose columns are to come. `cases`: the paper's on it; `width`: of a column.
  begin(parts) {
    Object.assign(this, parts, {columns: []});
    this.draw();
  }

  add(column) {
    this.columns.push(column);
    this.drawColumn(column);
  }

  drawColumn({restitution, regimes}) {
    const {chart, fastest, width} = this, left = chart.x(restitution - width / 2), right = chart.x(restitution + width / 2);
    for (const {from, to, most} of regimes) {
      const top = chart.y(Math.min(to, fastest)), bottom = chart.y(from);
      const cell = addSvg(this.cells, "rect", {class: `cell ${loudness(most)}`, x: left, width: right - left + 0.4, y: top, height: Math.max(0.3, bottom - top)});
      addSvg(cell, "title", {}, `restitution ${number(restitution)}, ${number(from, 4)} to ${number(to, 4)} rad/s: at most ${plural(most, "collision")} a turn`);
    }
  }

  draw() {
    const {chart, fastest, cases} = this;
    const known = cases.filter(({threshold}) => threshold <= fastest).map(({id, restitution, threshold}) => ({x: restitution, y: threshold, id, name: `${id}, paper`}));
    chart.draw({
      title: `Most collisions a turn in the long run over restitution and speed up to ${number(fastest)} rad/s`,
      x: {title: "restitution", min: 0, max: 1}, y: speedAxis("speed, rad/s", fastest),
      sets: [{data: known, radius: 8, className: "paper-dot", nameColour: "black"}],
      tell: ({id, y}) => [`The paper's threshold of ${id}`, bothUnits(y, number(y))],
      below: (group) => {
        this.cells = group;
        this.columns.forEach((column) => this.drawColumn(column));
      },
      above: (group) => {
        this.own = addSvg(group, "path", {class: "own-dot", d: outlines.circle(0, 0, 5)});
        this.point(this.restitution, this.omega);
      },
    });
  }

  point(restitution, omega) {
    Object.assign(this, {restitution, omega});
    this.own?.setAttribute("transform", `translate(${rounded(this.chart.x(restitution))} ${rounded(this.chart.y(omega))})`);
  }
}
