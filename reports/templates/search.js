// Searches the texts that stand in the page; no server is asked. An entry of theirs has the title of a page, one of its
// headings, the address of that heading, and the text below it.
"use strict";

const most = 20;  // entries that are shown

// Words of a question that say nothing of what it asks for.
const common = new Set(("a affect an and any are as at be by can change could depend do does effect for from get has have how i if in influence is it its matter me my of on or our should so " +
  "that the their there they this to use used using was we what when where which who why will with would you your").split(" "));

const wordsOf = (query) => {
  const words = query.toLowerCase().split(/\s+/).map((word) => word.replace(/^[^\p{L}\p{N}]+|[^\p{L}\p{N}]+$/gu, "")).filter(Boolean);
  const telling = words.filter((word) => !common.has(word));
  return telling.length > 0 ? telling : words;
};

// How a word begins in all its forms: "nois" of noise, noisy and noises. Names are what they are.
const stem = (word) => {
  const short = /^\p{L}+$/u.test(word) ? word.replace(/(ies|es|s|ed|ing|y|e)$/u, "") : word;
  return short.length > 3 ? short : word;
};

// Where words begin so: "ert" is not in "certain". `whole`: where they end so, too.
const pattern = (word, whole) => new RegExp(`(?<![\\p{L}\\p{N}])${(whole ? word : stem(word)).replace(/[\\^$.*+?()[\]{}|/]/g, "\\$&")}${whole ? "(?![\\p{L}\\p{N}])" : ""}`, "giu");
const times = (text, word, whole) => (text.match(pattern(word, whole)) ?? []).length;

// How surely an entry is about a word, from 0, where it has it nowhere, to 1, where its text does; more where its heading or
// its page's title does. What a long text has counts less. Of up to three letters a word must be whole.
const worth = ({page, heading, text}, word, usual) => {
  const short = word.length <= 3, counted = times(text, word, true) + times(text, word, short);
  const inText = counted / (counted + 1 + 3 * text.length / usual);
  return inText + (times(heading, word, true) ? 3 : times(heading, word, short) ? 1.5 : 0) + (times(page, word, short) ? 0.7 : 0);
};

// The entries with all words or, of three and more, with what tells most; the best first. `has`: the most words that one has. A
// word tells the more the fewer entries have it.
const searched = (entries, query) => {
  const words = wordsOf(query), usual = entries.reduce((sum, {text}) => sum + text.length, 1) / Math.max(1, entries.length);
  const worths = entries.map((entry) => words.map((word) => worth(entry, word, usual)));
  const tells = words.map((_, i) => Math.log(1 + entries.length / (1 + worths.filter((all) => all[i] > 0).length)));
  const rated = entries.map((entry, k) => {
    const has = worths[k].filter((one) => one > 0).length, share = tells.reduce((sum, tell, i) => sum + (worths[k][i] > 0 ? tell : 0), 0) / tells.reduce((a, b) => a + b, 0);
    const isAsked = entry.heading.toLowerCase() === words.join(" ") ? 2 : 1;
    return {entry, has, sum: isAsked * share ** 2 * worths[k].reduce((sum, one, i) => sum + tells[i] * one, 0)};
  });
  const has = Math.max(0, ...rated.map((one) => one.has)), enough = words.length < 3 || has < words.length ? has : Math.ceil(words.length / 2);
  return {has, of: words.length, found: has === 0 ? [] : rated.filter((one) => one.has >= enough).sort((a, b) => b.sum - a.sum).map(({entry}) => entry)};
};

// The text around the first word that stands in it.
const around = (text, words) => {
  const places = words.map((word) => text.search(pattern(word, word.length <= 3))).filter((place) => place >= 0);
  if (places.length === 0) return text.slice(0, 160);
  const at = Math.max(0, Math.min(...places) - 60);
  return (at > 0 ? "… " : "") + text.slice(at, at + 200).trim() + (at + 200 < text.length ? " …" : "");
};

const texts = JSON.parse(document.getElementById("texts").textContent);
const field = document.getElementById("words"), list = document.getElementById("found");

const search = () => {
  const {found, has, of} = searched(texts, field.value), words = wordsOf(field.value);
  list.replaceChildren(...found.slice(0, most).map(({page, heading, address, text}) => {
    const item = document.createElement("li"), link = document.createElement("a"), told = document.createElement("p");
    link.href = address;
    link.textContent = page === heading ? page : `${page}: ${heading}`;
    told.textContent = around(text, words);
    item.append(link, told);
    return item;
  }));
  document.getElementById("told").textContent = of === 0 ? "" :
    found.length === 0 ? `No hit for “${field.value.trim()}”.` :
    `${found.length} found${has < of ? ` with ${has} of the ${of} words` : ""}${found.length > most ? `; the first ${most}` : ""}.`;
};

field.addEventListener("input", search);
field.form.addEventListener("submit", (event) => event.preventDefault());
field.form.hidden = false;
field.value = new URLSearchParams(location.search).get("q") ?? "";
search();
