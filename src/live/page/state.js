"use strict";

// What the page shows: a machine, the end of the range of speeds, and the seed of the race. A link
// keeps it: the case it began with, and every number that is another.

const speedKeys = {fastest: 18, seed: 1};

class State {
  // `cases`: the paper's; `plain`: the numbers of the machine that they share.
  constructor(machine, plain) {
    this.machine = machine;
    this.plain = plain;
    this.at = Object.fromEntries(machine.fields.map(({key, place}) => [key, place]));
    this.begin("C1");
  }

  // All that undo brings back: see Changes.
  kept() { return {from: this.from, base: this.base, numbers: this.numbers, fastest: this.fastest}; }

  // Becomes what kept() gave before.
  restore(kept) {
    this.machine.set(kept.numbers);
    Object.assign(this, kept);
  }

  caseNumbers(id) {
    const one = this.machine.cases.find((a) => a.id === id), numbers = [...this.plain];
    for (const [key, x] of [["restitution_lower", one.restitution], ["restitution_upper", one.restitution], ["friction", one.friction], ["disturbance", one.disturbance]]) numbers[this.at[key]] = x;
    numbers[this.at.omega] = Number.isNaN(one.threshold) ? 9 : one.threshold;
    return numbers;
  }

  // Begins with a case of the paper.
  begin(id) {
    this.from = id;
    this.base = this.caseNumbers(id);
    this.numbers = [...this.base];
    this.fastest ??= speedKeys.fastest;
    this.seed ??= speedKeys.seed;
  }

  // Begins with a machine of one's own.
  beginWith(numbers) {
    this.from = "own";
    this.base = [...numbers];
    this.numbers = [...numbers];
  }

  get(key) { return this.numbers[this.at[key]]; }
  baseOf(key) { return this.base[this.at[key]]; }

  // Sets numbers by their keys. Throws an Error, and changes nothing, if that is no machine.
  set(changes) {
    const numbers = [...this.numbers];
    for (const [key, x] of Object.entries(changes)) numbers[this.at[key]] = x;
    this.machine.set(numbers);
    this.numbers = numbers;
  }

  // The case of the paper that this machine is, whatever its speed; undefined if it is none.
  theCase() {
    return this.machine.cases.find(({id}) => this.caseNumbers(id).every((x, k) => k === this.at.omega || Object.is(x, this.numbers[k])));
  }

  // The cases that differ from this machine in restitution at most.
  casesAround() {
    const free = [this.at.omega, this.at.restitution_lower, this.at.restitution_upper];
    return this.machine.cases.filter(({id}) => this.caseNumbers(id).every((x, k) => free.includes(k) || Object.is(x, this.numbers[k])));
  }

  link() {
    const known = this.from === "own" ? "C1" : this.from, base = this.caseNumbers(known), link = new URLSearchParams({case: known});
    for (const {key, place} of this.machine.fields) {
      if (!Object.is(this.numbers[place], base[place])) link.set(key, String(this.numbers[place]));
    }
    for (const [key, usual] of Object.entries(speedKeys)) if (this[key] !== usual) link.set(key, String(this[key]));
    return `#${link}`;
  }

  // Takes what a link says; returns what is wrong with it, or "".
  follow(hash) {
    const link = new URLSearchParams(hash.replace(/^#/, "")), id = link.get("case") ?? "C1";
    if (!this.machine.cases.some((one) => one.id === id)) return `The link names no case of the paper: ${id}.`;
    this.begin(id);
    const changes = {};
    for (const [key, text] of link) {
      if (key === "case") continue;
      const x = Number(text);
      if (key in speedKeys) {
        if (!(x > 0 && x <= 1000)) return `The link has ${key} = ${text}.`;
        this[key] = x;
      } else if (key in this.at) changes[key] = x;
      else return `The link has ${key}, which no machine has.`;
    }
    try { this.set(changes); } catch (error) { return `The link is of no machine: ${error.message}.`; }
    return "";
  }
}

// The states before the present one and, after an undo, those after it.
class Changes {
  constructor(state) { Object.assign(this, {state, past: [], future: []}); }

  // Carries out a change of the state. Changes by one source, such as a slider that moves, are one until end() or a second of rest.
  change(write, source) {
    const {state} = this, before = state.kept(), now = performance.now(), text = (kept) => JSON.stringify([kept.from, kept.fastest, kept.numbers.map(String), kept.base.map(String)]);
    write();
    if (text(state.kept()) === text(before)) return;
    if (!source || source !== this.source || now - this.since > 1000) this.past.push(before);
    Object.assign(this, {source, since: now, future: []});
  }

  end() { this.source = null; }

  undo() { this.move(this.past, this.future); }
  redo() { this.move(this.future, this.past); }

  move(from, to) {
    if (!from.length) return;
    to.push(this.state.kept());
    this.state.restore(from.pop());
    this.end();
  }
}
