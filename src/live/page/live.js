"use strict";

// The page: what happens when something on it changes.

const $ = (id) => document.getElementById(id);

const refuse = (reason) => {
  $("cannot").hidden = false;
  $("cannot-reason").textContent = reason;
  $("app").hidden = true;
};

const compiled = async () => {
  const packed = Uint8Array.from(atob($("module").textContent.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
};

class Page {
  constructor(module) {
    this.machine = new Machine(module);
    const plain = this.machine.readFile("the default machine", $("default-machine").textContent).numbers;
    this.state = new State(this.machine, plain);
    this.threads = Object.fromEntries(Object.entries({staircase: 400, fineRule: 0, regimes: 1500, map: 0, race: 400}).map(([name, patience]) => [name, new Thread(module, patience)]));
    this.picture = new Picture($("picture"));
    this.path = new PathChart($("path"));
    this.picture.moved = (time) => this.path.follow(time);
    this.staircase = new StaircaseChart($("staircase"), (x) => this.choose({omega: Math.min(this.state.fastest, Math.max(0.02, x))}));
    this.map = new MapChart($("map"), (x, y) => {
      const restitution = Math.min(1, Math.max(0, x));
      this.choose({restitution_lower: restitution, restitution_upper: restitution, omega: Math.min(this.state.fastest, Math.max(0.02, y))});
    });
    this.race = new Race($("race"), () => {
      this.state.seed = this.state.seed % 1000 + 1;
      this.race.shown = 0;
      this.askRace();
      this.keepLink();
    });
    this.addControls();
    this.complain(this.state.follow(location.hash));
    window.addEventListener("hashchange", () => {
      if (location.hash === this.state.link()) return;
      this.complain(this.state.follow(location.hash));
      this.refresh();
    });
    this.refresh();
  }

  addControls() {
    const {state} = this, changed = (write, control) => this.change(write, control);
    this.controls = mainControls(state, changed);
    $("main-controls").append(...this.controls.map(({row}) => row));
    this.controls.push(...allControls(state, $("all-controls"), changed));
    for (const one of this.machine.cases) {
      const shaken = one.disturbance ? `, disturbance ${one.disturbance} N` : "";
      $("case").append(element("option", {value: one.id, textContent: `${one.id}: restitution ${one.restitution}, friction ${one.friction}${shaken}`}));
    }
    $("case").append(element("option", {value: "own", textContent: "A machine of your own", disabled: true}));
    $("case").addEventListener("change", () => this.change(() => {
      state.begin($("case").value);
      this.machine.set(state.numbers);
    }));
    $("fastest").addEventListener("change", () => this.change(() => {
      const fastest = Number($("fastest").value);
      if (!(fastest >= 0.5 && fastest <= 1000)) throw new Error("the range must end within 0.5..1000 rad/s");
      state.fastest = fastest;
    }));
    $("reset").addEventListener("click", () => this.change(() => {
      state.numbers = [...state.base];
      this.machine.set(state.numbers);
    }));
    $("open").addEventListener("change", async (event) => {
      const [file] = event.target.files;
      if (!file) return;
      const text = await file.text();
      this.change(() => {
        const {numbers, notes} = this.machine.readFile(file.name, text);
        this.machine.set(numbers);
        state.beginWith(numbers);
        $("notes").textContent = [`${file.name} is shown.`, ...notes.map((note) => `${note}.`)].join(" ");
      });
      event.target.value = "";
    });
    $("save").addEventListener("click", () => {
      const url = URL.createObjectURL(new Blob([this.machine.file()], {type: "application/toml"}));
      element("a", {href: url, download: "machine.toml"}).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
    });
    $("copy").addEventListener("click", async () => {
      this.keepLink();
      try {
        await navigator.clipboard.writeText(location.href);
        $("notes").textContent = "The link is copied: it opens this page with this machine.";
      } catch {
        $("notes").textContent = `The link is in the address line: ${location.href}`;
      }
    });
  }

  complain(text) { $("complaint").textContent = text; }

  choose(changes) { this.change(() => this.state.set(changes)); }

  // Changes the state by `write`, and shows it; where that is no machine, says why and changes nothing.
  change(write, control) {
    try {
      write();
      this.complain("");
    } catch (error) {
      this.complain(`That is not possible: ${error.message}.`);
    }
    this.refresh(control);
  }

  refresh(control) {
    const {state} = this;
    this.controls.forEach((one) => one.sync(control));
    $("case").value = state.from;
    $("fastest").value = state.fastest;
    this.showMotion();
    clearTimeout(this.linking);
    this.linking = setTimeout(() => this.keepLink(), 200);
    // What does not depend on the speed that is set is computed only where something else changed.
    const key = JSON.stringify([state.numbers.filter((x, place) => place !== state.at.omega).map(String), state.fastest]);
    if (key === this.key) return this.tell();
    this.key = key;
    this.found = {};
    this.ask();
  }

  keepLink() {
    if (location.hash !== this.state.link()) history.replaceState(null, "", this.state.link());
  }

  showMotion() {
    const {state, machine} = this, omega = state.get("omega");
    try {
      this.motion = machine.simulate(omega, 400);
    } catch (error) {
      return this.complain(`That is not possible: ${error.message}.`);
    }
    const walls = {lower: state.get("wall_lower"), upper: state.get("wall_upper"), omega, phase: state.get("phase")};
    this.picture.set(this.motion, walls);
    this.path.set(this.motion, walls);
    this.staircase.point(omega);
    this.map.point(state.get("restitution_lower"), omega);
  }

  // Asks the threads for all that depends on the machine.
  ask() {
    const {state, threads} = this, {fastest} = state, numbers = [...state.numbers], key = this.key, began = performance.now();
    const claimed = state.theCase()?.threshold ?? NaN, step = fastest / 900;
    const ofNow = (use) => (answer) => { if (this.key === key) use(answer); };
    const failed = (message) => this.complain(`That is not possible: ${message}.`);
    threads.staircase.ask({question: "staircase", numbers, step, size: 900, claimed}, ({counts, rule}) => {
      this.staircase.set({counts, step, limit: rule.limit, omega: this.state.get("omega"), paper: claimed, regimes: this.found.regimes, longRun: this.found.longRun, window: rule.threshold});
      performance.measure("redraw", {start: began});
      if (this.key !== key) return;
      Object.assign(this.found, {counts, step, rule, claimed});
      this.tell();
      this.askRace();
    }, failed);
    threads.regimes.ask({question: "regimes", numbers, fastest}, ofNow(({regimes}) => {
      const louder = regimes?.findIndex(({most}) => most > 2);
      Object.assign(this.found, {regimes, hasRegimes: regimes !== null, louder, longRun: louder > 0 ? regimes[louder].from : undefined});
      this.staircase.set({regimes, longRun: this.found.longRun});
      this.tell();
      this.listRegimes();
    }), failed);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.askLater(numbers, claimed, ofNow), 350);
  }

  // What takes longer, once nothing has changed for a moment.
  askLater(numbers, claimed, ofNow) {
    const {state, threads} = this, {fastest, at} = state;
    threads.fineRule.ask({question: "fineRule", numbers, fastest, claimed}, ofNow(({rule}) => {
      this.found.fine = rule;
      this.staircase.set({window: rule.threshold, limit: rule.limit});
      this.tell();
    }), () => {});
    const shaken = state.get("disturbance") !== 0, many = shaken ? 13 : 37, width = 0.9 / (many - 1);
    const columns = Array.from({length: many}, (_, k) => Number((0.05 + k * width).toPrecision(6)));
    this.map.begin({fastest, width, cases: state.casesAround(), restitution: state.get("restitution_lower"), omega: state.get("omega")});
    const say = () => { $("map-said").textContent = this.map.columns.length < many ? `${this.map.columns.length} of ${many} restitutions are solved` : ""; };
    say();
    threads.map.ask({question: "map", numbers, columns, places: [at.restitution_lower, at.restitution_upper], fastest}, ofNow((column) => {
      if (column.regimes) this.map.add(column);
      say();
      if (!column.regimes) $("map-said").textContent = "The long run of this machine is not known.";
    }), () => {});
  }

  askRace() {
    const {state, threads, found} = this;
    if (!found.rule) return;
    const {limit} = found.rule, {fastest, seed} = state, last = found.counts.findLastIndex((count) => count <= limit);
    threads.race.ask({question: "race", numbers: [...state.numbers], seed, evaluations: 100, limit, fastest}, ({steps}) => {
      this.race.set({steps, limit, fastest, seed, best: last < 0 ? undefined : (last + 1) * found.step});
      $("race-limit").textContent = limit;
    }, () => {});
  }

  tell() {
    const {found, state, motion} = this;
    $("answer").textContent = answerOf(found, state);
    $("window-answer").textContent = windowAnswerOf(found, state);
    $("motion-answer").textContent = motionAnswerOf(motion, state);
  }

  listRegimes() {
    $("regimes").replaceChildren(...(this.found.regimes ?? []).map((regime) => {
      const {from, to, least, most, energy, fastest, rest, ends, certain} = regime;
      const texts = [shown(from, 4), shown(to, 4), least === most ? shown(most) : `${shown(least)} to ${shown(most)}`, shown(energy * 1000), shown(fastest * 1000), `${Math.round(100 * rest)} %`, ends, certain ? "yes" : "no"];
      return element("tr", {}, ...texts.map((textContent, k) => element(k ? "td" : "th", {textContent, className: k === 6 ? "left" : "right", ...(k ? {} : {scope: "row"})})));
    }));
  }
}

const begin = async () => {
  if (typeof WebAssembly !== "object") return refuse("This browser does not run WebAssembly, or it is switched off.");
  if (typeof DecompressionStream !== "function" || typeof Worker !== "function") return refuse("This browser is too old for it.");
  try {
    window.page = new Page(await compiled());
    document.documentElement.dataset.ready = "yes";
  } catch (error) {
    refuse(`The simulator does not start: ${error.message}.`);
    throw error;
  }
};
begin();
