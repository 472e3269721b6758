// Twenty questions that no page was written for, asked as a stranger would: node questions_test.js PROGRAM REPORTS FOLDER draws
// the site of REPORTS into FOLDER by PROGRAM, searches it for the words of each question, and looks whether one of the first
// three hits leads to the page that answers it, and whether the answer of the data stands there. Ends with 0, or 1 and what is
// wrong.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {records} from "./view_checks.js";

const [program, reports, folder] = process.argv.slice(2);
const source = fs.readFileSync(new URL("../../../reports/templates/search.js", import.meta.url), "utf8");
const {searched} = new Function(`${source.slice(0, source.indexOf("const texts ="))} return {searched};`)();

const data = (report) => JSON.parse(fs.readFileSync(path.join(reports, report, "data.json"), "utf8"));
const rows = (report, table) => records(data(report).tables[table]);
const row = (report, table, is) => rows(report, table).find((one) => Object.entries(is).every(([key, value]) => one[key] === value));
const fixed = (number, digits) => number.toFixed(digits);
const exponent = (name) => {
  const value = row("reproduction", "exponents", {constant: name}).C1;
  return `${name} ${value > 0 ? "+" : ""}${fixed(value, 2)} %`;
};

// What a user asks and types, the pages that answer it, and what must stand on them.
const questions = [
  ["How fast may my machine turn before it gets loud?", "how fast can my machine run before it gets loud", ["reproduction", "machine"], () => fixed(row("reproduction", "thresholds", {case: "C1"}).quiet_up_to, 2)],
  ["What do I gain if the walls give back less?", "lower restitution faster", ["reproduction", "machine"], () => exponent("restitution")],
  ["The track is worn. How much slower must I run?", "clearance effect on speed", ["reproduction", "machine"], () => exponent("clearance")],
  ["How do I find out from which speed on an impact is a knock?", "measure counting limit", ["docs/tutorial"], () => "what you call a knock"],
  ["May I write speeds in rpm?", "rpm", ["docs/tutorial", "docs/machine-files"], () => "Every speed may be given in rpm"],
  ["What does a disturbance of 1 N cost?", "disturbance of 1 N effect", ["reproduction", "docs/paper", "machine"], () => fixed(row("reproduction", "thresholds", {case: "C9"}).quiet_up_to, 2)],
  ["How far off may the computed speed be?", "how far off is the computed speed", ["reproduction", "calibration"], () => `${fixed(100 * data("reproduction").values.quiet_error, 1)} %`],
  ["Can I use an accelerometer?", "accelerometer", ["docs/identify"], () => "Record one knock for each impact"],
  ["How do I say that my numbers are uncertain?", "uncertain numbers in a machine file", ["docs/machine-files", "docs/tutorial"], () => "plus_minus"],
  ["Which solver copes with noise?", "which solver for a noisy objective", ["comparison/robustness"], () => row("comparison/robustness", "perturbations", {perturbation: "noisy"}).best],
  ["Which problems has nobody solved?", "problems nobody solved", ["comparison"], () => rows("comparison", "silent").find(({unsolved}) => unsolved).problem],
  ["How many evaluations does bisection need?", "bisection evaluations", ["comparison/top-speed", "comparison/solvers"], () => fixed(row("comparison", "speed-accuracy", {family: "top-speed", solver: "bisection", formulation: "count"}).evaluations, 1)],
  ["Is this Ipopt an old one?", "ipopt version", ["comparison/solvers"], () => data("comparison/solvers").parts.solvers.find(({id}) => id === "ipopt").values.version],
  ["What is ERT?", "ERT", ["docs/benchmark-method", "docs/glossary", "comparison/solvers"], () => "evaluations until solved, with restarts"],
  ["What is the best known value of hs-71?", "best known value of hs-71", ["docs/benchmark-method"], () => "evaluate PROBLEM --describe"],
  ["Would the ranking be the same on other problems?", "does the order hold on other problems", ["comparison"], () => fixed(100 * row("comparison", "held-out", {family: "profile-count"}).first_stays, 0)],
  ["What happens if my solver crashes?", "my solver crashes", ["docs/benchmark-method", "docs/own-solver"], () => "solver throws, crashes, hangs"],
  ["How exactly must a constraint hold?", "constraint tolerance", ["docs/benchmark-method"], () => "1e-6"],
  ["What does a gradient cost?", "price of a gradient", ["comparison", "docs/benchmark-method"], () => "as finite differences need"],
  ["Can I write a solver in Octave?", "octave solver", ["docs/other-languages", "docs/own-solver"], () => "Octave"],
];

fs.rmSync(folder, {recursive: true, force: true});
execFileSync(program, ["site", reports, "--out", folder]);
const textOf = (page) => fs.readFileSync(path.join(folder, page, "index.html"), "utf8")
  .replace(/<(script|style)[^]*?<\/\1>/g, " ").replace(/<[^>]*>/g, " ").replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&amp;/g, "&").replace(/\s+/g, " ");
const index = JSON.parse(/<script[^>]*id="texts"[^>]*>([^]*?)<\/script>/.exec(fs.readFileSync(path.join(folder, "docs/index.html"), "utf8"))[1]);
const pageOf = ({address}) => path.posix.normalize(path.posix.join("docs", address.replace(/\/?index\.html(#.*)?$/, "")));

let wrong = 0;
for (const [question, words, pages, says] of questions) {
  const hits = searched(index, words).found.slice(0, 3), place = hits.findIndex((hit) => pages.includes(pageOf(hit))), answer = says();
  const isThere = place >= 0 && textOf(pageOf(hits[place])).includes(answer);
  if (!isThere) {
    ++wrong;
    console.log(`${question} "${words}": ${place < 0 ? `leads to ${hits.map((hit) => hit.address).join(", ") || "nothing"}` : `"${answer}" does not stand on ${pageOf(hits[place])}`}`);
  }
}
console.log(`${questions.length} questions, ${wrong} not answered`);
process.exit(wrong ? 1 : 0);
