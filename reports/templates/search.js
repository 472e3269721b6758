// Searches the texts that stand in the page; no server is asked.
"use strict";

const texts = JSON.parse(document.getElementById("texts").textContent);
const field = document.getElementById("words"), list = document.getElementById("found");
const most = 20;

// How well an entry has all words: a heading counts more than a text. 0 if one word is missing.
const worth = ({title, heading, text}, words) => {
  let sum = 0;
  for (const word of words) {
    const inHeading = heading.toLowerCase().includes(word), inTitle = title.toLowerCase().includes(word);
    const times = text.toLowerCase().split(word).length - 1;
    if (!inHeading && !inTitle && times === 0) return 0;
    sum += (inHeading ? 10 : 0) + (inTitle ? 3 : 0) + Math.min(times, 5);
  }
  return sum;
};

// The text around the first word.
const around = (text, words) => {
  const at = Math.max(0, Math.min(...words.map((word) => text.toLowerCase().indexOf(word)).filter((place) => place >= 0).concat(text.length)) - 60);
  return at >= text.length - 1 ? text.slice(0, 160) : (at > 0 ? "… " : "") + text.slice(at, at + 200).trim() + " …";
};

const search = () => {
  const words = field.value.toLowerCase().split(/\s+/).filter((word) => word.length > 1);
  const found = words.length === 0 ? [] : texts.map((entry) => [worth(entry, words), entry]).filter(([sum]) => sum > 0)
    .sort(([a], [b]) => b - a).map(([, entry]) => entry);
  list.replaceChildren(...found.slice(0, most).map((entry) => {
    const item = document.createElement("li"), link = document.createElement("a"), text = document.createElement("p");
    link.href = entry.page;
    link.textContent = entry.title === entry.heading ? entry.title : `${entry.title}: ${entry.heading}`;
    text.textContent = around(entry.text, words);
    item.append(link, text);
    return item;
  }));
  document.getElementById("told").textContent = words.length === 0 ? "" :
    found.length === 0 ? "Nothing found." : `${found.length} found${found.length > most ? `; the first ${most}` : ""}.`;
};

field.addEventListener("input", search);
field.form.addEventListener("submit", (event) => event.preventDefault());
field.form.hidden = false;
field.value = new URLSearchParams(location.search).get("q") ?? "";
search();
