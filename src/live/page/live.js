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
    this.changes = new Changes(this.state);
    this.found = {};
    const patience = {staircase: 400, fineRule: 0, regimes: 1500, sensitivities: 0, map: 0, race: 400};
    this.threads = Object.fromEntries(Object.entries(patience).map(([name, most]) => [name, new Thread(module, most)]));
    this.picture = new Picture($("picture"));
    this.path = new PathChart($("path"));
    this.picture.moved = (time) => this.path.follow(time);
    const speed = (x) => Math.min(this.state.fastest, Math.max(0.02, x));
    this.staircase = new StaircaseChart($("staircase"), (x) => this.choose({omega: speed(x)}, this.staircase));
    this.map = new MapChart($("map"), (x, y) => {
      const restitution = Math.min(1, Math.max(0, x));
      this.choose({restitution_lower: restitution, restitution_upper: restitution, omega: speed(y)});
    });
    this.race = new Race($("race"), () => {
      this.state.seed = this.state.seed % 1000 + 1;
      this.race.shown = 0;
      this.askRace();
      this.keepLink();
    });
    this.addControls();
    this.addHistory();
    this.complain(this.state.follow(location.hash));
    window.addEventListener("hashchange", () => {
      if (location.hash === this.state.link()) return;
      let complaint = "";
      this.change(() => { complaint = this.state.follow(location.hash); });
      this.complain(complaint);
    });
    this.refresh();
  }

  addControls() {
    const {state} = this, changed = (write, control) => this.change(write, control);
    this.controls = mainControls(state, changed);
    $("main-controls").append(...this.controls.map(({row}) => row));
    this.controls.push(...allControls(state, $("all-controls"), changed));
    for (const one of this.machine.cases) {
      const shaken = one.disturbance ? `, disturbance ${number(one.disturbance)} N` : "";
      $("case").append(element("option", {value: one.id, textContent: `${one.id}: restitution ${number(one.restitution)}, friction ${number(one.friction)}${shaken}`}));
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

  // Buttons and keys for undo and redo.
  addHistory() {
    const step = (way) => {
      this.changes[way]();
      this.complain("");
      this.refresh();
    };
    for (const way of ["undo", "redo"]) $(way).addEventListener("click", () => step(way));
    // A slider that is let go has ended its change.
    $("app").addEventListener("change", () => this.changes.end());
    document.addEventListener("keydown", (event) => {
      const {target, key} = event, way = {z: event.shiftKey ? "redo" : "undo", y: "redo"}[key.toLowerCase()];
      if (!(event.ctrlKey || event.metaKey) || event.altKey || !way) return;
      if (target.type === "text" && target.value !== target.defaultValue) return;  // the field's own undo
      event.preventDefault();
      step(way);
    });
  }

  complain(text) { $("complaint").textContent = text; }

  choose(changes, source) { this.change(() => this.state.set(changes), source); }

  // Changes the state by `write`, and shows it; where that is no machine, says why and changes nothing. `source`: see Changes.
  change(write, source) {
    try {
      this.changes.change(write, source);
      this.complain("");
    } catch (error) {
      this.complain(`That is not possible: ${error.message}.`);
    }
    this.refresh(source);
  }

  refresh(source) {
    const {state, changes} = this;
    this.controls.forEach((one) => one.sync(source));
    $("case").value = state.from;
    $("fastest").value = $("fastest").defaultValue = state.fastest;
    $("undo").disabled = changes.past.length === 0;
    $("redo").disabled = changes.future.length === 0;
    this.showMotion();
    clearTimeout(this.linking);
    this.linking = setTimeout(() => this.keepLink(), 200);
    // What does not depend on the speed that is set is computed only where something else changed.
    const key = JSON.stringify([state.numbers.filter((x, place) => place !== state.at.omega).map(String), state.fastest]);
    if (key !== this.key) {
      const {border, before} = this.found;
      this.key = key;
      this.found = {before: border ? bothUnits(quietBelow(border)) : before};
      this.ask();
    }
    this.tell();
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
    threads.sensitivities.stop();
    threads.staircase.ask({question: "staircase", numbers, step, size: 900, claimed}, (answer) => {
      if (this.key === key) this.learn({...answer, step});
      else this.staircase.set({counts: answer.counts, step, omega: state.get("omega")});  // of a slider that still moves
      performance.measure("redraw", {start: began});
    }, failed);
    threads.regimes.ask({question: "regimes", numbers, fastest}, ofNow((answer) => {
      this.learn({...answer, hasRegimes: answer.regimes !== null});
      this.listRegimes();
    }), failed);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.askLater(numbers, claimed, ofNow), 350);
  }

  // What takes longer, once nothing has changed for a moment.
  askLater(numbers, claimed, ofNow) {
    const {state, threads} = this, {fastest, at} = state;
    this.rested = this.key;
    this.askSensitivities();
    if (state.theCase()) threads.fineRule.ask({question: "fineRule", numbers, fastest, claimed}, ofNow(({rule}) => this.learn({fine: rule})), () => {});
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

  // Once the border is known, and nothing has changed for a moment.
  askSensitivities() {
    const {found, key} = this;
    if (!found.border || found.sensitivities || this.rested !== key) return;
    this.threads.sensitivities.ask({question: "sensitivities", numbers: [...this.state.numbers], border: found.border}, ({sensitivities}) => {
      if (this.key === key) this.learn({sensitivities});
    }, () => {});
  }

  // Takes an answer about the present machine, and shows what follows from it.
  learn(answer) {
    const {found, state} = this, own = state.theCase();
    Object.assign(found, answer);
    if (own) found.limit = (found.fine ?? found.rule)?.limit;
    else if (found.hasRegimes !== undefined) found.limit = found.windowLimit ?? found.rule?.limit;
    if (found.counts) {
      const {counts, step, regimes, limit, border} = found, threshold = own && (found.fine ?? found.rule).threshold;
      const rules = [
        {x: border, label: `fastest quiet speed ${border && quietBelow(border).toFixed(3)}`, row: 0, className: "long-run"},
        {x: threshold, label: `threshold by the paper's rule ${threshold?.toFixed(found.fine ? 3 : 2)}`, row: 1, className: "window"},
        {x: own?.threshold, label: `the paper's threshold ${own && number(own.threshold)}`, row: 2, className: "paper"},
      ];
      this.staircase.set({counts, step, regimes: regimes ?? [], limit, rules, omega: state.get("omega")});
    }
    this.tell();
    this.askSensitivities();
    if (found.limit !== undefined && found.limit !== found.raced) this.askRace();
  }

  askRace() {
    const {state, threads, found, key} = this, {limit} = found, {fastest, seed} = state;
    if (limit === undefined) return;
    if (limit !== found.raced) found.goal = undefined;
    found.raced = limit;
    threads.race.ask({question: "race", numbers: [...state.numbers], seed, evaluations: 100, limit, fastest, goal: found.goal}, ({steps, goal}) => {
      if (this.key !== key || found.raced !== limit) return;
      found.goal = goal;
      this.race.set({steps, limit, fastest, goal});
      $("race-limit").textContent = plural(limit, "collision");
      this.tell();
    }, () => {});
  }

  // Says what is known; what is not yet known keeps its last words, which are pale.
  tell() {
    const {found, state, motion} = this;
    $("answer").textContent = answerOf(found, state);
    for (const [id, text] of [["moves-answer", movesOf(found, state)], ["window-answer", windowAnswerOf(found, state)]]) {
      if (text !== undefined) $(id).textContent = text;
      $(id).classList.toggle("old", text === undefined);
    }
    for (const [id, known] of [["staircase", found.counts], ["map", this.rested === this.key], ["race", found.goal !== undefined]]) $(id).classList.toggle("old", !known);
    if (!found.regimes) $("regimes").replaceChildren();
    $("motion-answer").textContent = motionAnswerOf(motion, state);
  }

  listRegimes() {
    $("regimes").replaceChildren(...(this.found.regimes ?? []).map((regime) => {
      const {from, to, least, most, energy, fastest, rest, ends, certain} = regime;
      const texts = [number(from, 4), number(to, 4), least === most ? number(most) : `${number(least)} to ${number(most)}`, number(energy * 1000), number(fastest * 1000), `${Math.round(100 * rest)} %`, ends, certain ? "yes" : "no"];
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
