// The search of the docs page, without a browser: node search_test.js. Ends with 0, or with 1 and what is wrong.
import assert from "node:assert/strict";
import fs from "node:fs";

const source = fs.readFileSync(new URL("../../../reports/templates/search.js", import.meta.url), "utf8");
const entry = (page, heading, text = "") => ({page, heading, address: `${page}/index.html#${heading}`, text});

// The page, as far as the script knows it: what it says and lists for a query.
const asked = (entries, query, fromAddress = false) => {
  let listener = () => {};
  const element = () => ({append(...parts) { this.parts = parts; }});
  const words = {value: "", form: {addEventListener: () => {}}, addEventListener: (_, call) => { listener = call; }};
  const found = {replaceChildren: (...items) => { found.items = items; }}, told = {};
  const elements = {texts: {textContent: JSON.stringify(entries)}, words, found, told};
  new Function("document", "location", source)({getElementById: (id) => elements[id], createElement: element}, {search: fromAddress ? `?q=${encodeURIComponent(query)}` : ""});
  if (!fromAddress) {
    words.value = query;
    listener();
  }
  return {told: told.textContent, hits: found.items.map(({parts: [link, text]}) => ({link: link.textContent, address: link.href, text: text.textContent}))};
};
const links = (entries, query) => asked(entries, query).hits.map(({link}) => link);

const tests = {
  "a word is found where a word begins, not inside of one": () => {
    const entries = [entry("a", "Expected running time", "The ERT is a mean."), entry("b", "Certainty", "It is certain. An expert knows."), entry("c", "Runs", "the ERTs of runs")];
    assert.deepEqual(links(entries, "ert"), ["a: Expected running time"]);
    assert.deepEqual(links(entries, "certain"), ["b: Certainty"]);
    assert.deepEqual(links(entries, "tain"), []);
  },
  "a short word is found as a whole, a longer one by its beginning": () => {
    const entries = [entry("a", "C1", ""), entry("b", "C12", ""), entry("c", "Thresholds", "")];
    assert.deepEqual(links(entries, "C1"), ["a: C1"]);
    assert.deepEqual(links(entries, "thresh"), ["c: Thresholds"]);
  },
  "a solver is found by its name, and by a part of it": () => {
    const entries = [entry("Solvers", "nlopt-cobyla", "Powell 1994"), entry("Solvers", "nlopt-bobyqa", "unlike nlopt-cobyla"), entry("Solvers", "prima-cobyla")];
    assert.deepEqual(links(entries, "nlopt-cobyla"), ["Solvers: nlopt-cobyla", "Solvers: nlopt-bobyqa"]);
    assert.deepEqual(links([entry("Solvers", "nlopt-cobyla-tuned", "as nlopt-cobyla"), ...entries], "NLopt-COBYLA")[0], "Solvers: nlopt-cobyla");
    assert.deepEqual(links(entries, "cobyla"), ["Solvers: nlopt-cobyla", "Solvers: prima-cobyla", "Solvers: nlopt-bobyqa"]);
  },
  "a heading's whole word goes before its beginning, and that before texts": () => {
    const entries = [entry("a", "x", "noise noise noise noise noise noise"), entry("Noise", "y"), entry("b", "Noises", ""), entry("c", "Noise and gaps", "")];
    assert.deepEqual(links(entries, "noise"), ["c: Noise and gaps", "b: Noises", "Noise: y", "a: x"]);
  },
  "all words must be there, in the page's title, the heading or the text": () => {
    const entries = [entry("Identify", "Steps", "the quiet threshold"), entry("Threshold", "Quiet", ""), entry("Threshold", "Loud", "")];
    assert.deepEqual(links(entries, "quiet threshold"), ["Threshold: Quiet", "Identify: Steps"]);
  },
  "words of a question that ask for nothing are left out": () => {
    const entries = [entry("a", "Noise", "a solver"), entry("b", "Is it how?", "")];
    assert.deepEqual(links(entries, "Which solver should I use with noise?"), ["a: Noise"]);
    assert.deepEqual(links(entries, "how"), ["b: Is it how?"]);
  },
  "a word is found in its other forms": () => {
    const entries = [entry("a", "Noise", ""), entry("b", "A crash", ""), entry("c", "C1", "")];
    assert.deepEqual(links(entries, "noisy"), ["a: Noise"]);
    assert.deepEqual(links(entries, "crashes"), ["b: A crash"]);
    assert.deepEqual(links(entries, "crashing"), ["b: A crash"]);
  },
  "where no entry has all words, those with most are shown, and it is said": () => {
    const entries = [entry("a", "red green", ""), entry("b", "red", ""), entry("c", "blue", "")];
    const {hits, told} = asked(entries, "red green blue");
    assert.deepEqual(hits.map(({link}) => link), ["a: red green"]);
    assert.equal(told, "1 found with 2 of the 3 words.");
  },
  "signs that mean something to a pattern are found as they are": () => {
    const entries = [entry("a", "C++ (20)", "a.b [rad/s]")];
    for (const query of ["c++", "(20)", "a.b", "[rad/s]"]) assert.equal(links(entries, query).length, 1, query);
    assert.deepEqual(links(entries, "a-b"), []);
    assert.deepEqual(links(entries, "ω"), []);
  },
  "it says when there is no hit, and nothing when nothing is asked": () => {
    assert.equal(asked([entry("a", "b")], " zzzz ").told, "No hit for “zzzz”.");
    assert.equal(asked([entry("a", "b")], "  ").told, "");
    assert.equal(asked([entry("a", "bird")], "bird").told, "1 found.");
    assert.equal(asked(Array.from({length: 30}, (_, i) => entry(`p${i}`, "bird")), "bird").told, "30 found; the first 20.");
    assert.equal(asked(Array.from({length: 30}, (_, i) => entry(`p${i}`, "bird")), "bird").hits.length, 20);
  },
  "a hit leads to its heading and shows the text around the word": () => {
    const [hit] = asked([entry("a", "b", `${"before ".repeat(30)}word${" after".repeat(60)}`)], "word", true).hits;
    assert.equal(hit.address, "a/index.html#b");
    assert.match(hit.text, /^… .*before word after.* …$/);
    assert.ok(hit.text.length < 220);
  },
};

let wrong = 0;
for (const [name, test] of Object.entries(tests)) {
  try { test(); } catch (error) { ++wrong; console.log(`${name}: ${error.message}`); }
}
console.log(`${Object.keys(tests).length} tests, ${wrong} failed`);
process.exit(wrong ? 1 : 0);
