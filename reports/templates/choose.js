// Where a page has parts to choose from, a list selects the one that is shown; the address names it. Without
// a script, and on paper, all are shown, one after another.
"use strict";

for (const choices of document.querySelectorAll(".choices")) {
  const parts = [...choices.querySelectorAll(":scope > .choice")];
  if (parts.length < 2) continue;
  const label = document.createElement("label"), list = document.createElement("select");
  for (const part of parts) list.append(new Option(part.dataset.title, part.id));
  label.append(choices.dataset.label + " ", list);
  choices.prepend(label);
  const show = (id) => {
    list.value = id;
    for (const part of parts) part.classList.toggle("unchosen", part.id !== id);
  };
  // The part that the address names, or that holds what it names.
  const named = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const part = parts.find((one) => target && one.contains(target));
    if (part) { show(part.id); target.scrollIntoView(); }
    return part;
  };
  list.addEventListener("change", () => {
    show(list.value);
    history.replaceState(null, "", `#${list.value}`);
  });
  addEventListener("hashchange", named);
  if (!named()) show(parts[0].id);
}
