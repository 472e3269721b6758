// Every page in a headless Chromium: node browser_test.js PROGRAM REPORTS FOLDER draws the reports
// of REPORTS into FOLDER by PROGRAM and looks at them. Ends with 0; 1 where something is wrong, which
// is printed; 77 where Chromium or the modules of package.json are missing and CI is not set.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import {audit, check, checkLooks, checkWidth, finish, openPage} from "./browser.js";
import {chartsOf, marksOf} from "./chart_marks.js";
import {faintTexts} from "./page_checks.js";
import {checkView, records} from "./view_checks.js";

const [program, reports, folder] = process.argv.slice(2), started = Date.now();
fs.rmSync(folder, {recursive: true, force: true});
execFileSync(program, ["site", reports, "--out", folder]);
// The live page has a test of its own, in tests/live.
const pages = fs.readdirSync(folder, {recursive: true}).filter((name) => path.basename(name) === "index.html" && !name.startsWith("live/")).sort();
check(pages.length > 5, `only ${pages.length} pages`);

const open = (name, options) => openPage(pathToFileURL(path.join(folder, name)).href, name, (url) => /^file:/.test(url), options);

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
  await checkLooks(page, name);
  const empty = await page.$$eval("figure svg", (all) => all.filter((svg) => !svg.querySelector("path, use, polygon, rect, circle")).length);
  check(empty === 0, `${name}: ${empty} charts are empty`);
  const untold = await page.$$eval("figure svg", (all) => all.filter((svg) => svg.getAttribute("role") !== "img" || !svg.querySelector("title, desc")).length);
  check(untold === 0, `${name}: ${untold} charts tell nothing to those who cannot see them`);
  // Every chart offers its numbers, with a row for every datum, its picture and a print of itself.
  const offers = await page.$$eval("figure:has(> svg):not(:has(#machine-title))", (all) => all.map((figure) => ({
    name: figure.querySelector("title").textContent, buttons: figure.querySelectorAll(".chart-data button").length,
    rows: JSON.parse(figure.querySelector("script.chart-csv")?.textContent ?? '""').trim().split("\n").length - 1})));
  for (const {name: chart, buttons, rows} of offers) {
    check(buttons === 3 && rows > 0, `${name}: ${chart}: ${buttons} buttons, ${rows} rows of data`);
  }
  check(await page.$eval("nav.site a[aria-current]", (link) => link.textContent.length > 0).catch(() => false), `${name}: not in the navigation`);
  await page.setViewport({width: 400, height: 800});
  await checkWidth(page, name, 400);
  await checkLooks(page, `${name} on a screen of 400`);
  const lines = await page.$$eval("nav.site .words a", (all) => new Set(all.map((a) => Math.round(a.getBoundingClientRect().top))).size);
  check(lines === 1, `${name}: the words of the navigation have ${lines} lines on a screen of 400`);
  // Tables of many columns fold: every cell has its label, and nothing slides.
  const folding = await page.$$eval("table.folding", (all) => all.filter((table) => table.checkVisibility()).map((table) => ({
    slides: table.scrollWidth > table.parentElement.clientWidth + 1, text: table.textContent.trim().slice(0, 60),
    bare: [...table.querySelectorAll("td")].filter((one) => one.textContent && one.checkVisibility() && getComputedStyle(one, "::before").content.replaceAll('\\"', '"') !== `"${table.tHead.rows[0].cells[one.cellIndex].textContent} "`).length})));
  for (const {slides, bare, text} of folding) check(!slides && bare === 0, `${name}: on a screen of 400 a table slides (${slides}) or has ${bare} cells without their column's label: ${text}`);
  await page.setViewport({width: 1440, height: 900});
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "dark"}]);
  await checkLooks(page, `${name}, dark`, [faintTexts]);
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "light"}]);
  await shorten(page);
  await audit(page, name);
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "dark"}]);
  await audit(page, `${name}, dark`, ["color-contrast"]);
  await page.close();
};

// Pages of documents and of a comparison are drawn from one template each: the
// largest three stand for them. Links are followed on all.
const bySize = [...pages].sort((a, b) => fs.statSync(path.join(folder, b)).size - fs.statSync(path.join(folder, a)).size);
const alike = [];
for (const kind of [/^docs\/[^/]+\/index\.html$/, /^comparison\/[^/]+\/index\.html$/]) {
  const ofKind = bySize.filter((name) => kind.test(name) && !alike.includes(name) && name !== "comparison/view/index.html");
  check(ofKind.length > 8, `only ${ofKind.length} pages like ${kind}`);
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
check(looked > 150 && marked > 25_000, `only ${looked} charts with ${marked} data looked at`);

// Two at a time, the largest first.
const left = bySize.filter((name) => !alike.includes(name));
const lookAtRest = async () => { while (left.length) await lookAt(left.shift()); };
await Promise.all([lookAtRest(), lookAtRest()]);

// ---- what moves on pages ----

const visible = (page, selector) => page.$$eval(selector, (all) => all.filter((one) => one.checkVisibility()).length);
// A machine's page.
const machine = path.join(folder, "machine.toml"), advised = path.join(folder, "advice");
fs.writeFileSync(machine, execFileSync(program, ["machine", "new"]));
execFileSync(program, ["machine", "advise", machine, "--out", advised]);
for (const scheme of ["light", "dark"]) {
  const page = await open("advice/index.html", {scheme});
  await shorten(page);
  await audit(page, `advice, ${scheme}`);
  await page.setViewport({width: 400, height: 800});
  await checkWidth(page, "advice", 400);
  await page.close();
}

await checkView({open, check, folder, program});

// Of the parts of a page one is seen, which a list chooses and the address names; without a script all are.
let choosers = 0;
for (const name of pages.filter((file) => fs.readFileSync(path.join(folder, file), "utf8").includes('class="choices"'))) {
  const still = await open(name, {script: false}), moving = await open(name);
  const all = await still.$$eval(".choice", (parts) => parts.length);
  check(await visible(still, ".choice") === all, `${name}: without a script not every part is seen`);
  const lists = await moving.$$eval(".choices", (found) => found.map((one, i) => { one.id ||= `choices-${i}`; return {id: one.id, parts: [...one.children].filter((part) => part.classList.contains("choice")).map((part) => part.id)}; }));
  for (const {id, parts} of lists.filter((one) => one.parts.length > 1)) {
    ++choosers;
    const last = parts.at(-1);
    if (!(await moving.$eval(`#${id}`, (one) => one.checkVisibility()))) continue;  // inside a part that is not chosen
    await moving.$eval(`#${id} > label > select`, (select, to) => { select.value = to; select.dispatchEvent(new Event("change", {bubbles: true})); }, last);
    const seen = await moving.$eval(`#${id}`, (one) => [...one.children].filter((part) => part.classList.contains("choice") && part.checkVisibility()).map((part) => part.id));
    check(seen.length === 1 && seen[0] === last, `${name}: of the parts of ${id} are seen: ${seen}`);
    check(await moving.evaluate(() => location.hash) === `#${last}`, `${name}: the address does not name ${last}`);
  }
  await Promise.all([moving.close(), still.close()]);
}
check(choosers > 5, `only ${choosers} choosers`);
const ipopt = await open("comparison/solvers/index.html");
await ipopt.goto(`${ipopt.url()}#ipopt`);
check(await ipopt.$eval("#ipopt", (part) => part.checkVisibility()) && !(await ipopt.$eval("#mads", (part) => part.checkVisibility())), "an address does not choose a solver");
await ipopt.close();

// ---- the front page ----

check(fs.statSync(path.join(folder, "index.html")).size <= 600_000, "the front page has more than 600 kB");
const page = await open("index.html");
const seconds = await page.evaluate(() => performance.getEntriesByType("navigation")[0].loadEventEnd / 1000);
// What other reports found stands there as they have it.
const leaders = records(JSON.parse(fs.readFileSync(path.join(folder, "comparison/data.json"), "utf8")).tables.leaders);
const shown = await page.$$eval("#which-solver-when tbody tr", (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent.trim())));
check(shown.length === leaders.length, `the front page has ${shown.length} of ${leaders.length} families and budgets`);
for (const [i, row] of leaders.entries()) check(shown[i]?.[0] === row.family && shown[i][2] === row.first + row.tuned, `the front page says ${shown[i]}, the comparison ${row.family}: ${row.first}`);
await page.close();

// The search finds a document and a report, without a server.
const searching = await open("docs/index.html");
await searching.type("#words", "quiet threshold");
const hits = await searching.$$eval("#found a", (links) => links.map((link) => link.href));
check(hits.length > 0 && fs.existsSync(fileURLToPath(hits[0].split("#")[0])), "the search finds nothing, or what is not there");
const ask = (words) => searching.$eval("#words", (field, value) => { field.value = value; field.dispatchEvent(new Event("input")); }, words);
await ask("nlopt-cobyla");
check(await searching.$eval("#found a", (link) => link.href.endsWith("/comparison/solvers/index.html#nlopt-cobyla")), "the search does not find a solver by its name");
await ask("zzzz");
check((await searching.$$("#found a")).length === 0, "the search finds what is in no text");
check(/^No /.test(await searching.$eval("#told", (told) => told.textContent)), "the search does not say that there is no hit");
await searching.close();

await finish(`${pages.length} pages; the front page loads in ${seconds.toFixed(2)} s, all in ${((Date.now() - started) / 1000).toFixed(0)} s`);
