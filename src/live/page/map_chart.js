"use strict";

// Collisions a turn in the long run, over restitution and speed: one column of regimes for each
// restitution, as it is solved.
class MapChart {
  constructor(figure, choose) {
    this.chart = new Chart(figure, 330);
    this.chart.again = () => this.draw();
    this.columns = [];
    this.chart.svg.addEventListener("click", (event) => {
      const box = this.chart.svg.getBoundingClientRect(), {top, bottom, yAxis} = this.chart;
      const share = (bottom - (event.clientY - box.top) / box.height * this.chart.height) / (bottom - top);
      choose(this.chart.under(event), yAxis.from + share * (yAxis.to - yAxis.from));
    });
  }

  // Begins a map whose columns are to come. `cases`: the paper's on it; `width`: of a column.
  begin(parts) {
    Object.assign(this, parts, {columns: []});
    this.draw();
  }

  add(column) {
    this.columns.push(column);
    if (this.columns.length === 1) return this.draw();
    this.drawColumn(column);
    this.raise();
  }

  drawColumn({restitution, regimes}) {
    const {chart, fastest, width} = this, left = chart.x(Math.max(0, restitution - width / 2)), right = chart.x(Math.min(1, restitution + width / 2));
    for (const {from, to, most} of regimes) {
      const top = chart.y(Math.min(to, fastest)), bottom = chart.y(from);
      const cell = draw(this.cells, "rect", {class: `cell ${loudness(most)}`, x: left.toFixed(1), width: (right - left + 0.4).toFixed(1), y: top.toFixed(1), height: Math.max(0.3, bottom - top).toFixed(1)});
      draw(cell, "title", {}, `restitution ${shown(restitution)}, ${shown(from, 4)} to ${shown(to, 4)} rad/s: at most ${collisions(most)} a turn`);
    }
  }

  // What stands before the columns.
  raise() { this.chart.svg.append(this.front); }

  draw() {
    const {chart, fastest, cases, restitution, omega} = this;
    if (!fastest) return;
    const marks = chart.begin({
      x: {from: 0, to: 1, label: "restitution"}, y: {from: 0, to: fastest, label: "speed, rad/s"},
      said: `Most collisions a turn in the long run over restitution and speed, at ${this.columns.length} restitutions`,
    });
    this.cells = draw(marks, "g");
    this.columns.forEach((column) => this.drawColumn(column));
    this.front = draw(chart.svg, "g");
    for (const {id, restitution: at, threshold} of cases) {
      if (Number.isNaN(threshold) || threshold > fastest) continue;
      const dot = draw(this.front, "circle", {class: "paper-dot", cx: chart.x(at), cy: chart.y(threshold), r: 8});
      draw(dot, "title", {}, `the paper's threshold of ${id}: ${shown(threshold)} rad/s`);
      draw(this.front, "text", {class: "paper-label", x: chart.x(at) + (at > 0.5 ? -14 : 14), y: chart.y(threshold) + 4, "text-anchor": at > 0.5 ? "end" : "start"}, `${id}, paper`);
    }
    this.own = draw(this.front, "circle", {class: "own-dot", r: 5});
    this.point(restitution, omega);
  }

  point(restitution, omega) {
    Object.assign(this, {restitution, omega});
    if (!this.own) return;
    this.own.setAttribute("cx", this.chart.x(restitution));
    this.own.setAttribute("cy", this.chart.y(Math.min(omega, this.fastest)));
  }
}
