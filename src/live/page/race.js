"use strict";

// Three solvers look for the fastest speed whose window is quiet, one evaluation after the other.
const racerShapes = ["circle", "square", "triangle"];

class Race {
  constructor(root, again) {
    [this.lanes, this.gaps] = ["#lanes", "#gaps"].map((id) => new Chart(root.querySelector(`${id} svg`), 260));
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
      this.shown = Math.min(this.length, this.shown + 1);
      this.run(false);
      this.draw();
    });
    root.querySelector("#race-end").addEventListener("click", () => {
      this.shown = this.length;
      this.run(false);
      this.draw();
    });
    root.querySelector("#race-again").addEventListener("click", again);
    // It begins by itself when it is first seen, unless motion is unwanted.
    this.still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const seen = new IntersectionObserver(([{isIntersecting}]) => {
      if (!isIntersecting || !this.steps) return;
      seen.disconnect();
      if (!this.still && this.shown <= 1) this.run(true);  // nobody has moved it yet
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

  // `steps`: of each racer; `limit`: the most collisions that are quiet; `goal`: the fastest quiet
  // speed [rad/s], the same for every seed; NaN if no speed is quiet.
  set({steps, limit, fastest, goal}) {
    Object.assign(this, {steps, limit, fastest, goal, length: steps[0].length});
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
      const best = this.bestOf(racer, this.shown);
      const cells = [name, ...best === undefined ? ["none yet", ""] : [bothUnits(best), `${(this.goal - best).toFixed(3)} rad/s`]];
      return element("tr", {}, ...cells.map((textContent, k) => element(k ? "td" : "th", {textContent, className: k ? "right" : "left", ...(k ? {} : {scope: "row"})})));
    }));
    const goal = Number.isNaN(this.goal) ? "no speed has so few collisions" : `the fastest speed with at most ${plural(this.limit, "collision")} is ${bothUnits(this.goal)}, by a scan`;
    this.said.textContent = `${this.shown} of ${plural(this.length, "evaluation")} each; ${goal}.`;
  }

  drawLanes() {
    const {fastest, shown: until, length} = this, names = Machine.racers, lanes = names.length;
    // From the first at the top of the lane to the last at its bottom.
    const data = names.map((name, racer) => this.steps[racer].slice(0, until).map(({omega, count}, k) => ({
      x: omega, y: lanes - racer - 0.28 - 0.66 * k / Math.max(1, length - 1), count, told: `${name}, evaluation ${k + 1}`,
      className: `racer-${racer} try ${count <= this.limit ? "quiet" : "loud"} ${k === until - 1 ? "latest" : ""}`,
    })));
    this.lanes.draw({
      title: `Where ${names.join(", ")} have evaluated the count: the first ${plural(until, "evaluation")} of each`,
      x: speedAxis("speed evaluated", fastest), y: {title: "", min: 0, max: lanes, ticks: []},
      rules: Number.isNaN(this.goal) ? [] : [{x: this.goal, className: "goal"}],
      sets: data.map((points, racer) => ({data: points, radius: 4, shape: racerShapes[racer]})),
      tell: ({told, x, count}) => [told, bothUnits(x), `${plural(count, "collision")}${count <= this.limit ? "" : ", loud"}`],
      below: (group) => names.forEach((name, racer) => {
        const {left, right} = this.lanes.area, top = this.lanes.y(lanes - racer);
        if (racer) addSvg(group, "path", {class: "divide", d: `M${left},${rounded(top)}H${right}`});
        addSvg(group, "text", {class: `racer-${racer} racer-name`, x: left + 4, y: top + 14}, name);
      }),
    });
  }

  drawGaps() {
    const {length, shown: until, goal} = this, least = 0.001, most = 20;
    const sets = Machine.racers.map((name, racer) => {
      const points = Array.from({length: until}, (_, k) => ({x: k + 1, y: goal - this.bestOf(racer, k + 1), told: name}));
      return {data: points.filter(({y}) => !Number.isNaN(y)), line: "steps", kind: name, className: `racer-${racer} gap`};
    });
    this.gaps.draw({
      title: `How far the best quiet speed of each solver is short of the goal, over the first ${plural(until, "evaluation")}`,
      x: {title: "evaluations", min: 1, max: length},
      y: {title: "short of the goal, rad/s", min: least, max: most, logarithmic: true, write: (x) => x === least ? `≤ ${x}` : tickLabel(x), second: {unit: "rpm", factor: 30 / Math.PI}},
      sets, tell: ({told, x, y}) => [told, `${y.toFixed(3)} rad/s short after ${plural(x, "evaluation")}`],
    });
  }
}
