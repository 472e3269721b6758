"use strict";

// The machine that moves: the driver plate, and the carrier in its clearance, much magnified. Time
// runs slowly; an impact that counts lights the wall up.

const plateRadius = 62;
const walls = {lower: 70, upper: 330, half: 34};  // of the picture of the clearance; half a carrier's width

class Picture {
  constructor(root) {
    const part = (name) => root.querySelector(`[data-part="${name}"]`);
    this.parts = Object.fromEntries([...root.querySelectorAll("[data-part]")].map((one) => [one.dataset.part, one]));
    this.play = root.querySelector("#play");
    this.slide = root.querySelector("#moment");
    this.pace = root.querySelector("#pace");
    this.said = root.querySelector("#moment-said");
    this.time = 0;
    this.runs = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.play.addEventListener("click", () => this.run(!this.runs));
    this.slide.addEventListener("input", () => {
      this.run(false);
      this.time = Number(this.slide.value) / 1000 * this.motion.end;
      this.show();
    });
    this.moved = () => {};
    this.run(this.runs);
    let last = null;
    const frame = (now) => {
      if (this.runs && this.motion && last !== null) {
        const rest = 0.6 * this.slow();  // a pause at the end of the window
        this.time += Math.min(0.1, (now - last) / 1000) * this.slow();
        if (this.time > this.motion.end + rest) this.time = 0;
        this.show();
      }
      last = now;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    part("lower").setAttribute("x", walls.lower - 46);
    part("upper").setAttribute("x", walls.upper);
  }

  // Seconds of the machine in one of the page.
  slow() {
    const seconds = Number(this.pace.value);
    return seconds ? this.motion.end / seconds : 1;
  }

  run(runs) {
    this.runs = runs;
    this.play.textContent = runs ? "Pause" : "Play";
  }

  // A new motion: see Machine.simulate(). `omega` [rad/s], `phase` [rad], walls [m].
  set(motion, {omega, phase, lower, upper}) {
    const share = this.motion ? this.time / this.motion.end : 0;
    Object.assign(this, {motion, omega, phase, lower});
    this.upper = Number.isFinite(upper) ? upper : Math.max(...motion.path.map(([, x]) => x));
    this.time = Math.min(1, share) * motion.end;
    this.parts.gap.textContent = `${number(1000 * (upper - lower))} mm`;
    this.show();
  }

  // Position [m] at a time [s], between the samples around it.
  position(time) {
    const {path} = this.motion;
    let low = 0, high = path.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (path[middle][0] <= time) low = middle; else high = middle;
    }
    const [t0, x0] = path[low], [t1, x1] = path[high];
    return t1 > t0 ? x0 + (x1 - x0) * Math.min(1, Math.max(0, (time - t0) / (t1 - t0))) : x1;
  }

  show() {
    const {motion, parts} = this, time = Math.min(this.time, motion.end);
    const share = (this.position(time) - this.lower) / (this.upper - this.lower || 1);
    const place = walls.lower + walls.half + share * (walls.upper - walls.lower - 2 * walls.half);
    parts.carrier.setAttribute("transform", `translate(${place.toFixed(2)} 0)`);
    const alpha = this.omega * time + this.phase;
    parts.plate.setAttribute("transform", `rotate(${(-alpha * 180 / Math.PI).toFixed(2)})`);
    parts.foot.setAttribute("cx", plateRadius * Math.cos(alpha));
    parts.foot.setAttribute("cy", -plateRadius * Math.sin(alpha));
    const past = motion.impacts.filter((impact) => impact.time <= time), counted = past.filter(({counts}) => counts);
    // Light fades within a third of a second of the page.
    for (const [name, upper] of [["lower", false], ["upper", true]]) {
      const latest = (all) => all.findLast((impact) => impact.upper === upper);
      const light = (impact) => impact ? Math.exp(-(time - impact.time) / this.slow() / 0.25) : 0;
      const lit = light(latest(counted)), dim = light(latest(past));
      parts[name].setAttribute("class", `wall ${lit > 0.05 ? "lit" : dim > 0.05 ? "touched" : ""}`);
      parts[`${name}-burst`].setAttribute("opacity", lit > 0.05 ? lit.toFixed(2) : 0);
      const speed = parts[`${name}-speed`], impact = latest(counted);
      speed.textContent = lit > 0.05 ? `${number(impact.speed * 1000, 2)} mm/s` : "";
    }
    this.said.textContent = `${time.toFixed(3)} s of ${motion.end.toFixed(3)} s: ${counted.length} of ${motion.count} counted`;
    this.slide.value = Math.round(time / motion.end * 1000);
    this.slide.setAttribute("aria-valuetext", `${time.toFixed(3)} seconds`);
    this.moved(time);
  }
}
