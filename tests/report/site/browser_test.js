// Every page in a headless Chromium: node browser_test.js PROGRAM REPORTS FOLDER draws the reports
// of REPORTS into FOLDER by PROGRAM and looks at them. Ends with 0; 1 where something is wrong, which
// is printed; 77 where Chromium or the modules of package.json are missing and CI is not set.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {createRequire} from "node:module";
import {fileURLToPath, pathToFileURL} from "node:url";
import {chartsOf, marksOf} from "./chart_marks.js";
import {checkView} from "./view_checks.js";

const [program, reports, folder] = process.argv.slice(2);
const missing = (what) => {
  console.log(`${what} is missing: the pages are not looked at; .ci/run installs it`);
  process.exit(process.env.CI ? 1 : 77);
};
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((file) => fs.existsSync(file));
if (!chromium) missing("Chromium");
const puppeteer = await import("puppeteer-core").catch(() => missing("puppeteer-core"));
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const wrong = [];
const check = (holds, what) => { if (!holds) wrong.push(what); };
const started = Date.now();

fs.rmSync(folder, {recursive: true, force: true});
execFileSync(program, ["site", reports, "--out", folder]);
// The live page has a test of its own, in tests/live.
const pages = fs.readdirSync(folder, {recursive: true}).filter((name) => path.basename(name) === "index.html" && !name.startsWith("live/")).sort();
check(pages.length > 5, `only ${pages.length} pages`);

// What is committed is what its data make of it, byte for byte; tables as CSV are not committed.
let compared = 0;
for (const name of fs.readdirSync(reports, {recursive: true})) {
  const dataBeside = [".", "machine", "cite"].includes(path.dirname(name)) || fs.existsSync(path.join(reports, path.dirname(name), "data.json"));
  if (!dataBeside || !/\.(md|csv|svg)$/.test(name)) continue;
  const drawn = path.join(folder, name);
  ++compared;
  check(fs.existsSync(drawn) && fs.readFileSync(drawn).equals(fs.readFileSync(path.join(reports, name))),
        `${name} is not what ./ricochet report reports/reference draws`);
}
check(compared > 100, `only ${compared} files compared`);

const browser = await puppeteer.launch({executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"]});

const open = async (name, {width = 1440, scheme = "light", script = true} = {}) => {
  const page = await browser.newPage();
  page.on("console", (message) => check(message.type() !== "error", `${name}: console: ${message.text()}`));
  page.on("pageerror", (error) => check(false, `${name}: ${error}`));
  page.on("request", (request) => check(/^(file|data|blob):/.test(request.url()), `${name}: asks for ${request.url()}`));
  await page.setViewport({width, height: 900});
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}]);
  await page.setJavaScriptEnabled(script);
  await page.goto(pathToFileURL(path.join(folder, name)).href);
  return page;
};

// What axe-core finds; `rules`: these alone.
const audit = async (page, what, rules) => {
  const found = await page.evaluate((only) => axe.run(document, {resultTypes: ["violations"], ...(only ? {runOnly: only} : {})}), rules);
  for (const {id, nodes} of found.violations) {
    check(false, `${what}: ${id}, ${nodes.length} times: ${nodes.slice(0, 3).map((n) => `${n.html.slice(0, 120)} ${n.any.map((a) => a.message).join("; ").slice(0, 160)}`).join(" | ")}`);
  }
};

// Links lead to pages that are there, and to places in them.
const checkLinks = (name) => {
  const from = path.join(folder, name), text = fs.readFileSync(from, "utf8");
  for (const [, link] of text.matchAll(/<a [^>]*href="([^"]*)"/g)) {
    if (/^https:/.test(link)) continue;
    const [address, anchor] = link.split("#"), [file] = address.split("?");
    const target = file ? path.join(path.dirname(from), decodeURIComponent(file)) : from;
    if (!fs.existsSync(target)) check(false, `${name}: ${link} leads nowhere`);
    // What stands behind a = is a choice that a script reads.
    else if (anchor && !anchor.includes("=")) check(fs.readFileSync(target, "utf8").includes(`id="${anchor}"`), `${name}: ${link}: no such place`);
  }
};

// What axe-core need not go through: the rows of a long table are alike, so that the first ten stand
// for them, and of pictures it sees the title alone.
const shorten = (page) =>
  page.$$eval("tbody tr:nth-child(n + 11), figure svg > :not(title, desc)", (parts) => parts.forEach((part) => part.remove()));

const lookAt = async (name) => {
  checkLinks(name);
  const page = await open(name);
  const empty = await page.$$eval("figure svg", (all) => all.filter((svg) => !svg.querySelector("path, use, polygon, rect, circle")).length);
  check(empty === 0, `${name}: ${empty} charts are empty`);
  const untold = await page.$$eval("figure svg", (all) => all.filter((svg) => svg.getAttribute("role") !== "img" || !svg.querySelector("title, desc")).length);
  check(untold === 0, `${name}: ${untold} charts tell nothing to those who cannot see them`);
  // Every chart offers its numbers, with a row for every datum, its picture and a print of itself.
  const offers = await page.$$eval("figure:has(> svg)", (all) => all.map((figure) => ({
    name: figure.querySelector("title").textContent, buttons: figure.querySelectorAll(".chart-data button").length,
    rows: JSON.parse(figure.querySelector("script.chart-csv")?.textContent ?? '""').trim().split("\n").length - 1})));
  for (const {name: chart, buttons, rows} of offers) {
    check(buttons === 3 && rows > 0, `${name}: ${chart}: ${buttons} buttons, ${rows} rows of data`);
  }
  check(await page.$eval("nav.site a[aria-current]", (link) => link.textContent.length > 0).catch(() => false), `${name}: not in the navigation`);
  await page.setViewport({width: 400, height: 800});
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= 400, `${name}: ${wide} pixels wide on a screen of 400`);
  const lines = await page.$$eval("nav.site .words a", (all) => new Set(all.map((a) => Math.round(a.getBoundingClientRect().top))).size);
  check(lines === 1, `${name}: the words of the navigation have ${lines} lines on a screen of 400`);
  // Tables of many columns fold: every cell has its label, and nothing slides.
  const folding = await page.$$eval("table.folding", (all) => all.filter((table) => table.checkVisibility()).map((table) => ({
    slides: table.scrollWidth > table.parentElement.clientWidth + 1, text: table.textContent.trim().slice(0, 60),
    bare: [...table.querySelectorAll("td")].filter((one) => one.textContent && one.checkVisibility() && !/^"/.test(getComputedStyle(one, "::before").content)).length})));
  for (const {slides, bare, text} of folding) check(!slides && bare === 0, `${name}: on a screen of 400 a table slides (${slides}) or has ${bare} cells without a label: ${text}`);
  await page.setViewport({width: 1440, height: 900});
  await shorten(page);
  await page.evaluate(axe);
  await audit(page, name);
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "dark"}]);
  await audit(page, `${name}, dark`, ["color-contrast"]);
  await page.close();
};

// Pages of solvers, of a comparison's families and of problems are drawn from one template each: the
// largest three stand for them. Links are followed on all.
const bySize = [...pages].sort((a, b) => fs.statSync(path.join(folder, b)).size - fs.statSync(path.join(folder, a)).size);
const alike = [];
for (const kind of [/^docs\/[^/]+\/index\.html$/, /(^|\/)solvers\/[^/]+\/index\.html$/, /^comparison\/[^/]+\/index\.html$/, /^problems\/[^/]+\/index\.html$/]) {
  const ofKind = bySize.filter((name) => kind.test(name) && !alike.includes(name) && name !== "comparison/view/index.html");
  check(ofKind.length > 10, `only ${ofKind.length} pages like ${kind}`);
  alike.push(...ofKind.slice(3));
}
alike.forEach(checkLinks);

// Every datum that a chart offers has a mark in its picture, or the words below it say what is not shown.
let looked = 0, marked = 0;
for (const name of pages) for (const chart of chartsOf(fs.readFileSync(path.join(folder, name), "utf8"))) {
  const found = marksOf(chart);
  check(!found.unread, `${name}: ${chart.name}: ${found.unread}`);
  if (found.unread) continue;
  check(found.missing === 0, `${name}: ${chart.name}: no mark for ${found.missing} of ${found.data} data: ${found.of.join("; ")}`);
  check(found.clipped === 0 || /not shown/.test(chart.told), `${name}: ${chart.name}: ${found.clipped} of ${found.data} data lie outside of the axes, and it does not say so`);
  ++looked;
  marked += found.data;
}
check(looked > 250 && marked > 30_000, `only ${looked} charts with ${marked} data looked at`);

// Two at a time, the largest first.
const left = bySize.filter((name) => !alike.includes(name));
const lookAtRest = async () => { while (left.length) await lookAt(left.shift()); };
await Promise.all([lookAtRest(), lookAtRest()]);

// ---- what moves on pages ----

const visible = (page, selector) => page.$$eval(selector, (all) => all.filter((one) => one.checkVisibility()).length);
const slide = (page, selector, value) => page.$eval(selector, (slider, to) => {
  slider.value = to;
  slider.dispatchEvent(new Event("input", {bubbles: true}));
}, value);

// Of the frames one is seen, whatever the slider says, and without a script the last.
for (const name of pages.filter((file) => fs.readFileSync(path.join(folder, file), "utf8").includes('class="frames"'))) {
  const still = await open(name, {script: false}), moving = await open(name);  // clicks go to the page in front
  const groups = await moving.$$eval(".frames", (all) => all.map((frames, i) => { frames.id = `frames-${i}`; return frames.querySelectorAll("figure").length; }));
  check(await visible(moving, ".frames label") > 0, `${name}: no slider is seen`);
  check(await visible(still, ".frames label") === 0, `${name}: a slider that does nothing is seen without a script`);
  check(await visible(still, ".frames figure") === 1, `${name}: without a script there is not one frame`);
  for (const [group, frames] of groups.entries()) for (let frame = 0; frame < frames; ++frame) {
    await slide(moving, `#frames-${group} input`, frame);
    const shown = await moving.$$eval(`#frames-${group} figure`, (all) => all.map((figure) => !figure.hidden));
    check(shown.every((seen, i) => seen === (i === frame)), `${name}: frame ${frame} of ${group} is not the one that is seen`);
    const said = await moving.$eval(`#frames-${group} output`, (output) => output.textContent);
    check(await moving.$eval(`#frames-${group} figure:not([hidden])`, (figure) => figure.dataset.frame) === said, `${name}: the slider says ${said}`);
  }
  check(await visible(moving, "details figure") === 0, `${name}: a fold is open`);
  if (await moving.$("details")) {
    await moving.click("details:has(figure) > summary");
    check(await visible(moving, "details figure") > 0, `${name}: a fold does not open`);
  }
  await Promise.all([moving.close(), still.close()]);
}

// A machine's page: every combination of the sliders has the answer that its data say.
const machine = path.join(folder, "machine.toml"), advised = path.join(folder, "advice");
fs.writeFileSync(machine, execFileSync(program, ["machine", "new"]));
execFileSync(program, ["machine", "advise", machine, "--out", advised]);
// Tables of records as the records, see src/report/page_template.h.
const unpacked = (data) => {
  if (Array.isArray(data)) return data.map(unpacked);
  if (data === null || typeof data !== "object") return data;
  const {columns, rows: records} = data;
  if (Object.keys(data).length === 2 && columns && records) {
    return records.map((record) => Object.fromEntries(record.map((value, i) => [columns[i], unpacked(value)])));
  }
  return Object.fromEntries(Object.entries(data).map(([name, value]) => [name, unpacked(value)]));
};
const {explorer} = unpacked(JSON.parse(fs.readFileSync(path.join(advised, "data.json"), "utf8")));
for (const scheme of ["light", "dark"]) {
  const page = await open("advice/index.html", {scheme});
  await shorten(page);
  await page.evaluate(axe);
  await audit(page, `advice, ${scheme}`);
  await page.setViewport({width: 400, height: 800});
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= 400, `advice: ${wide} pixels wide on a screen of 400`);
  await page.close();
}
const turned = await open("advice/index.html");
const sizes = explorer.design_parameters.map(({levels}) => levels.length), answered = () => turned.$eval(".explorer .answer", (p) => p.textContent);
check((await turned.$$(".explorer input")).length === sizes.length, "not every constant has a slider");
check((await answered()).includes(explorer.own.quiet.toFixed(3)), "the explorer does not begin with the machine's own");
const saidAt = await turned.$eval(".explorer", (block, levels, many) => {
  const sliders = [...block.querySelectorAll("input")];
  return Array.from({length: many}, (_, place) => {
    let rest = place;  // the last slider changes first
    for (let i = sliders.length - 1; i >= 0; --i) {
      sliders[i].value = rest % levels[i];
      rest = Math.floor(rest / levels[i]);
    }
    sliders[0].dispatchEvent(new Event("input"));
    return block.querySelector(".answer").textContent;
  });
}, sizes, explorer.answers.length);
for (const [place, answer] of explorer.answers.entries()) {
  const text = saidAt[place];
  check(answer.quiet === null ? /^(Loud|More)/.test(text) : text.includes(answer.quiet.toFixed(3)), `the explorer says at ${place}: ${text}`);
}
await turned.click(".explorer button");
check((await answered()).includes(explorer.own.quiet.toFixed(3)), "the explorer does not go back");
await turned.close();
const unmoved = await open("advice/index.html", {script: false});
check(await visible(unmoved, ".explorer") === 0 && await visible(unmoved, "#explorer table") === 1, "without a script the explorer has no table, or shows what does nothing");
await unmoved.close();

await checkView({open, check, unpacked, folder, program});

// ---- the front page ----

const front = "index.html";
const data = unpacked(JSON.parse(fs.readFileSync(path.join(folder, "data.json"), "utf8")));
const rows = data.comparison.entries;
check(fs.statSync(path.join(folder, front)).size <= 600_000, "the front page has more than 600 kB");

const page = await open(front);
const seconds = await page.evaluate(() => performance.getEntriesByType("navigation")[0].loadEventEnd / 1000);
await page.setViewport({width: 1280, height: 720});
const screens = await page.evaluate(() => document.documentElement.scrollHeight / innerHeight);
check(screens <= 3.75, `the front page has ${screens} screens`);
await page.setViewport({width: 1440, height: 900});

// The points of a chart, in pixels too.
const points = (id) => page.evaluate((chart) => charts[chart].marks.map(({x, y, point}) =>
  ({x, y, value: point.y, solver: point.row?.solver, inside: Number.isFinite(x) && Number.isFinite(y)})), id);
// A mark for every point, but of curves, that have none.
const inked = (id) => page.evaluate((chart) => charts[chart].svg.querySelectorAll("path[d*=a], path[d$=z]").length >= charts[chart].marks.filter(({set}) => set.radius).length &&
  (charts[chart].svg.outerHTML.match(/NaN|undefined/) ?? []).length === 0, id);
const selected = async () => ({family: Number(await page.$eval("#family", (s) => s.value)), budget: Number(await page.$eval("#budget", (s) => s.value))});
const inView = async () => {
  const {family, budget} = await selected();
  return rows.filter((row) => row.family === family && row.budget === budget);
};
const dotsOf = async (speed, accuracy) => (await inView()).filter((row) => row[speed] > 0 && row[accuracy] !== null).length;
const board = () => page.$$eval("#board tbody tr", (lines) => lines.map((line) => [...line.children].map((c) => c.textContent)));

// Labels of an axis beside each other, none over another.
const overlapping = (id) => page.$$eval(`#${id} text[fill="#444444"]`, (labels) => {
  const boxes = labels.map((label) => label.getBoundingClientRect());
  return boxes.length < 4 || boxes.some((a, i) => boxes.slice(0, i).some((b) => a.left < b.right && b.left < a.right && a.top + 2 < b.bottom && b.top + 2 < a.bottom));
});

const timed = rows.some((row) => row.evaluations !== null);
for (const id of [...(timed ? ["accuracy-chart"] : []), "motion-chart"]) check(await inked(id), `${id} is blank`);
const families = await page.$$eval("#family option", (all) => all.map((option) => option.value));
check(families.length === data.comparison.families.length, "not every family can be chosen");
for (const family of families) {
  await page.select("#family", family);
  for (const budget of await page.$$eval("#budget option", (all) => all.map((option) => option.value))) {
    await page.select("#budget", budget);
    for (const speed of ["evaluations", "seconds"]) for (const accuracy of ["solved", "error"]) {
      await page.select("#speed", speed);
      await page.select("#accuracy", accuracy);
      const drawn = await points("accuracy-chart"), expected = await dotsOf(speed, accuracy);
      check(drawn.length === expected && drawn.every((p) => p.inside),
            `${speed} and ${accuracy} of family ${family}, ${budget}: ${drawn.length} dots for ${expected} rows`);
      if (drawn.length) check(!(await overlapping("accuracy-chart")), `${speed} and ${accuracy} of family ${family}, ${budget}: labels of an axis overlap`);
    }
    check((await board()).length === (await inView()).length, `family ${family}, ${budget}: the leaderboard has not every row`);
  }
}
await page.select("#accuracy", "solved");
await page.select("#speed", "evaluations");
const plainDots = await page.evaluate(() => {
  const kept = comparison.kinds;
  comparison.kinds = {};
  drawAccuracy();
  const dots = charts["accuracy-chart"].marks.length;
  comparison.kinds = kept;
  drawAccuracy();
  return dots;
}).catch((error) => error.message);
check(plainDots === await dotsOf("evaluations", "solved"), `solvers of unknown kinds: ${plainDots} dots`);

// Filters.
await page.select("#shown", "surrogate");
check((await board()).every((line) => line[1].includes("surrogate")), "the formulation does not filter");
await page.select("#shown", "");
await page.select("#by-variables", "several");
const several = data.comparison.families.filter((family) => family.variables.most > 1).length;
check((await page.$$("#family option")).length === several, "the variables do not filter");
await page.select("#by-variables", "");
const rated = data.comparison.families.findIndex((family) => family.name !== "all");
await page.select("#family", String(rated));

// Sorting, by every column and both ways.
for (const column of await page.$$eval("#board thead button", (all) => all.map((button) => button.dataset.column))) {
  for (const once of [1, 2]) {
    await page.click(`#board button[data-column="${column}"]`);
    const direction = await page.$eval("#board th[aria-sort]", (heading) => heading.getAttribute("aria-sort"));
    const shown = (await board()).map((line) => line[1]);
    const {family, budget} = await selected();
    const values = shown.map((name) => {
      const row = rows.find((r) => r.family === family && r.budget === budget && `${r.solver}, ${r.formulation}` === name);
      return column === "solver" ? name : row[column];
    }).filter((value) => value !== null);
    const ordered = values.every((value, i) => i === 0 || (direction === "ascending" ? values[i - 1] <= value : values[i - 1] >= value));
    check(ordered, `sorted by ${column}, ${direction}, click ${once}: it is not`);
  }
}

// Downloads: what is offered is what the data say.
const offered = (id) => page.$eval(`#${id}`, (link) => decodeURIComponent(link.href.slice(link.href.indexOf(",") + 1)));
const json = JSON.parse(await offered("board-json")), csv = (await offered("board-csv")).trim().split("\n");
check(json.length === (await inView()).length && csv.length === json.length + 1, "the downloads have not every row");
for (const row of await inView()) {
  const same = json.find((r) => r.solver === row.solver && r.formulation === row.formulation);
  check(same && Object.keys(row).every((name) => name === "family" || same[name] === row[name]), `the download says otherwise of ${row.solver}`);
}

// Beside the chart the leaderboard or the curves.
const seen = (id) => page.$eval(`#${id}`, (part) => part.checkVisibility());
check(await seen("leaderboard") && !(await seen("reached")), "beside the chart there is not the leaderboard alone");
await page.click("#show-reached");
check(await seen("reached") && !(await seen("leaderboard")), "beside the chart there are not the curves alone");

// The files of a chart have a row for each of its points, and its picture in the colours of paper.
const csvRows = (id) => page.$eval(`#${id} ~ .chart-csv`, (text) => JSON.parse(text.textContent).trim().split("\n").length - 1);
for (const id of ["accuracy-chart", "curve-chart", "motion-chart", "pairs-chart"]) {
  check(await csvRows(id) === (await points(id)).length, `${id}: the CSV has ${await csvRows(id)} rows`);
  check(await inked(id), `${id}: not every point is drawn`);
}

// The legend picks curves.
const curves = (await points("curve-chart")).length;
const {family, budget} = await selected();
const expected = data.comparison.curves.filter((curve) => curve.family === family && curve.budget === budget).flatMap((curve) => curve.points).length;
check(curves > 0 && curves === expected && await inked("curve-chart"), `the curves have ${curves} points in place of ${expected}`);
await page.click("#curve-picks input");
check((await points("curve-chart")).length < curves, "a curve that is not picked is drawn");
await page.click("#curve-picks input");
check((await points("curve-chart")).length === curves, "a curve that is picked again is not drawn");

// Every scene of the motion.
for (const [index, view] of data.motion.charts.entries()) {
  await page.select("#scene", String(index));
  const drawn = await points("motion-chart");
  check(drawn.length === view.series.flatMap(({samples}) => samples).length, `${view.name}: ${drawn.length} dots`);
}

// Solver and simulation: a dot for every pair, where its data say; what is picked; the files.
const {pairs} = data;
const sum = (list) => list.reduce((a, b) => a + b, 0);
const expectPairs = async (solvers, simulations, alone, what) => {
  const drawn = await points("pairs-chart");
  const all = solvers.flatMap((solver) => simulations.map((simulation) => ({simulation,
    seconds: (solver.own + solver.evaluations * simulation.seconds) / solver.solved,
    error: Math.min(pairs.range, alone ? Math.max(simulation.error, 1e-10) : simulation.error + pairs.tolerance)})));
  const same = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(b);
  const shown = simulations.map((simulation) => all.filter((pair) => pair.simulation === simulation).reduce((a, b) => b.seconds < a.seconds ? b : a));
  check(drawn.length === shown.length && drawn.every((dot) => dot.inside), `${what}: ${drawn.length} dots for ${shown.length} simulations`);
  check(same(sum(drawn.map((dot) => Math.log(dot.value))), sum(shown.map(({error}) => Math.log(error)))), `${what}: the errors are not those of the data`);
  check(!(await overlapping("pairs-chart")), `${what}: labels of an axis overlap`);
  const within = shown.filter(({error}) => error < pairs.range);
  const fastest = within.reduce((a, b) => b.seconds < a.seconds ? b : a), best = Math.min(...within.map(({error}) => error));
  const front = await page.evaluate(() => charts["pairs-chart"].shown.sets[0].data.map(({x, y}) => ({x, y})));
  check(same(front[0].x, fastest.seconds) && same(front.at(-1).y, best), `${what}: the front is not the data's`);
  check(front.every(({x, y}, i) => i === 0 || (x >= front[i - 1].x && y < front[i - 1].y)), `${what}: the front is none`);
  const files = JSON.parse(await offered("pairs-json"));
  check(files.length === all.length && files.every((row, i) => same(row.seconds, all[i].seconds)), `${what}: the file says otherwise`);
  check((await offered("pairs-csv")).trim().split("\n").length === all.length + 1, `${what}: the CSV file has not every pair`);
  return page.$eval("#pairs-finding", (told) => told.textContent);
};
const eachPair = await expectPairs(pairs.solvers, pairs.simulations, false, "pairs");
check(eachPair.startsWith(`Of ${pairs.solvers.length * pairs.simulations.length} pairs`), `the pairs say: ${eachPair}`);
await page.select("#pair-error", "simulation");
await expectPairs(pairs.solvers, pairs.simulations, true, "simulations alone");
await page.select("#pair-error", "answer");
const lastSolver = pairs.solvers.at(-1);
await page.select("#pair-solver", lastSolver.solver);
await expectPairs([lastSolver], pairs.simulations, false, "one solver");
await page.select("#pair-solver", "");
const unpicked = pairs.simulations[0].simulation;
await page.click("#pair-picks input");
await expectPairs(pairs.solvers, pairs.simulations.filter(({simulation}) => simulation !== unpicked), false, "without a simulation");
await page.click("#pair-picks input");
await expectPairs(pairs.solvers, pairs.simulations, false, "pairs again");

// Every cell of the map leads to a page that is there.
const cells = await page.$$eval(".map td a", (links) => links.map((link) => link.href));
check(cells.length > 0, "nothing in the map of solvers and families leads anywhere");
for (const cell of new Set(cells)) {
  check(fs.existsSync(fileURLToPath(cell)), `the map leads to ${cell}, which is not there`);
}

// Hover tells numbers, a click leads to the report.
const hoverAndClick = async (id, report) => {
  const picture = await page.waitForSelector(`#${id}`);  // the way back may take its time
  await picture.scrollIntoView();
  await new Promise((resolve) => setTimeout(resolve, 300));  // until charts above have their height
  const box = await picture.boundingBox(), [dot] = await points(id);
  if (!dot) return;
  await page.mouse.move(box.x + dot.x, box.y + dot.y);
  await new Promise((resolve) => setTimeout(resolve, 100));
  const told = await page.$eval(`#${id} ~ .tip`, (tip) => tip.checkVisibility() ? tip.textContent.length : 0);
  check(told > 0, `${id}: nothing is told of the dot under the pointer`);
  await Promise.all([page.waitForNavigation({timeout: 5000}).catch(() => check(false, `${id}: a click leads nowhere`)),
                     page.mouse.click(box.x + dot.x, box.y + dot.y)]);
  const there = new RegExp(`/${report}/([^/]+/)?index\\.html`).test(page.url()) && await page.$("h1") !== null;
  check(there, `${id}: a click leads to ${page.url()}`);
  await page.goBack();
};
if (timed) await hoverAndClick("accuracy-chart", data.comparison.folder);
await hoverAndClick("motion-chart", data.motion.folder);
await hoverAndClick("pairs-chart", data.pairs.folder);
await page.close();

// The chooser: for each kind of problem the first entries that match, as the data say.
const chooserPage = await open(front);
const {situations, troubles} = data.chooser;
for (const trouble of ["plain", ...troubles.map(({perturbation}) => perturbation)]) for (const gradient of ["", "yes"]) for (const constraints of ["none", "some"]) {
  await chooserPage.select("#choose-trouble", trouble);
  await chooserPage.select("#choose-gradient", gradient);
  await chooserPage.select("#choose-constraints", constraints);
  for (const variables of [1, 4, 40]) {
    await chooserPage.$eval("#choose-variables", (field, to) => { field.value = to; field.dispatchEvent(new Event("input", {bubbles: true})); }, variables);
    const shown = await chooserPage.$$eval("#choices tbody tr", (lines) => lines.map((line) => [...line.children].map((c) => c.textContent)));
    const what = `the chooser, ${variables} variables, ${trouble}, gradient ${gradient || "no"}, constraints ${constraints}`;
    const kinds = situations.filter((one) => one.perturbation === trouble && (constraints === "none" ? one.constraints.least === 0 : one.constraints.most > 0) &&
      one.entries.some((entry) => gradient || !entry.gradient));
    const inside = kinds.filter((one) => one.variables.least <= variables && variables <= one.variables.most);
    check(kinds.length === 0 || shown.length > 0, `${what}: nothing is shown`);
    let kind = null;
    for (const [title, entry, solved] of shown) {
      if (title) kind = (inside.length ? inside : kinds).find((one) => title === (one.title ? `${one.title} (${one.family})` : one.family));
      const own = kind?.entries.find((e) => `${e.solver}, ${e.formulation}` === entry);
      check(own && (gradient || !own.gradient) && solved.startsWith(String(Math.round(100 * own.solved))), `${what}: ${title} ${entry} ${solved} is not in the data`);
    }
    if (inside.length) check(shown.filter(([title]) => title).length === new Set(inside.map((one) => one.family)).size, `${what}: not every kind of problem is shown`);
  }
}
await chooserPage.close();
const asked = await open("index.html");
await asked.goto(`${asked.url()}?variables=4&evaluations=400&trouble=noisy&gradient=yes#chooser`);
check(/^4 variables, 400 evaluations \(100 a variable\)/.test(await asked.$eval("#choice", (told) => told.textContent)), "the address does not choose");
await asked.close();

// The search finds a document and a report, without a server.
const searching = await open("docs/index.html");
await searching.type("#words", "quiet threshold");
const hits = await searching.$$eval("#found a", (links) => links.map((link) => link.href));
check(hits.length > 0 && fs.existsSync(fileURLToPath(hits[0].split("#")[0])), "the search finds nothing, or what is not there");
await searching.$eval("#words", (field) => { field.value = "zzzz"; field.dispatchEvent(new Event("input")); });
check((await searching.$$("#found a")).length === 0, "the search finds what is in no text");
await searching.close();

// What a stranger asks: a click on the question, and at most two screens below where it leads the answer.
const walks = [];
const answersTo = {
  "Which solver for 4 variables, 400 evaluations and noise?": ["#choice", /^4 variables, 400 evaluations.*: \S+, formulation \S+, solved \d+ \[/],
  "Fireworks against CMA-ES: where does it win?": ["header p", /CMA-ES 72 %.*wins in none/],
  "What if C4 had restitution 0.5 in place of 0.9?": ["#what-if tbody th", /^friction 0.4, restitution 0.5$/],
  "What are error and cost of RK45 at 1e-6?": ["#thresholds tbody th", /^odeint-dopri5$/],
  "Is the paper's 9 rad/s of C1 right?": ["#thresholds-of-every-case tbody th", /^C1$/],
  "How do I cite and repeat it?": ["#cite pre", /@software/],
  "Which solver copes with missing values?": ["#perturbations tbody th", /^nan/],
  "How fast may C3 run?": ["#thresholds-of-every-case tbody th", /^C3$/],
  "Which solver for 16 variables and 500 evaluations?": ["main p, header p", /^Found: .*the first is/],
  "What does a gradient buy?": ["#changes tbody tr", /price of a gradient/],
  "Where does Ipopt fail?": ["#map svg text", /^ipopt$/],
  "Is the planar model needed for my machine?": ["#levels p", /Both directions are needed only where/],
};
// To these the answer stands on the first screen.
const strangers = new Set(Object.keys(answersTo).slice(0, 7));
for (const [question, [selector, words]] of Object.entries(answersTo)) {
  const walk = await open(front);
  await walk.setViewport({width: 1280, height: 800});
  await walk.emulateMediaFeatures([{name: "prefers-reduced-motion", value: "reduce"}]);
  const link = await walk.evaluateHandle((text) => [...document.querySelectorAll("a")].find((a) => a.textContent === text), question);
  if (!link.asElement()) { check(false, `nobody asks: ${question}`); await walk.close(); continue; }
  const before = await link.evaluate((a) => a.getBoundingClientRect().bottom / innerHeight);
  await Promise.all([walk.waitForNavigation(), link.click()]);
  await new Promise((resolve) => setTimeout(resolve, 200));
  const after = await walk.$$eval(selector, (parts, source) => {
    const words = new RegExp(source);
    return parts.filter((part) => words.test(part.textContent.trim())).map((part) => part.getBoundingClientRect().bottom / innerHeight)[0] ?? null;
  }, words.source);
  check(after !== null, `${question} is not answered on ${walk.url()}`);
  check(before <= 2 && after <= (strangers.has(question) ? 1 : 2), `${question}: ${before.toFixed(1)} screens to the click, ${after?.toFixed(1)} after it`);
  walks.push(`${question} 1 click; screens: ${before.toFixed(1)} to it, ${after?.toFixed(1)} to the answer`);
  await walk.close();
}

// Without a script, and on paper, the pictures that stand still.
const still = await open(front, {script: false});
check(await still.$eval("#still-charts", (section) => section.checkVisibility()), "without a script there are no charts");
check(!(await still.$eval("#accuracy-chart", (chart) => chart.checkVisibility())), "without a script there are empty charts");
await still.close();
const paper = await open(front);
await paper.emulateMediaType("print");
check(await paper.$eval("#still-charts", (section) => section.checkVisibility()), "on paper there are no charts");
for (const id of ["motion-chart", "pairs-chart"]) {
  check(!(await paper.$eval(`#${id}`, (chart) => chart.checkVisibility())), "on paper there are charts that move");
}
const stands = await paper.$$eval("#still-charts svg", (all) => all.some((svg) => /front-solver-and-simulation/.test(svg.outerHTML)));
check(stands, "on paper there is no chart of solver and simulation");
await paper.close();

await browser.close();
for (const what of [...walks, ...wrong]) console.log(what);
console.log(`${pages.length} pages, ${wrong.length} complaints; the front page loads in ${seconds.toFixed(2)} s and has ${screens.toFixed(1)} screens; ${((Date.now() - started) / 1000).toFixed(0)} s`);
process.exit(wrong.length ? 1 : 0);
