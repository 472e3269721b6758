// What tests in a headless Chromium share: a list of complaints, pages that complain, and what is looked at on every page. A
// program that imports this ends with 77, or with 1 where CI is set, if Chromium or the modules of package.json are missing.
import fs from "node:fs";
import {createRequire} from "node:module";
import {brokenWords, cutTexts, faintTexts, smallTargets, wrongNumbers} from "./page_checks.js";

export const wrong = [];
export const check = (holds, what) => { if (!holds) wrong.push(what); };
process.on("exit", () => wrong.forEach((what) => console.log(what)));  // also where the test itself ends by an error

const missing = (what) => {
  console.log(`${what} is missing: the pages are not looked at; .ci/run installs it`);
  process.exit(process.env.CI ? 1 : 77);
};
const executablePath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((file) => fs.existsSync(file)) ?? missing("Chromium");
const puppeteer = await import("puppeteer-core").catch(() => missing("puppeteer-core"));
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const browser = await puppeteer.launch({executablePath, args: ["--no-sandbox", "--disable-gpu"]});

// Of a page at an address, which complains by its name of errors and of what it asks for, but where `mayAsk`. `before` runs
// before its scripts.
export const openPage = async (address, name, mayAsk, {width = 1440, scheme = "light", motion = "no-preference", script = true, before} = {}) => {
  const page = await browser.newPage();
  page.on("console", (message) => check(message.type() !== "error", `${name}: console: ${message.text()}`));
  page.on("pageerror", (error) => check(false, `${name}: ${error}`));
  page.on("request", (request) => check(/^(data|blob):/.test(request.url()) || mayAsk(request.url()), `${name}: asks for ${request.url().slice(0, 200)}`));
  await page.setViewport({width, height: 900});
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}, {name: "prefers-reduced-motion", value: motion}]);
  await page.setJavaScriptEnabled(script);
  if (before) await page.evaluateOnNewDocument(before);
  await page.goto(address);
  return page;
};

// What axe-core finds; `rules`: these alone.
export const audit = async (page, what, rules) => {
  await page.evaluate(axe);
  const {violations} = await page.evaluate((only) => axe.run(document, {resultTypes: ["violations"], ...(only ? {runOnly: only} : {})}), rules);
  for (const {id, nodes} of violations) {
    check(false, `${what}: ${id}, ${nodes.length} times: ${nodes.slice(0, 3).map((n) => `${n.html.slice(0, 120)} ${n.any.map((a) => a.message).join("; ").slice(0, 160)}`).join(" | ")}`);
  }
};

// What a screen of this width shows badly, whatever the page.
export const checkLooks = async (page, what, checks = [smallTargets, brokenWords, cutTexts, faintTexts, wrongNumbers]) => {
  await page.$$eval("details", (all) => all.forEach((part) => { part.open = true; }));
  for (const one of checks) {
    const found = await page.evaluate(one);
    check(found.length === 0, `${what}: ${found.length} of ${one.name}: ${found.slice(0, 5).join(" | ")}`);
  }
  const lost = await page.$$eval("img", (all) => all.filter((one) => one.naturalWidth === 0).map((one) => one.src));
  check(lost.length === 0, `${what}: no picture ${lost}`);
};

export const checkWidth = async (page, what, width) => {
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check(wide <= width, `${what}: ${wide} pixels wide on a screen of ${width}`);
};

export const finish = async (summary) => {
  await browser.close();
  console.log(`${summary}; ${wrong.length} complaints`);
  process.exit(wrong.length ? 1 : 0);
};
