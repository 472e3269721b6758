"use strict";

// The motion in the window, and the collisions over the speed.

// x(t) with its impacts; follows the picture's time.
class PathChart {
  constructor(figure) {
    this.chart = new Chart(figure, 190);
    this.chart.again = () => this.draw();
  }

  set(motion, {lower, upper}) {
    Object.assign(this, {motion, lower, upper: Number.isFinite(upper) ? upper : Math.max(...motion.path.map(([, x]) => x))});
    this.draw();
  }

  draw() {
    if (!this.motion) return;
    const {chart, motion} = this, {impacts, path, end, count} = motion, mm = (x) => 1000 * (x - this.lower);
    const marks = chart.begin({
      x: {from: 0, to: end, label: "time, s"}, y: {from: 0, to: mm(this.upper), label: "position, mm"},
      said: `The carrier's position over ${shown(end)} seconds: ${impacts.length} impacts, ${count} of them count`,
    });
    draw(marks, "path", {class: "path", "data-marks": path.length, d: path.map(([t, x], k) => `${k ? "L" : "M"}${chart.x(t).toFixed(1)} ${chart.y(mm(x)).toFixed(1)}`).join("")});
    for (const {time, upper, speed, counts} of impacts) {
      const dot = draw(marks, "circle", {class: `impact ${counts ? "counts" : ""}`, cx: chart.x(time), cy: upper ? chart.top : chart.bottom, r: counts ? 4.5 : 2.5});
      draw(dot, "title", {}, `${time.toFixed(3)} s, ${upper ? "upper" : "lower"} wall, ${shown(speed * 1000)} mm/s${counts ? "" : ", too slow to count"}`);
    }
    this.now = draw(chart.svg, "line", {class: "now", y1: chart.top, y2: chart.bottom});
    this.follow(0);
  }

  follow(time) {
    if (!this.now) return;
    for (const end of ["x1", "x2"]) this.now.setAttribute(end, this.chart.x(time));
  }
}

// Counts of the window over the speed, before the regimes of the long run, with both rules.
class StaircaseChart {
  constructor(figure, choose) {
    this.chart = new Chart(figure, 330);
    this.chart.again = () => this.draw();
    const {svg} = this.chart, move = (event) => choose(this.chart.under(event));
    svg.addEventListener("pointerdown", (event) => {
      svg.setPointerCapture(event.pointerId);
      svg.addEventListener("pointermove", move);
      move(event);
    });
    const end = () => svg.removeEventListener("pointermove", move);
    svg.addEventListener("pointerup", end);
    svg.addEventListener("pointercancel", end);
  }

  set(parts) {
    Object.assign(this, parts);
    this.draw();
  }

  draw() {
    if (!this.counts) return;
    const {chart, counts, step, regimes, limit} = this, fastest = step * counts.length;
    const highest = Math.max(8, ...counts), over = (k) => Number(((k + 1) * step).toPrecision(12));
    const marks = chart.begin({
      x: {from: 0, to: fastest, label: "speed of the driver plate, rad/s"}, y: {from: 0, to: highest * 1.08, label: "collisions in the window"},
      said: `Collisions in the window at ${counts.length} speeds up to ${shown(fastest)} rad/s: from ${Math.min(...counts)} to ${Math.max(...counts)}`,
      rows: 4,
    });
    for (const {from, to, most} of regimes ?? []) {
      const left = chart.x(Math.min(from, fastest)), right = chart.x(Math.min(to, fastest));
      const band = draw(marks, "rect", {class: `band ${loudness(most)}`, x: left, width: Math.max(0.5, right - left), y: chart.top, height: chart.bottom - chart.top});
      draw(band, "title", {}, `${shown(from, 4)} to ${shown(to, 4)} rad/s: at most ${collisions(most)} a turn in the long run`);
      if (right - left > 58) draw(marks, "text", {class: "band-label", x: (left + right) / 2, y: chart.top + 14, "text-anchor": "middle"}, `${shown(most)} a turn`);
    }
    const half = Math.max(0.45, (chart.x(step) - chart.x(0)) / 2);
    for (const loud of [false, true]) {
      const chosen = [...counts.keys()].filter((k) => (counts[k] > limit) === loud);
      draw(marks, "path", {class: loud ? "counts loud" : "counts quiet", "data-marks": chosen.length, d: chosen.map((k) => `M${(chart.x(over(k)) - half).toFixed(2)} ${chart.y(counts[k]).toFixed(1)}h${(2 * half).toFixed(2)}`).join("")});
    }
    if (limit !== undefined) draw(marks, "line", {class: "limit", x1: chart.left, x2: chart.right, y1: chart.y(limit + 0.5), y2: chart.y(limit + 0.5)});
    const {longRun, window: ofWindow, paper, omega} = this;
    if (longRun) chart.rule(longRun, `two a turn end: ${longRun.toFixed(3)}`, "long-run", 0);
    if (ofWindow) chart.rule(ofWindow, `paper's rule: ${ofWindow.toFixed(2)}`, "window", 1);
    if (paper) chart.rule(paper, `the paper says ${shown(paper)}`, "paper", 2);
    this.here = draw(chart.svg, "g", {class: "here"});
    draw(this.here, "line", {x1: 0, x2: 0, y1: chart.top - 6, y2: chart.bottom});
    draw(this.here, "circle", {cx: 0, cy: chart.bottom, r: 7});
    this.point(omega);
  }

  // Moves the mark of the present speed.
  point(omega) {
    this.omega = omega;
    if (this.here) this.here.setAttribute("transform", `translate(${this.chart.x(Math.min(omega, this.chart.xAxis.to))} 0)`);
  }
}
