"use strict";

// What computes beside the page: threads that simulate, each for the newest question put to it.

// The script of such a thread; machine.js stands before it.
const threadScript = () => {
  let machine = null;
  const scanned = (first, step, size) => {
    const counts = [];
    for (let k = 0; k < size; k += 600) counts.push(...machine.counts(first + k * step, step, Math.min(600, size - k)));
    return counts;
  };
  // Each answers by `tell`, perhaps several times.
  const answers = {
    staircase: ({step, size, claimed}, tell) => {
      const counts = scanned(step, step, size);
      tell({counts, rule: machine.windowRule(counts, step, 1, claimed)});
    },
    // As `ricochet threshold --all` does.
    fineRule: ({fastest, claimed}, tell) => {
      const step = 1e-3;
      tell({rule: machine.windowRule(scanned(step, step, Math.round(fastest / step)), step, 10, claimed)});
    },
    // With the border of two collisions a turn, and the most collisions in the window of speeds below it, if there is one.
    regimes: ({fastest}, tell) => {
      const regimes = machine.regimes(0.01, fastest), louder = regimes?.findIndex(({most}) => most > 2);
      const border = louder > 0 ? regimes[louder].from : undefined, end = louder < 0 ? fastest : border;
      tell({regimes, louder, border, windowLimit: end && machine.quietLimitBelow(end)});
    },
    sensitivities: ({border}, tell) => tell({sensitivities: machine.sensitivities(border)}),
    map: ({columns, places, fastest, numbers}, tell) => {
      for (const restitution of columns) {
        const there = [...numbers];
        for (const place of places) there[place] = restitution;
        machine.set(there);
        tell({restitution, regimes: machine.regimes(0.01, fastest)});
      }
    },
    race: ({seed, evaluations, limit, fastest, goal}, tell) => tell({
      steps: Machine.racers.map((name, racer) => machine.race(racer, seed, evaluations, limit, fastest)),
      goal: goal ?? machine.raceGoal(limit, fastest),
    }),
  };
  onmessage = ({data}) => {
    if (data.module) machine = new Machine(data.module);
    const {question, number} = data;
    try {
      machine.set(data.numbers);
      answers[question](data, (answer) => postMessage({number, answer}));
      postMessage({number, done: true});
    } catch (error) {
      postMessage({number, error: error.message});
    }
  };
};

class Thread {
  // `patience` [ms]: a question older than that is given up for a newer one.
  constructor(module, patience) {
    Object.assign(this, {module, patience, number: 0, worker: null, asked: null, waiting: null});
  }

  begin() {
    Thread.url ??= URL.createObjectURL(new Blob([document.getElementById("machine-script").textContent, `(${threadScript})();`], {type: "text/javascript"}));
    this.worker = new Worker(Thread.url);
    this.worker.onmessage = ({data}) => this.hear(data);
    this.worker.onerror = (event) => { throw new Error(`a thread has failed: ${event.message}`); };
    this.fresh = true;
  }

  // `told` is called with every answer, `failed` with a message, unless the question is given up for
  // a newer one.
  ask(question, told, failed) {
    this.waiting = {question, told, failed};
    if (!this.asked) return this.next();
    const age = performance.now() - this.asked.since;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.giveUp(), Math.max(0, this.patience - age));
  }

  giveUp() { if (this.waiting) this.stop(); }

  // Gives up what is computed, and goes on with what waits.
  stop() {
    if (!this.asked) return;
    this.worker.terminate();
    this.worker = null;
    this.next();
  }

  next() {
    clearTimeout(this.timer);
    this.asked = this.waiting;
    this.waiting = null;
    if (!this.asked) return;
    if (!this.worker) this.begin();
    this.asked.since = performance.now();
    this.worker.postMessage({...this.asked.question, number: ++this.number, module: this.fresh ? this.module : null});
    this.fresh = false;
  }

  hear({number, answer, done, error}) {
    if (number !== this.number || !this.asked) return;
    if (answer) this.asked.told(answer);
    if (error) this.asked.failed(error);
    if (done || error) this.next();
  }
}
