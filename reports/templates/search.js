// Searches the texts that stand in the page; no server is asked. An entry of theirs has the title of a page, one of its
// headings, the address of that heading, and the text below it.
"use strict";

const most = 20;  // entries that are shown

const wordsOf = (query) => query.toLowerCase().split(/\s+/).map((word) => word.replace(/^[^\p{L}\p{N}]+|[^\p{L}\p{N}]+$/gu, "")).filter(Boolean);

// Where words begin so: "ert" is not in "certain". `whole`: where they end so, too.
const pattern = (word, whole) => new RegExp(`(?<![\\p{L}\\p{N}])${word.replace(/[\\^$.*+?()[\]{}|/]/g, "\\$&")}${whole ? "(?![\\p{L}\\p{N}])" : ""}`, "giu");
const times = (text, word, whole) => (text.match(pattern(word, whole)) ?? []).length;

// How well an entry has all words: a heading that is these words counts most, then its whole word, then its word that begins
// so, then texts. 0 if one is missing. Of up to three letters a word must be whole.
const worth = ({page, heading, text}, words) => {
  let sum = heading.toLowerCase() === words.join(" ") ? 2000 : 0;
  for (const word of words) {
    const short = word.length <= 3, inText = times(text, word, short), inHeading = times(heading, word, short), inPage = times(page, word, short);
    if (inText + inHeading + inPage === 0) return 0;
    sum += (inHeading ? times(heading, word, true) ? 1000 : 300 : 0) + (inPage ? 100 : 0) + 5 * Math.min(times(text, word, true), 5) + Math.min(inText, 5);
  }
  return sum;
};

// The entries with all words, the best first.
const searched = (entries, query) => {
  const words = wordsOf(query);
  if (words.length === 0) return [];
  return entries.map((entry) => ({entry, sum: worth(entry, words)})).filter(({sum}) => sum > 0).sort((a, b) => b.sum - a.sum).map(({entry}) => entry);
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
  const found = searched(texts, field.value), words = wordsOf(field.value);
  list.replaceChildren(...found.slice(0, most).map(({page, heading, address, text}) => {
    const item = document.createElement("li"), link = document.createElement("a"), told = document.createElement("p");
    link.href = address;
    link.textContent = page === heading ? page : `${page}: ${heading}`;
    told.textContent = around(text, words);
    item.append(link, told);
    return item;
  }));
  document.getElementById("told").textContent = words.length === 0 ? "" :
    found.length === 0 ? `No hit for “${field.value.trim()}”.` : `${found.length} found${found.length > most ? `; the first ${most}` : ""}.`;
};

field.addEventListener("input", search);
field.form.addEventListener("submit", (event) => event.preventDefault());
field.form.hidden = false;
field.value = new URLSearchParams(location.search).get("q") ?? "";
search();
