// The live page in a headless Chromium: node page_test.mjs PROGRAM REPORTS FOLDER draws one of the
// reports of REPORTS into FOLDER by PROGRAM, which writes live/index.html beside it, and looks at
// that page. Ends with 0; 1 where something is wrong, which is printed; 77 where Chromium or the
// modules of tests/report/site are missing and CI is not set.
import {execFileSync, spawnSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import {audit, check, checkLooks, checkWidth, finish, openPage} from "../report/site/browser.js";

const [program, reports, folder] = process.argv.slice(2);
const source = path.join(path.dirname(fileURLToPath(import.meta.url)), "../..");
const ask = (...words) => JSON.parse(execFileSync(program, [...words, "--format", "json"], {encoding: "utf8"}));

fs.rmSync(folder, {recursive: true, force: true});
fs.mkdirSync(path.join(folder, "from/verification"), {recursive: true});
fs.copyFileSync(path.join(reports, "verification/data.json"), path.join(folder, "from/verification/data.json"));
execFileSync(program, ["report", path.join(folder, "from"), "--out", path.join(folder, "drawn")]);
const file = path.join(folder, "drawn/live/index.html"), address = pathToFileURL(file).href;
const size = fs.statSync(file).size;
check(size <= 425_000, `the page has ${size} bytes`);

const open = ({hash = "", ...options} = {}) => openPage(address + hash, "live", (url) => url.split("#")[0] === address, {width: 1280, ...options});
// Until all that the page computes of its machine is there; of a disturbed one the map takes a minute.
const answered = (page) => page.waitForFunction(() => {
  const {found, state} = window.page ?? {};
  return found && (found.fine || !state.theCase()) && found.hasRegimes !== undefined && (found.sensitivities || !found.border) && found.goal !== undefined;
}, {timeout: 120_000});
const settled = async (page) => {
  await answered(page);
  await page.waitForFunction(() => document.getElementById("map-said").textContent === "" && window.page.map.columns.length > 0, {timeout: 120_000});
};
const text = (page, id) => page.$eval(`#${id}`, (part) => part.textContent);
const row = (page, label) => page.evaluateHandle((name) => [...document.querySelectorAll("#main-controls .control")].find((one) => one.querySelector("label").textContent === name), label);
const fill = async (page, label, value) => {
  await (await row(page, label)).evaluate((control, given) => {
    const field = control.querySelector("input[type=text]");
    field.value = given;
    field.dispatchEvent(new Event("change"));
  }, value);
};
const numbers = (page) => page.evaluate(() => window.page.state.numbers.map(String));

// ---- what it says is what the program says ----

const paper = ask("threshold", "--all");
for (const id of ["C1", "C2", "C3", "C4", "C10"]) {
  const page = await open({hash: `#case=${id}`}), native = ask("threshold", "--case", id), ofPaper = paper.find((one) => one.case === id);
  await answered(page);
  const {border: longRun, sensitivities, fine: {threshold, loud, quiet}} = await page.evaluate(() => window.page.found);
  const border = native.regimes.find((one) => one.most_per_turn > 2).from;
  check(Math.abs(longRun - border) < 1e-6, `${id}: two a turn end at ${longRun}, by the program at ${border}`);
  const moved = Object.entries(native.percent_for_one);
  check(sensitivities.length === moved.length && sensitivities.every(({key, percent}) => Math.abs(percent - native.percent_for_one[key]) < 1e-4),
        `${id}: it is moved by ${JSON.stringify(sensitivities)}, by the program ${JSON.stringify(native.percent_for_one)}`);
  const strongest = moved.reduce((a, b) => Math.abs(b[1]) > Math.abs(a[1]) ? b : a)[0].replaceAll("_", " ");
  check((await text(page, "moves-answer")).startsWith(`What moves it most, by 1 % more of each: ${strongest} `), `${id}: ${strongest} moves it most; ${await text(page, "moves-answer")}`);
  check(Math.abs(threshold - ofPaper.threshold) < 1e-9 && Math.abs(loud - ofPaper.first_loud) < 1e-9 && quiet === ofPaper.quiet_count,
        `${id}: the paper's rule gives ${threshold}, ${loud}, ${quiet}; by the program ${ofPaper.threshold}, ${ofPaper.first_loud}, ${ofPaper.quiet_count}`);
  const both = (omega) => `${omega.toFixed(3)} rad/s (${Number((omega * 30 / Math.PI).toPrecision(4))} rpm)`;
  check((await text(page, "answer")).startsWith(`Fastest quiet speed: ${both(native.fastest_quiet)}. `), `${id}: ${await text(page, "answer")}`);
  check((await text(page, "window-answer")).includes(`the threshold is ${both(ofPaper.threshold)}: `), `${id}: ${await text(page, "window-answer")}`);
  await page.close();
}

// ---- a mark for every datum ----

const page = await open({hash: "#case=C4&omega=7"});
await settled(page);
await page.click("#race-end");
check(await text(page, "race-play") === "Race", `at its end the race offers to ${await text(page, "race-play")}`);
const marks = await page.evaluate(() => {
  const {path, staircase, map, race, motion, found} = window.page, points = (one) => [...one.getAttribute("d").matchAll(/[MLH]/g)].length;
  const many = (chart, selector) => chart.svg.querySelectorAll(selector).length;
  // What each dash of the staircase says, read from where it stands.
  const {chart} = staircase, read = new Map();
  for (const dash of chart.svg.querySelectorAll("path.counts")) {
    for (const [, x, y, width] of dash.getAttribute("d").matchAll(/M([\d.]+) ([\d.]+)h([\d.]+)/g)) {
      const {left, right, top, bottom} = chart.area, k = Math.round(((Number(x) + Number(width) / 2 - left) / (right - left)) * found.counts.length) - 1;
      read.set(k, [Math.round((bottom - Number(y)) / (bottom - top) * chart.shown.y.max), dash.classList.contains("loud")]);
    }
  }
  const misread = found.counts.filter((count, k) => read.get(k)?.[0] !== count || read.get(k)?.[1] !== (count > found.fine.limit)).length;
  return [
    ["path", points(path.chart.svg.querySelector(".path")), motion.path.length],
    ["impacts", many(path.chart, ".impact"), motion.impacts.length],
    ["impacts that count", many(path.chart, ".impact.counts"), motion.count],
    ["dashes", read.size, 900], ["dashes that are wrong", misread, 0],
    ["bands", many(chart, ".band"), found.regimes.length],
    ["rules", many(chart, "path.rule"), 3],
    ["rows of regimes", document.querySelectorAll("#regimes tr").length, found.regimes.length],
    ["cells", many(map.chart, ".cell"), map.columns.reduce((sum, {regimes}) => sum + regimes.length, 0)],
    ["columns", map.columns.length, 37],
    ["thresholds of the paper", many(map.chart, ".paper-dot"), 2],
    ["evaluations", many(race.lanes, ".try"), 300],
    ["quiet evaluations", many(race.lanes, ".try.quiet"), race.steps.flat().filter(({count}) => count <= found.fine.limit).length],
    ...race.steps.map((steps, racer) => {
      const first = steps.findIndex(({count}) => count <= found.fine.limit);
      return [`gaps of ${racer}`, points(race.gaps.svg.querySelector(`.line.gap.racer-${racer}`)), 100 - first];
    }),
  ];
});
for (const [what, drawn, data] of marks) check(drawn === data, `${what}: ${drawn} marks for ${data}`);
check(await page.$$eval("figure svg", (all) => all.every((svg) => svg.getAttribute("role") === "img" && document.getElementById(svg.getAttribute("aria-labelledby"))?.textContent)), "a chart tells nothing to those who cannot see it");

// ---- one chart for all pages ----

const axes = await page.evaluate(() => {
  const logarithmic = scaleOf({logarithmic: true, min: 0.001, max: 20}, 200, 10), even = scaleOf({min: -3, max: 104}, 40, 500);
  return {
    back: [0.001, 0.02, 3, 20].map((x) => logarithmic.inverse(logarithmic(x)) / x - 1).concat([-3, 0, 50, 104].map((x) => even.inverse(even(x)) - x)),
    decades: ticksOf({logarithmic: true, min: 0.001, max: 20}), even: ticksOf({min: 0, max: 0.7175}, 4), labels: [0.1 + 0.2, 1e-4, 2e6, 105].map(tickLabel),
    beside: ["staircase", "map", "race"].map((name) => [...(name === "race" ? window.page.race.lanes : window.page[name].chart).svg.querySelectorAll("text")].map((one) => one.textContent).includes("rpm")),
    // Where the label 100 of the rpm stands, below the speed's own labels.
    hundred: [...window.page.staircase.chart.svg.querySelectorAll("text")].filter((one) => one.textContent === "100").map((one) => [Number(one.getAttribute("x")), window.page.staircase.chart.x(100 * Math.PI / 30)])[0],
  };
});
check(axes.back.every((x) => Math.abs(x) < 1e-9), `an axis does not come back: ${axes.back}`);
check(axes.decades.join() === "0.001,0.01,0.1,1,10" && axes.even.join() === "0,0.2,0.4,0.6", `ticks are ${axes.decades} and ${axes.even}`);
check(axes.labels.join() === "0.3,1e-4,2e6,105", `labels are ${axes.labels}`);
check(axes.beside.every(Boolean), `no rpm beside rad/s: ${axes.beside}`);
check(axes.hundred && Math.abs(axes.hundred[0] - axes.hundred[1]) < 0.1, `100 rpm stand at ${axes.hundred}`);

// ---- the race has one goal, whatever the seed ----

const goals = [];
for (const seed of [1, 2, 3]) {
  const one = await open({hash: `#case=C1&seed=${seed}`, motion: "reduce"});
  await answered(one);
  goals.push(await one.evaluate(() => [window.page.found.goal, document.getElementById("race-said").textContent].join()));
  const [{steps, goal, limit}, racers] = await one.evaluate(() => [window.page.race, Machine.racers]);
  check(racers[2] === "bisection" && steps.every((all) => all.every(({omega, count}) => count > limit || omega <= goal + 1e-6)), `seed ${seed}: a racer is faster than the goal ${goal}`);
  await one.close();
}
check(new Set(goals).size === 1, `the goal of the race depends on the seed: ${goals.join("; ")}`);

// ---- keyboard, fields, link ----

const slider = await (await row(page, "Restitution")).$("input[type=range]");
await slider.focus();
const before = await numbers(page);
for (let k = 0; k < 5; ++k) await page.keyboard.press("ArrowLeft");
const after = await numbers(page);
check(before.filter((x, k) => x !== after[k]).length === 2, "the keyboard does not move both restitutions, and nothing else");
await fill(page, "Clearance", "0.9 mm");
await fill(page, "Speed", "80 rpm");
check(Math.abs(await page.evaluate(() => window.page.state.get("omega")) - 80 * Math.PI / 30) < 1e-12, "80 rpm is another speed");
const valid = await numbers(page);
await fill(page, "Friction", "-1");
check(/friction = -1/.test(await text(page, "complaint")), `of a negative friction it says: ${await text(page, "complaint")}`);
check((await numbers(page)).every((x, k) => x === valid[k]), "a negative friction changes the machine");
await fill(page, "Friction", "0.35");
check(await text(page, "complaint") === "", "it complains of what is right");
await page.evaluate(() => { window.page.key = null; window.page.found = {}; window.page.refresh(); });
await settled(page);
await new Promise((resolve) => setTimeout(resolve, 300));
const hash = await page.evaluate(() => location.hash);
const told = async (one) => [await numbers(one), await text(one, "answer"), await text(one, "window-answer"), await text(one, "motion-answer"), await one.evaluate(() => JSON.stringify(window.page.race.steps))].flat();
const again = await open({hash});
await settled(again);
const [here, there] = [await told(page), await told(again)];
check(here.every((x, k) => x === there[k]), `the link ${hash} does not keep ${here.find((x, k) => x !== there[k])}`);
await again.close();
const strange = await open({hash: "#case=C99"});
await strange.waitForFunction(() => window.page);
check(/C99/.test(await text(strange, "complaint")), "of a link to no case it says nothing");
await strange.close();

// ---- the counting limit, undo, and what is said meanwhile ----

const lever = await open({hash: "#case=C1"});
await answered(lever);
const control = await row(lever, "Counting limit");
const moved = await control.evaluate((one) => {
  const range = one.querySelector("input[type=range]"), past = window.page.changes.past.length;
  for (const place of [520, 540, 560]) {
    range.value = place;
    range.dispatchEvent(new Event("input"));
  }
  const pale = ["window-answer", "moves-answer", "staircase", "map", "race"].filter((id) => !document.getElementById(id).classList.contains("old"));
  return {answer: document.getElementById("answer").textContent, pale, steps: window.page.changes.past.length - past, unit: one.querySelector(".unit").textContent, limit: window.page.state.get("counting_limit")};
});
check(/^Fastest quiet speed: being solved … Before the change: 8\.\d+ rad\/s/.test(moved.answer), `while it solves it says: ${moved.answer}`);
check(moved.pale.length === 0, `while it solves the old ${moved.pale} look new`);
check(moved.steps === 1, `a slider that moves makes ${moved.steps} steps of undo`);
const ownLimit = await lever.evaluate(() => window.page.state.baseOf("counting_limit"));
check(moved.unit === "mm/s" && Math.abs(moved.limit / ownLimit - 10 ** 0.12) < 1e-3, `the slider sets ${moved.limit} m/s, in ${moved.unit}`);
await answered(lever);
const limited = ask("threshold", "--case", "C1", "--set", `counting_limit=${moved.limit}`);
check((await text(lever, "answer")).includes(`${limited.fastest_quiet.toFixed(3)} rad/s`), `with ${moved.limit} m/s: ${await text(lever, "answer")}, by the program ${limited.fastest_quiet}`);
// The paper has no such machine: what is its rule's is gone, and the names are the program's.
check(/^The paper has no such machine/.test(await text(lever, "window-answer")), `of a machine that the paper never saw: ${await text(lever, "window-answer")}`);
const labels = () => lever.$$eval("#staircase .rule-label", (all) => all.map((one) => one.textContent).join("; "));
check(/^fastest quiet speed [\d.]+$/.test(await labels()), `the rules are: ${await labels()}`);
const press = async (...keys) => {
  for (const key of keys.slice(0, -1)) await lever.keyboard.down(key);
  await lever.keyboard.press(keys.at(-1));
  for (const key of keys.slice(0, -1)) await lever.keyboard.up(key);
};
const limitNow = () => lever.evaluate(() => window.page.state.get("counting_limit"));
await press("Control", "z");
check(await limitNow() === ownLimit, "Ctrl+Z does not bring the counting limit back");
await answered(lever);
check(/^fastest quiet speed 8\.\d+; threshold by the paper's rule [\d.]+; the paper's threshold 9$/.test(await labels()), `the rules of C1 are: ${await labels()}`);
await press("Control", "Shift", "Z");
check(await limitNow() === moved.limit, "Ctrl+Shift+Z does not repeat the change");
await lever.click("#undo");
check(await limitNow() === ownLimit && await lever.$eval("#undo", (one) => one.disabled) && !(await lever.$eval("#redo", (one) => one.disabled)), "the button does not undo");
await fill(lever, "Clearance", "0.9");
check(await lever.evaluate(() => String(window.page.state.get("wall_upper"))) === "0.0009", "0.9 mm become another number of m");
check(await lever.$eval("#redo", (one) => one.disabled), "a change leaves what was undone");
await lever.evaluate(() => window.page.change(() => window.page.state.set({revolutions: 1, seconds: NaN})));
await answered(lever);
check(/of 1 turn after/.test(await text(lever, "window-answer")), `of one turn it says: ${await text(lever, "window-answer")}`);
check(await lever.evaluate(() => [plural(1, "turn"), plural(1.3775, "turn"), plural(0, "impact"), number(0.0009000000000000001), number(2e7)].join()) === "1 turn,1.38 turns,0 impacts,0.0009,2e7", "numbers and plurals");
await lever.close();

// ---- a redraw while one drags ----

await page.evaluate(() => performance.clearMeasures("redraw"));
for (let k = 0; k < 60; ++k) {
  await slider.evaluate((one, place) => {
    one.value = place;
    one.dispatchEvent(new Event("input"));
  }, 100 + 13 * k);
  await page.waitForFunction((many) => performance.getEntriesByName("redraw").length > many, {polling: "raf"}, k);
}
const times = await page.evaluate(() => performance.getEntriesByName("redraw").map(({duration}) => duration).sort((a, b) => a - b));
await page.close();

// ---- machine files ----

const machine = path.join(source, "examples/machine.toml"), own = await open();
await own.waitForFunction(() => window.page);
await (await own.$("#open")).uploadFile(machine);
await own.waitForFunction(() => window.page.state.from === "own");
await settled(own);
const mine = ask("threshold", "--scene", machine).regimes.find((one) => one.most_per_turn > 2).from;
check(Math.abs(await own.evaluate(() => window.page.found.border) - mine) < 1e-6, "a machine file has another answer here");
const written = path.join(folder, "written.toml");
fs.writeFileSync(written, await own.evaluate(() => window.page.machine.file()));
const native = ask("simulate", "--scene", written), counted = await own.evaluate(() => window.page.motion.count);
check(native.count === counted, `the file that it writes has ${native.count} collisions, the page ${counted}`);
const back = await own.evaluate((toml) => window.page.machine.readFile("written.toml", toml).numbers.map(String), fs.readFileSync(written, "utf8"));
check((await numbers(own)).every((x, k) => x === back[k]), "the file that it writes is another machine");
const fresh = path.join(folder, "new.toml");
fs.writeFileSync(fresh, execFileSync(program, ["machine", "new"], {encoding: "utf8"}).replace(/^friction .*$/m, "friction = { value = 0.2, plus_minus = 0.05 }"));
const noted = async (name) => {
  await (await own.$("#open")).uploadFile(name);
  await own.waitForFunction((file) => document.getElementById("notes").textContent.startsWith(file) || document.getElementById("complaint").textContent.includes(file), {}, path.basename(name));
  return [await text(own, "notes"), await text(own, "complaint")];
};
check((await noted(fresh)).join("|") === "new.toml is shown. scene.friction is uncertain in the file: taken at its value, 0.2.|", `of a new file it says: ${await noted(fresh)}`);
const broken = path.join(folder, "broken.toml"), kept = await numbers(own);
fs.writeFileSync(broken, "[scene]\nmas = 1\n[window]\nrevolutions = 1\n");
const [, complaint] = await noted(broken), {stderr} = spawnSync(program, ["machine", "check", "broken.toml"], {cwd: folder, encoding: "utf8"});
check(complaint === `That is not possible: ${stderr.trim().replace("ricochet: ", "")}.`, `of a wrong file it says: ${complaint}`);
check((await numbers(own)).every((x, k) => x === kept[k]), "a wrong file changes the machine");
await own.close();

// ---- everyone ----

for (const [scheme, width] of [["light", 1280], ["dark", 1280], ["light", 400]]) {
  const one = await open({scheme, width, hash: "#case=C2"});
  await settled(one);
  await one.click("#race-end");
  await checkLooks(one, `${scheme}, ${width}`);
  await checkWidth(one, scheme, width);
  const near = await one.$$eval("nav.site .words a", (all) => all.map((part) => part.getBoundingClientRect()).filter((box, k, boxes) => k && box.top === boxes[k - 1].top && box.left - boxes[k - 1].right < 8).length);
  check(near === 0, `${scheme}, ${width}: ${near} words of the navigation are near the one before`);
  await audit(one, `${scheme}, ${width}`);
  await one.close();
}
const still = await open({motion: "reduce"});
await settled(still);
const moments = [];
for (let k = 0; k < 2; ++k) {
  moments.push(await still.evaluate(() => window.page.picture.time));
  await new Promise((resolve) => setTimeout(resolve, 300));
}
check(moments[0] === moments[1], "it moves for those who do not want motion");
check(await still.evaluate(() => window.page.race.shown === 100), "for them the race is not at its end");
await still.close();
const none = await open({before: () => { delete window.WebAssembly; }});
await none.waitForFunction(() => !document.getElementById("cannot").hidden);
check(/WebAssembly/.test(await text(none, "cannot")) && await none.$eval("#app", (app) => !app.checkVisibility()), "without WebAssembly it does not say so");
await none.close();
const silent = await open({script: false});
check(/JavaScript/.test(await silent.$eval("noscript", (part) => part.textContent)), "without JavaScript it does not say so");
await silent.close();

await finish(`${size} bytes; a redraw of 900 speeds takes ${times[times.length >> 1].toFixed(0)} ms in the median of ${times.length}, ${times.at(-1).toFixed(0)} ms at most`);
