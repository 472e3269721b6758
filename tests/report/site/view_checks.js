// The reader's own view of a comparison in a browser: its numbers are those of the report's tables, its link
// keeps what was chosen, and a keyboard is enough.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";

// The rows of a table of data.json as records.
export const records = ({columns, rows}) => rows.map((row) => Object.fromEntries(row.map((value, i) => [columns[i].name, value])));

// Whether a number is what the data round to so many digits.
const near = (a, rounded, digits) => Math.abs(a - rounded) <= 0.51 * 10 ** (Math.floor(Math.log10(Math.abs(rounded) || 1)) + 1 - digits);

// Numbers of contestants as the page's script has them, under what a link chooses.
const computed = (page, link) => page.evaluate((text) => {
  const complaint = choice.follow(text), {contestants, problems} = contestantsOf(table, choice);
  return {complaint, problems, contestants: contestants.map(({results, counted, ...one}) => ({...one, taken: counted.size, runs: [...counted.values()].reduce((sum, {outcomes}) => sum + outcomes.length, 0)}))};
}, String(new URLSearchParams(link)));

// The cells of the heat maps of a page that lead to runs: {link, state of the view, value in %}, and what lies where.
const linkedMaps = (html) => [...html.matchAll(/class="chart-csv">([^<]*)<\/script><script type="application\/json" class="chart-links">([^<]*)</g)].map(([, csv, links]) => {
  const {box, rows, columns} = JSON.parse(links), lines = JSON.parse(csv).trim().split("\n").slice(1);
  const cells = lines.map((line, i) => {
    const link = rows[Math.floor(i / columns.length)][1] + columns[i % columns.length][1];
    return {link, state: link.slice(link.indexOf("#") + 1), value: line.slice(line.lastIndexOf(",") + 1)};
  });
  return {box, rows, columns, cells};
});

const checkCells = async ({open, check, folder}, page) => {
  let led = 0;
  for (const name of fs.readdirSync(path.join(folder, "comparison"), {recursive: true}).filter((one) => path.basename(one) === "index.html")) {
    const from = path.join(folder, "comparison", name);
    for (const {cells} of linkedMaps(fs.readFileSync(from, "utf8"))) {
      const known = cells.filter(({value}) => value !== "");
      const target = path.join(path.dirname(from), known[0].link.split("#")[0]);
      check(target === path.join(folder, "comparison/view/index.html"), `${name}: a cell leads to ${target}`);
      const shown = await page.evaluate((states) => {
        const kept = new Map();
        return states.map((state) => {
          const complaint = choice.follow(state), of = [choice.family, choice.budget, choice.perturbation, choice.formulation].join();
          if (!kept.has(of)) kept.set(of, contestantsOf(table, choice).contestants);
          const one = kept.get(of).find((other) => other.name === choice.entry) ?? kept.get(of).find((other) => other.solver === choice.entry);
          const {cell, outcomes} = one?.results.get(choice.problem) ?? {};  // of one problem, a run that repeats another counts once
          const once = outcomes?.filter((_, run) => !cell.runs[run].repeats);
          return {complaint, share: choice.problem ? once?.filter(({reached}) => reached).length / once?.length : one?.share};
        });
      }, known.map(({state}) => state));
      for (const [i, {complaint, share}] of shown.entries()) {
        check(complaint === "" && near(100 * share, Number(known[i].value), 3), `${name}: a cell of ${known[i].value} % leads to ${known[i].state}: ${share} ${complaint}`);
        ++led;
      }
    }
  }
  check(led > 3000, `only ${led} cells lead to runs`);

  // By a pointer and by keys.
  const map = await open("comparison/index.html"), {box: [left, right, top, bottom], rows, columns} = linkedMaps(fs.readFileSync(path.join(folder, "comparison/index.html"), "utf8"))[0];
  const place = await map.$eval("figure:has(> .cell-link) > svg", (svg) => {
    svg.scrollIntoView({block: "start", behavior: "instant"});
    const {left: x, top: y, width} = svg.getBoundingClientRect();
    return {x, y, scale: width / svg.viewBox.baseVal.width};
  });
  const pointer = [place.x + place.scale * (left + (right - left) * 1.5 / columns.length), place.y + place.scale * (top + (bottom - top) * 2.5 / rows.length)];
  await map.mouse.move(...pointer);
  const title = () => map.$eval(".cell-link", (link) => link.title);
  check((await title()).startsWith(`${rows[2][0]}, ${columns[1][0]}: `), `the cell under the pointer is said to be ${await title()}`);
  check(await map.evaluate((x, y) => document.elementFromPoint(x, y).className === "cell-link", ...pointer), "the link does not lie under the pointer");
  await map.focus(".cell-link");
  for (const key of ["ArrowDown", "ArrowLeft"]) await map.keyboard.press(key);
  check((await title()).startsWith(`${rows[3][0]}, ${columns[0][0]}: `), `the keys lead to ${await title()}`);
  await Promise.all([map.waitForNavigation(), map.keyboard.press("Enter")]);
  check(await map.evaluate(() => document.activeElement.textContent).then((text) => text.startsWith(`Problems of ${rows[3][0]},`)), "Enter does not lead to the runs of a cell");
  await map.close();
};

export const checkView = async ({open, check, folder, program}) => {
  const name = "comparison/view/index.html", file = path.join(folder, name);
  check(fs.existsSync(file), "the comparison has no view of the reader's own");
  if (!fs.existsSync(file)) return;
  check(fs.statSync(file).size <= 2_000_000, "the view has more than 2 MB");
  const dataOf = (page) => JSON.parse(fs.readFileSync(path.join(folder, "comparison", page, "data.json"), "utf8"));
  const rated = records(dataOf(".").tables["speed-accuracy"]), {tables} = dataOf("view");
  const view = {families: records(tables["view-families"]).map((one) => ({...one, problems: one.problems.split(" ").map(Number)})),
    problems: records(tables["view-problems"]), entries: records(tables["view-entries"]), perturbations: records(tables["view-perturbations"]).map((one) => one.name)};
  // The parts of the families' pages, by family.
  const parts = new Map(dataOf(".").pages.flatMap((own) => dataOf(own).report === "comparison_family" ? dataOf(own).parts.families.map((part) => [part.id, part]) : []));
  const page = await open(name);
  const show = async (hash = "") => {  // anew
    await page.goto("about:blank");
    await page.goto(`file://${file}${hash}`);
  };
  const read = (selector) => page.$eval(selector, (one) => one.textContent);

  // At first: all families, each solver in its best formulations, as the table of speed and accuracy.
  const first = await computed(page, {});
  const joint = rated.filter((row) => row.family === "all");
  check(joint.length > 10 && first.contestants.filter((one) => one.complete).length === joint.length, "not as many entries take all problems as the tables say");
  const families = view.families.map((one) => one.family);
  let compared = 0, disturbed = 0;
  const compare = (rows, {contestants}, where) => {
    for (const row of rows) {
      const one = contestants.find(({name: own, solver}) => own === `${row.solver}, ${row.formulation}` || (where === "all" && solver === row.solver));
      check(one, `view of ${where}: ${row.solver}, ${row.formulation} is not there`);
      if (!one) continue;
      const fits = near(one.share, row.share, 3) && near(one.evaluations, row.evaluations, 4) && one.taken === row.problems &&
        near(one.lower, row.lower, 3) && near(one.upper, row.upper, 3);
      check(fits, `view of ${where}: ${one.name} has ${one.share} [${one.lower}, ${one.upper}], ${one.evaluations} on ${one.taken}; the table ${row.share} [${row.lower}, ${row.upper}], ${row.evaluations} on ${row.problems}`);
      ++compared;
    }
  };
  compare(joint, first, "all");
  const best = joint.reduce((a, b) => b.share > a.share || (b.share === a.share && b.evaluations < a.evaluations) ? b : a);
  check((await read("#view-answer")).startsWith(`${best.solver} solves most on ${best.problems} problems, success rate ${Math.round(100 * best.share)} %`), `the view says ${await read("#view-answer")}`);

  // Every family with its budgets, and PAR10 as the performance profiles have it.
  for (const family of families) {
    const rows = rated.filter((row) => row.family === family);
    for (const budget of new Set(rows.map((row) => row.budget))) {
      const found = await computed(page, {family, budget});
      check(found.complaint === "", `view of ${family}: ${found.complaint}`);
      const own = rows.filter((row) => row.budget === budget);
      compare(own, found, family);
      if (!own.some((row) => row.largest) || !parts.has(family)) continue;
      for (const row of records(parts.get(family).tables.profile)) {
        const one = found.contestants.find((other) => other.name === `${row.solver}, ${row.formulation}`);
        check(one && near(one.par10, row.cost, 6), `view of ${family}: PAR10 of ${row.solver} is ${one?.par10}, in the table ${row.cost}`);
      }
    }
  }
  check(compared > 300, `only ${compared} entries compared`);
  // Ranks as the families' tables have them. P(best) is a bootstrap there and here: two of 2,000 samples each, and here of
  // 10,000 draws of the instances, which weigh about as much.
  let ranked = 0, uncertain = 0, apart = 0;
  for (const family of families) {
    if (!parts.has(family)) continue;
    for (const {id, tables: own} of parts.get(family).parts.budgets) {
      const budget = Number(id), {contestants} = await computed(page, {family, budget, formulation: "all"});
      for (const row of records(own.ratings)) {
        const one = contestants.find((other) => other.name === `${row.solver}, ${row.formulation}`), has = (number) => Number.isFinite(number);
        check(has(one.rank) === has(row.rank) && (!has(row.rank) || near(one.rank, row.rank, 3)), `view of ${family}: ${one.name} has mean rank ${one.rank}, in the table ${row.rank}`);
        check(has(one.first) === has(row.best), `view of ${family}: ${one.name} has P(best) ${one.first}, in the table ${row.best}`);
        if (has(row.rank)) ++ranked;
        if (!has(row.best)) continue;
        const middle = (one.first + row.best) / 2, deviation = Math.sqrt(3 * middle * (1 - middle) / 2000);
        check(Math.abs(one.first - row.best) <= 4 * deviation + .002, `view of ${family}: P(best) of ${one.name} is ${one.first}, in the table ${row.best}`);
        if (middle < .1 || middle > .9) continue;
        ++uncertain;
        apart += Math.abs(one.first - row.best);
      }
    }
  }
  check(ranked > 1000 && uncertain > 10, `only ${ranked} mean ranks compared, ${uncertain} P(best) between 0.1 and 0.9`);
  check(apart <= .02 * uncertain, `P(best) of the view and of the tables differ by ${apart / uncertain} in the mean`);

  // Expected running times, as the pages of three solvers have them.
  for (const {id: solver, tables: own} of dataOf("solvers").parts.solvers.filter(({id}) => ["mads", "nlopt-cobyla", "bisection"].includes(id))) {
    for (const row of records(own.families).filter((one) => families.includes(one.family))) {
      const one = (await computed(page, {family: row.family})).contestants.find((other) => other.solver === solver);
      check(row.running_time === null ? Number.isNaN(one.ert) || one.ert === null : near(one.ert, row.running_time, 3), `view of ${row.family}: ERT of ${solver} is ${one.ert}, on its page ${row.running_time}`);
    }
  }

  // Under perturbations, as the page about robustness has them.
  const perturbed = records(dataOf("robustness").tables["perturbation-rates"]);
  for (const perturbation of view.perturbations) {
    for (const own of view.families.filter((_, i) => view.entries.some((entry) => entry.family === i && view.perturbations[entry.perturbation] === perturbation))) {
      const rows = perturbed.filter((row) => row[perturbation] !== undefined && row[perturbation] !== null && (own.family === row.family || own.family.startsWith(`${row.family}-`)));
      if (perturbation === "plain" || rows.length === 0) continue;
      const {contestants, complaint} = await computed(page, {family: own.family, perturbation, budget: rows[0].budget, formulation: "all"});
      for (const row of complaint === "" ? rows : []) {
        const one = contestants.find((other) => other.name === `${row.solver}, ${row.formulation}`);
        check(!one || one.runs !== row.runs || near(one.share, row[perturbation], 3), `view of ${own.family} under ${perturbation}: ${row.solver} has ${one?.share}, in the table ${row[perturbation]}`);
        if (one && one.runs === row.runs) ++disturbed;
      }
    }
  }
  const perturbations = new Set(view.entries.map((entry) => entry.perturbation)).size;
  check(disturbed >= 10 * (perturbations - 1), `only ${disturbed} entries compared under ${perturbations - 1} perturbations`);

  // With fewer evaluations and an easier target there are fewer and more successes; of a size, its problems.
  const family = "hs", whole = await computed(page, {family}), less = await computed(page, {family, most: 10});
  const easier = await computed(page, {family, target: 0}), small = await computed(page, {family, variables: 4});
  const hs = view.families.find((one) => one.family === family);
  check(small.problems === hs.problems.filter((problem) => view.problems[problem].variables === 4).length, "problems of four variables are not those of the data");
  for (const one of whole.contestants) {
    const share = ({contestants}) => contestants.find((other) => other.name === one.name)?.share;
    if (share(less) !== undefined) check(share(less) <= one.share, `${one.name} solves more with fewer evaluations`);
    if (share(easier) !== undefined) check(share(easier) >= one.share, `${one.name} reaches an easier target less often`);
  }

  await checkCells({open, check, folder}, page);

  // The charts have a step at the place of every row of numbers.
  await show();
  const steps = await page.evaluate(() => [ecdf, ratios].map(({chart: {svg, x, y}}) => {
    const corners = [...svg.querySelectorAll("path.line")].flatMap((line) => [...line.getAttribute("d").matchAll(/H([\d.]+)V([\d.]+)/g)].map(([, across, up]) => `${line.textContent} ${across} ${up}`));
    const rows = JSON.parse(svg.parentElement.querySelector("script.chart-csv").textContent).trim().split("\n").slice(1).map((row) => row.match(/^"?(.*?)"?,([^,]*),([^,]*)$/).slice(1));
    return {rows: rows.length, missing: rows.filter(([name, across, up]) => !corners.includes(`${name} ${rounded(x(across))} ${rounded(y(up))}`))};
  }));
  for (const {rows, missing} of steps) check(rows > 20 && missing.length === 0, `a chart of the view has no step for ${missing.length} of ${rows} rows: ${missing.slice(0, 3).join("; ")}`);

  // By the keyboard: choose a family, open an entry and a problem, and follow the link that this leaves.
  await show();
  await page.focus("[name=family]");
  for (const key of "top-speed") await page.keyboard.press(key);
  check(await page.$eval("[name=family]", (select) => select.value) === "top-speed", "a keyboard does not choose a family");
  await page.focus("#view-entries tbody tr:nth-child(7) input");
  const curves = await page.$$eval("#view-ecdf path.line", (all) => all.length);
  await page.keyboard.press("Space");
  check(await page.$$eval("#view-ecdf path.line", (all) => all.length) === curves + 1, "a keyboard does not draw an entry");
  check(await page.evaluate(() => document.activeElement.type === "checkbox" && document.activeElement.checked), "drawing an entry loses the focus");
  await page.focus("#view-entries tbody button");
  await page.keyboard.press("Enter");
  check(await page.evaluate(() => document.activeElement.textContent.startsWith("Problems of ")), "an entry does not open by Enter");
  await page.focus("#view-problems tbody button");
  await page.keyboard.press("Enter");
  check(await page.evaluate(() => document.activeElement.textContent.startsWith("Runs of ")), "a problem does not open by Enter");
  const seen = await page.$eval("#page-content", (main) => main.innerText), link = await page.evaluate(() => location.hash);
  check(/family=top-speed/.test(link) && /entry=/.test(link) && /problem=/.test(link), `the link keeps ${link}`);
  await show(link);
  check(await page.$eval("#page-content", (main) => main.innerText) === seen, "the link does not lead to the same view");
  await show("#family=nowhere");
  check(/family = nowhere/.test(await read("#view-complaint")), "a wrong link is not said to be wrong");

  // The commands of runs make these runs.
  await show(`#${new URLSearchParams({family: "top-speed", formulation: "all", entry: "bisection, count", problem: "top-speed/top-speed-C1"})}`);
  const commands = (await read("#view-runs pre")).split("\n").filter((one) => one.startsWith("./ricochet solve "));
  const cells = await page.$$eval("#view-runs tbody tr", (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  check(commands.length === cells.length && cells.length >= 2, `${commands.length} commands for ${cells.length} runs`);
  for (const [i, command] of commands.entries()) {
    const made = JSON.parse(execFileSync(program, [...command.split(" ").slice(1), "--format", "json"]));
    check((made.returned_solved ? "yes" : "no") === cells[i][2] && made.evaluations_to_solve === Number(cells[i][3]), `${command}: ${made.evaluations_to_solve}, in the view ${cells[i]}`);
  }
  await page.close();

  const still = await open(name, {script: false});
  check(!(await still.$eval("#view-form", (form) => form.checkVisibility())) && /needs a script/.test(await still.$eval("noscript", (one) => one.textContent)), "without a script the view says nothing");
  await still.close();
};
