"use strict";

// The motion in the window, and the collisions over the speed.

// The axis of a speed [rad/s], with rpm beside it.
const speedAxis = (title, max, min = 0) => ({title, min, max, unit: "rad/s", second: {unit: "rpm", factor: 30 / Math.PI}});

// The colour of a number of collisions a turn: its class; from 6 on pairs share one.
const loudness = (perTurn) => `turn-${Math.min(6, Math.ceil(perTurn / 2))}`;

// x(t) with its impacts; follows the picture's time.
class PathChart {
  constructor(figure) { this.chart = new Chart(figure.querySelector("svg"), 190); }

  set(motion, {lower, upper}) {
    const {impacts, path, end, count} = motion, mm = (x) => 1000 * (x - lower), highest = Number.isFinite(upper) ? upper : Math.max(...path.map(([, x]) => x));
    const speed = (impact) => `${number(impact.speed * 1000)} mm/s${impact.counts ? "" : ", too slow to count"}`;
    const struck = impacts.map((impact) => ({x: impact.time, y: impact.upper ? mm(highest) : 0, told: `${impact.upper ? "upper" : "lower"} wall, ${speed(impact)}`, counts: impact.counts}));
    this.chart.draw({
      title: `The carrier's position over ${plural(end, "second")}: ${plural(impacts.length, "impact")}, of which ${count} ${count === 1 ? "counts" : "count"}`,
      x: {title: "time, s", min: 0, max: end}, y: {title: "position, mm", min: 0, max: mm(highest)},
      sets: [{data: path.map(([t, x]) => ({x: t, y: mm(x), told: `${number(mm(x))} mm`})), line: "straight", className: "path"},
             ...[false, true].map((counts) => ({data: struck.filter((one) => one.counts === counts), radius: counts ? 4.5 : 2.5, className: counts ? "impact counts" : "impact"}))],
      above: (group) => {
        this.now = addSvg(group, "path", {class: "now", d: `M0,${this.chart.area.top}V${this.chart.area.bottom}`});
        this.follow(this.time ?? 0);
      },
      tell: ({x, told}) => [`${x.toFixed(3)} s`, told],
    });
  }

  follow(time) {
    this.time = time;
    this.now?.setAttribute("transform", `translate(${rounded(this.chart.x(time))} 0)`);
  }
}

// Counts of the window over the speed, before the regimes of the long run, with both rules.
class StaircaseChart {
  constructor(figure, choose) {
    this.chart = new Chart(figure.querySelector("svg"), 345);
    const {svg} = this.chart, move = (event) => choose(this.chart.values(event).x);
    svg.addEventListener("pointerdown", (event) => {
      svg.setPointerCapture(event.pointerId);
      svg.addEventListener("pointermove", move);
      move(event);
    });
    const end = () => svg.removeEventListener("pointermove", move);
    svg.addEventListener("pointerup", end);
    svg.addEventListener("pointercancel", end);
  }

  // `counts`: at step, 2 step, ... rad/s; `limit`: the most collisions that are quiet; `rules`: see below. What is not known is left out.
  set({counts, step, regimes = [], limit, rules, omega}) {
    this.omega = omega;
    const max = step * counts.length, highest = Math.max(8, ...counts), points = counts.map((count, k) => ({x: Number(((k + 1) * step).toPrecision(12)), y: count}));
    this.chart.draw({
      title: `Collisions in the window at ${counts.length} speeds up to ${number(max)} rad/s: from ${Math.min(...counts)} to ${Math.max(...counts)}`,
      x: speedAxis("speed of the driver plate", max), y: {title: "collisions in the window", min: 0, max: highest * 1.08},
      sets: [{data: points}], rules, tell: ({x, y}) => [bothUnits(x, number(x, 5)), `${plural(y, "collision")} in the window`],
      below: (group) => {
        this.bands(group, regimes, max);
        this.dashes(group, points, limit);
      },
      above: (group) => {
        const {area: {top, bottom}} = this.chart;
        this.here = addSvg(group, "g", {class: "here"});
        addSvg(this.here, "path", {d: `M0,${top - 6}V${bottom}`});
        addSvg(this.here, "path", {d: outlines.circle(0, bottom, 7), class: "knob"});
        this.point(this.omega);
      },
    });
  }

  bands(group, regimes, end) {
    const {chart} = this, {top, bottom} = chart.area;
    for (const {from, to, most} of regimes) {
      const left = chart.x(Math.min(from, end)), right = chart.x(Math.min(to, end));
      const band = addSvg(group, "rect", {class: `band ${loudness(most)}`, x: left, width: Math.max(0.5, right - left), y: top, height: bottom - top});
      addSvg(band, "title", {}, `${number(from, 4)} to ${number(to, 4)} rad/s: at most ${plural(most, "collision")} a turn in the long run`);
      if (right - left > 58) addSvg(group, "text", {class: "band-label", x: (left + right) / 2, y: top + 14, "text-anchor": "middle"}, `${number(most)} a turn`);
    }
  }

  dashes(group, points, limit) {
    const {chart} = this, {left, right} = chart.area, half = Math.max(0.45, (right - left) / points.length / 2);
    for (const [kind, chosen] of limit === undefined ? [["unknown", points]] : [["quiet", points.filter(({y}) => y <= limit)], ["loud", points.filter(({y}) => y > limit)]]) {
      addSvg(group, "path", {class: `counts ${kind}`, d: chosen.map(({x, y}) => `M${(chart.x(x) - half).toFixed(2)} ${chart.y(y).toFixed(1)}h${(2 * half).toFixed(2)}`).join("") || "M0 0"});
    }
    if (limit !== undefined) addSvg(group, "path", {class: "limit", d: `M${left},${rounded(chart.y(limit + 0.5))}H${right}`});
  }

  // Moves the mark of the present speed.
  point(omega) {
    this.omega = omega;
    this.here?.setAttribute("transform", `translate(${rounded(this.chart.x(omega))} 0)`);
  }
}
