"use strict";

// Three solvers look for the fastest quiet speed, one evaluation after the other.
const racerMarks = [(x, y) => `M${x - 4} ${y}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z`, (x, y) => `M${x - 4} ${y - 4}h8v8h-8Z`, (x, y) => `M${x} ${y - 5}l5 9h-10Z`];

class Race {
  constructor(root, again) {
    this.lanes = new Chart(root.querySelector("#lanes"), 250);
    this.gaps = new Chart(root.querySelector("#gaps"), 250);
    this.lanes.again = this.gaps.again = () => this.draw();
    this.body = root.querySelector("tbody");
    this.play = root.querySelector("#race-play");
    this.said = root.querySelector("#race-said");
    this.shown = 0;
    this.runs = false;
    this.play.addEventListener("click", () => {
      if (this.shown >= this.length) this.shown = 0;
      this.run(!this.runs);
    });
    root.querySelector("#race-step").addEventListener("click", () => {
      this.run(false);
      this.shown = Math.min(this.length, this.shown + 1);
      this.draw();
    });
    root.querySelector("#race-end").addEventListener("click", () => {
      this.run(false);
      this.shown = this.length;
      this.draw();
    });
    root.querySelector("#race-again").addEventListener("click", again);
    // It begins by itself when it is first seen, unless motion is unwanted.
    this.still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const seen = new IntersectionObserver(([{isIntersecting}]) => {
      if (!isIntersecting || !this.steps) return;
      seen.disconnect();
      if (!this.still) this.run(true);
    }, {threshold: 0.6});
    seen.observe(this.lanes.svg);
    setInterval(() => {
      if (!this.runs) return;
      this.shown = Math.min(this.length, this.shown + 1);
      if (this.shown >= this.length) this.run(false);
      this.draw();
    }, 120);
  }

  run(runs) {
    this.runs = runs;
    this.play.textContent = runs ? "Pause" : this.shown > 1 && this.shown < this.length ? "Go on" : "Race";
  }

  // `steps`: of each racer; `limit`: the most collisions that are quiet; `best`: the fastest quiet
  // speed that is known [rad/s], or undefined.
  set({steps, limit, fastest, best, seed}) {
    Object.assign(this, {steps, limit, fastest, seed, length: steps[0].length});
    const all = steps.flat().filter(({count}) => count <= limit).map(({omega}) => omega);
    this.best = Math.max(best ?? 0, ...all);
    this.shown = this.still ? this.length : Math.min(this.length, Math.max(this.shown, 1));
    this.run(this.runs);
    this.draw();
  }

  // The fastest quiet speed of a racer's first evaluations; undefined if none is quiet.
  bestOf(racer, evaluations) {
    const quiet = this.steps[racer].slice(0, evaluations).filter(({count}) => count <= this.limit).map(({omega}) => omega);
    return quiet.length ? Math.max(...quiet) : undefined;
  }

  draw() {
    if (!this.steps) return;
    this.drawLanes();
    this.drawGaps();
    this.body.replaceChildren(...Machine.racers.map((name, racer) => {
      const best = this.bestOf(racer, this.shown), row = document.createElement("tr");
      const cells = [name, best === undefined ? "none yet" : `${best.toFixed(3)} rad/s`, best === undefined ? "" : `${(this.best - best).toFixed(3)} rad/s`];
      cells.forEach((text, k) => {
        const cell = document.createElement(k ? "td" : "th");
        if (!k) cell.scope = "row";
        cell.className = k ? "right" : "left";
        cell.textContent = text;
        row.append(cell);
      });
      return row;
    }));
    this.said.textContent = `${this.shown} of ${this.length} evaluations each; the fastest quiet speed known is ${this.best.toFixed(3)} rad/s.`;
  }

  drawLanes() {
    const {lanes, fastest, shown: until} = this, names = Machine.racers;
    const marks = lanes.begin({
      left: 12, x: {from: 0, to: fastest, label: "speed evaluated, rad/s"},
      y: {from: 0, to: names.length, ticks: [], label: ""},
      said: `Where ${names.join(", ")} have evaluated the count: the first ${until} evaluations of each`,
    });
    draw(marks, "line", {class: "goal", x1: lanes.x(this.best), x2: lanes.x(this.best), y1: lanes.top, y2: lanes.bottom});
    names.forEach((name, racer) => {
      const height = (lanes.bottom - lanes.top) / names.length, top = lanes.top + racer * height;
      if (racer) draw(marks, "line", {class: "divide", x1: lanes.left, x2: lanes.right, y1: top, y2: top});
      draw(marks, "text", {class: `racer-${racer} racer-name`, x: lanes.left + 4, y: top + 14}, name);
      this.steps[racer].slice(0, until).forEach(({omega, count}, k) => {
        // From the first at the top of the lane to the last at its bottom.
        const y = top + 20 + (height - 26) * k / Math.max(1, this.length - 1), quiet = count <= this.limit;
        const dot = draw(marks, "path", {class: `racer-${racer} try ${quiet ? "quiet" : "loud"} ${k === until - 1 ? "latest" : ""}`, d: racerMarks[racer](lanes.x(omega), y)});
        draw(dot, "title", {}, `${name}, evaluation ${k + 1}: ${shown(omega, 5)} rad/s, ${collisions(count)}${quiet ? "" : ", loud"}`);
      });
    });
  }

  drawGaps() {
    const {gaps, length, shown: until, best} = this, least = 0.001, write = (x) => x === least ? "≤ 0.001" : String(x);
    const marks = gaps.begin({
      x: {from: 1, to: length, label: "evaluations"}, y: {from: least, to: 20, log: true, ticks: [least, 0.01, 0.1, 1, 10], write, label: "short of the best, rad/s"},
      left: 62, said: `How far the best quiet speed of each solver is short of ${best.toFixed(3)} rad/s, over the first ${until} evaluations`,
    });
    Machine.racers.forEach((name, racer) => {
      let line = "", best = -Infinity, many = 0;
      this.steps[racer].slice(0, until).forEach(({omega, count}, k) => {
        if (count <= this.limit) best = Math.max(best, omega);
        if (best === -Infinity) return;
        const y = gaps.y(Math.min(20, Math.max(least, this.best - best))).toFixed(1), x = gaps.x(k + 1).toFixed(1);
        line += line ? `H${x}V${y}` : `M${x} ${y}h0.01`;
        ++many;
      });
      draw(marks, "path", {class: `racer-${racer} gap`, "data-marks": many, d: line || "M0 0"});
    });
  }
}
