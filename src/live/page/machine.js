"use strict";

// The simulator: one machine in WebAssembly. An input that it refuses, and every other exception of
// C++, is an Error here; the machine is as before then.
class Machine {
  constructor(module) {
    this.module = module;
    this.numbers = null;  // of the machine, one for each of the fields
    this.begin();
    const listed = this.call("fields");
    this.fields = listed.text.trimEnd().split("\n").map((line, place) => {
      const [table, key, unit, remark, range, choices, required] = line.split("\t");
      return {place, table, key, unit, remark, range, choices: choices ? choices.split("|") : null, required: required === "required", usual: listed.numbers[place]};
    });
    const {numbers, text} = this.call("cases");
    this.cases = text.trimEnd().split("\n").map((id, k) => {
      const [restitution, friction, disturbance, threshold, quiet] = numbers.slice(5 * k, 5 * k + 5);
      return {id, restitution, friction, disturbance, threshold, quiet};
    });
  }

  begin() {
    this.calls = new WebAssembly.Instance(this.module, {wasi_snapshot_preview1: nowhere}).exports;
    this.calls._initialize();
  }

  textAt(at, size) { return new TextDecoder().decode(new Uint8Array(this.calls.memory.buffer, at, size)); }

  // Calls a function of the module. Returns what it returns, its list of numbers and its text.
  call(name, ...values) {
    try {
      const value = this.calls[name](...values), {memory, results, results_size, text, text_size} = this.calls;
      return {value, numbers: new Float64Array(memory.buffer, results(), results_size()).slice(), text: this.textAt(text(), text_size())};
    } catch (error) {
      const {failure, failure_size} = this.calls, said = this.textAt(failure(), failure_size());
      const scene = this.numbers;
      this.begin();
      if (scene) this.give(scene), this.calls.set_scene();
      throw new Error(said || `the simulation has ended: ${error.message}`);
    }
  }

  give(numbers) {
    const at = this.calls.room(numbers.length);
    new Float64Array(this.calls.memory.buffer, at, numbers.length).set(numbers);
  }

  // Gives two texts, of which the module finds the second by the first's size, which is returned.
  giveTexts(first, second) {
    const [bytes, others] = [first, second].map((text) => new TextEncoder().encode(text)), size = bytes.length + others.length;
    const at = this.calls.text_room(size), room = new Uint8Array(this.calls.memory.buffer, at, size);
    room.set(bytes);
    room.set(others, bytes.length);
    return bytes.length;
  }

  // The number [unit] of a text such as "0.9 mm"; NaN if it is none.
  quantity(text, unit) { return this.call("quantity", this.giveTexts(text, unit)).value; }

  // The numbers of a machine file, and what to know of it, a sentence each. `name` is for errors.
  readFile(name, toml) {
    const {numbers, text} = this.call("read_machine_file", this.giveTexts(name, toml));
    return {numbers: Array.from(numbers), notes: text.split("\n").filter(Boolean)};
  }

  // The machine as a file: what every command of ricochet reads by --scene.
  file() { return this.call("write_machine_file").text; }

  // The machine becomes that of these numbers, one for each of the fields.
  set(numbers) {
    this.give(numbers);
    this.call("set_scene");
    this.numbers = Array.from(numbers);
  }

  // Collisions at `size` speeds from `first` [rad/s], `step` apart.
  counts(first, step, size) { return this.call("counts", first, step, size).numbers; }

  // The motion at a speed: see simulate_at() in machine.cpp.
  simulate(omega, samples) {
    const {numbers, text} = this.call("simulate", omega, samples);
    const [count, certain, end, many] = numbers, impacts = [], path = [];
    for (let k = 4; k < 4 + 4 * many; k += 4) {
      impacts.push({time: numbers[k], upper: numbers[k + 1] === 1, speed: numbers[k + 2], counts: numbers[k + 3] === 1});
    }
    for (let k = 4 + 4 * many; k < numbers.length; k += 2) path.push([numbers[k], numbers[k + 1]]);
    return {count, certain: certain === 1, doubt: text, end, impacts, path};
  }

  // What the carrier does in the long run, over the speed; null if that is not known.
  regimes(from, to) {
    if (!this.calls.has_regimes()) return null;
    const {numbers, text} = this.call("regimes", from, to), names = text.trimEnd().split("\n");
    return names.map((ends, k) => {
      const [begin, end, mean, least, most, energy, fastest, rest, turns, certain] = numbers.slice(10 * k, 10 * k + 10);
      return {from: begin, to: end, mean, least, most, energy, fastest, rest, turns, certain: certain === 1, ends};
    });
  }

  // What moves the fastest quiet speed `omega` [rad/s] of the long run: {key, percent} for 1 % more of each, the most effective first.
  sensitivities(omega) {
    const {numbers, text} = this.call("sensitivities", omega);
    return text.split("\n").filter(Boolean).map((key, k) => ({key, percent: numbers[k]}));
  }

  // The most collisions in the window of quiet speeds, where the paper claims nothing; `border`: the fastest quiet speed.
  quietLimitBelow(border) { return this.call("quiet_limit_below", border).value; }

  // The paper's rule of a scan: counts at step, 2 step, ... rad/s. `claimed`: the paper's threshold, or NaN.
  windowRule(counts, step, stride, claimed) {
    this.give(counts);
    const [quiet, limit, threshold, loud, misclassified] = this.call("window_rule", step, stride, claimed).numbers;
    return {quiet, limit, threshold, loud, misclassified};
  }

  // The fastest speed up to `fastest` [rad/s] with a quiet count; NaN if there is none.
  raceGoal(limit, fastest) { return this.call("race_goal", limit, fastest).value; }

  // The evaluations of a solver that looks for the fastest quiet speed, by its place in Machine.racers.
  race(racer, seed, evaluations, limit, fastest) {
    const {numbers} = this.call("race", racer, seed, evaluations, limit, fastest), steps = [];
    for (let k = 0; k < numbers.length; k += 3) steps.push({omega: numbers[k], count: numbers[k + 1], value: numbers[k + 2]});
    return steps;
  }
}
Machine.racers = ["fireworks", "random search", "bisection"];

// What the module's library would write on a terminal before it gives up; there is none.
const nowhere = new Proxy({}, {get: () => () => { throw new Error("the module has given up"); }});
