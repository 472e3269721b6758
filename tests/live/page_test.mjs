// The live page in a headless Chromium: node page_test.mjs PROGRAM REPORTS FOLDER draws one of the
// reports of REPORTS into FOLDER by PROGRAM, which writes live/index.html beside it, and looks at
// that page. Ends with 0; 1 where something is wrong, which is printed; 77 where Chromium or the
// modules of tests/report/site are missing and CI is not set.
import {execFileSync, spawnSync} from "node:child_process";
import fs from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";

const [program, reports, folder] = process.argv.slice(2);
const source = path.join(path.dirname(fileURLToPath(import.meta.url)), "../..");
const missing = (what) => {
  console.log(`${what} is missing: the live page is not looked at; .ci/run installs it`);
  process.exit(process.env.CI ? 1 : 77);
};
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((file) => fs.existsSync(file));
if (!chromium) missing("Chromium");
const modules = createRequire(path.join(source, "tests/report/site/package.json"));
let puppeteer, axe;
try {
  puppeteer = modules("puppeteer-core");
  axe = fs.readFileSync(modules.resolve("axe-core/axe.min.js"), "utf8");
} catch {
  missing("puppeteer-core");
}

const wrong = [];
const check = (holds, what) => { if (!holds) wrong.push(what); };
const ask = (...words) => JSON.parse(execFileSync(program, [...words, "--format", "json"], {encoding: "utf8"}));

fs.rmSync(folder, {recursive: true, force: true});
fs.mkdirSync(path.join(folder, "from/stress"), {recursive: true});
fs.copyFileSync(path.join(reports, "stress/data.json"), path.join(folder, "from/stress/data.json"));
execFileSync(program, ["report", path.join(folder, "from"), "--out", path.join(folder, "drawn")]);
const file = path.join(folder, "drawn/live/index.html"), address = pathToFileURL(file).href;
const size = fs.statSync(file).size;
check(size <= 400_000, `the page has ${size} bytes`);

const browser = await puppeteer.launch({executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"]});
const open = async ({hash = "", width = 1280, scheme = "light", motion = "no-preference", script = true, before} = {}) => {
  const page = await browser.newPage();
  page.on("console", (message) => check(message.type() !== "error", `console: ${message.text()}`));
  page.on("pageerror", (error) => check(false, `${error}`));
  page.on("request", (request) => check(request.url().split("#")[0] === address || /^(blob|data):/.test(request.url()), `asks for ${request.url().slice(0, 200)}`));
  await page.setViewport({width, height: 900});
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}, {name: "prefers-reduced-motion", value: motion}]);
  await page.setJavaScriptEnabled(script);
  if (before) await page.evaluateOnNewDocument(before);
  await page.goto(address + hash);
  return page;
};
// Until all that the page computes of its machine is there; of a disturbed one the map takes a minute.
const answered = (page) => page.waitForFunction(() => {
  const {found, race} = window.page ?? {};
  return found?.fine && found.hasRegimes !== undefined && race.steps;
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
  const {longRun, threshold, loud, quiet} = await page.evaluate(() => {
    const {longRun: border, fine} = window.page.found;
    return {longRun: border, threshold: fine.threshold, loud: fine.loud, quiet: fine.quiet};
  });
  const border = native.regimes.find((one) => one.most_per_turn > 2).from;
  check(Math.abs(longRun - border) < 1e-6, `${id}: two a turn end at ${longRun}, by the program at ${border}`);
  check(Math.abs(threshold - ofPaper.threshold) < 1e-9 && Math.abs(loud - ofPaper.first_loud) < 1e-9 && quiet === ofPaper.quiet_count,
        `${id}: the paper's rule gives ${threshold}, ${loud}, ${quiet}; by the program ${ofPaper.threshold}, ${ofPaper.first_loud}, ${ofPaper.quiet_count}`);
  check((await text(page, "answer")).includes(border.toFixed(3)), `${id}: ${await text(page, "answer")}`);
  check((await text(page, "window-answer")).includes(ofPaper.threshold.toFixed(3)), `${id}: ${await text(page, "window-answer")}`);
  await page.close();
}

// ---- a mark for every datum ----

const page = await open({hash: "#case=C4&omega=7"});
await settled(page);
await page.click("#race-end");
const marks = await page.evaluate(() => {
  const {path, staircase, map, race, motion, found} = window.page, points = (one) => [...one.getAttribute("d").matchAll(/[MLH]/g)].length;
  const many = (chart, selector) => chart.svg.querySelectorAll(selector).length;
  // What each dash of the staircase says, read from where it stands.
  const {chart} = staircase, read = new Map();
  for (const dash of chart.svg.querySelectorAll("path.counts")) {
    for (const [, x, y, width] of dash.getAttribute("d").matchAll(/M([\d.]+) ([\d.]+)h([\d.]+)/g)) {
      const k = Math.round(((Number(x) + Number(width) / 2 - chart.left) / (chart.right - chart.left)) * found.counts.length) - 1;
      read.set(k, [Math.round((chart.bottom - Number(y)) / (chart.bottom - chart.top) * chart.yAxis.to), dash.classList.contains("loud")]);
    }
  }
  const misread = found.counts.filter((count, k) => read.get(k)?.[0] !== count || read.get(k)?.[1] !== (count > found.fine.limit)).length;
  return [
    ["path", points(path.chart.svg.querySelector(".path")), motion.path.length],
    ["impacts", many(path.chart, ".impact"), motion.impacts.length],
    ["impacts that count", many(path.chart, ".impact.counts"), motion.count],
    ["dashes", read.size, 900], ["dashes that are wrong", misread, 0],
    ["bands", many(chart, ".band"), found.regimes.length],
    ["rules", many(chart, "line.rule"), 3],
    ["rows of regimes", document.querySelectorAll("#regimes tr").length, found.regimes.length],
    ["cells", many(map.chart, ".cell"), map.columns.reduce((sum, {regimes}) => sum + regimes.length, 0)],
    ["columns", map.columns.length, 37],
    ["thresholds of the paper", many(map.chart, ".paper-dot"), 2],
    ["evaluations", many(race.lanes, ".try"), 300],
    ["quiet evaluations", many(race.lanes, ".try.quiet"), race.steps.flat().filter(({count}) => count <= found.fine.limit).length],
    ...race.steps.map((steps, racer) => {
      const first = steps.findIndex(({count}) => count <= found.fine.limit);
      return [`gaps of ${racer}`, points(race.gaps.svg.querySelector(`.gap.racer-${racer}`)), first < 0 ? 1 : 100 - first];
    }),
  ];
});
for (const [what, drawn, data] of marks) check(drawn === data, `${what}: ${drawn} marks for ${data}`);
check(await page.$$eval("figure svg", (all) => all.every((svg) => svg.getAttribute("role") === "img" && document.getElementById(svg.getAttribute("aria-labelledby"))?.textContent)), "a chart tells nothing to those who cannot see it");

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
await page.evaluate(() => { window.page.key = window.page.found = null; window.page.refresh(); });
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
check(Math.abs(await own.evaluate(() => window.page.found.longRun) - mine) < 1e-6, "a machine file has another answer here");
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
  await one.$$eval("details", (all) => all.forEach((part) => { part.open = true; }));
  const wide = await one.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= width, `${wide} pixels wide on a screen of ${width}`);
  await one.evaluate(axe);
  const {violations} = await one.evaluate(() => axe.run(document, {resultTypes: ["violations"]}));
  for (const {id, nodes} of violations) check(false, `axe, ${scheme}, ${width}: ${id}, ${nodes.length} times: ${nodes.slice(0, 3).map((n) => `${n.html.slice(0, 120)} ${n.any.map((a) => a.message).join("; ").slice(0, 160)}`).join(" | ")}`);
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

await browser.close();
for (const what of wrong) console.log(what);
console.log(`${size} bytes; a redraw of 900 speeds takes ${times[times.length >> 1].toFixed(0)} ms in the median of ${times.length}, ${times.at(-1).toFixed(0)} ms at most; ${wrong.length} complaints`);
process.exit(wrong.length ? 1 : 0);
