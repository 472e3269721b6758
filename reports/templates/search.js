// Searches the texts that stand in the page; no server is asked. An entry of theirs has the title of a page, one of its
// headings, the address of that heading, and the text below it.
"use strict";

const most = 20;  // entries that are shown

// Words of a question that say nothing of what it asks for.
const common = new Set(("a an and any are as at be by can could do does for from get has have how i if in is it its me my of on or our should so " +
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

// How well an entry has a word: a heading's whole word counts most, then its word that begins so, then texts; 0 if it has it
// nowhere. Of up to three letters a word must be whole.
const worth = ({page, heading, text}, word) => {
  const short = word.length <= 3, inText = times(text, word, short), inHeading = times(heading, word, short), inPage = times(page, word, short);
  return (inHeading ? times(heading, word, true) ? 1000 : 300 : 0) + (inPage ? 100 : 0) + 5 * Math.min(times(text, word, true), 5) + Math.min(inText, 5);
};

// The entries with most of the words, the best first, and how many words that is.
const searched = (entries, query) => {
  const words = wordsOf(query);
  const rated = entries.map((entry) => {
    const all = words.map((word) => worth(entry, word));
    return {entry, has: all.filter((one) => one > 0).length, sum: all.reduce((a, b) => a + b, 0)};
  });
  const most = Math.max(0, ...rated.map(({has}) => has));
  return {most, of: words.length, found: most === 0 ? [] : rated.filter(({has}) => has === most).sort((a, b) => b.sum - a.sum).map(({entry}) => entry)};
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
  const {found, most: has, of} = searched(texts, field.value), words = wordsOf(field.value);
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
