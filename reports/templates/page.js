// What moves on a page: explorers, and sliders over frames. Without it the page shows the same in
// tables and pictures that stand still.
"use strict";

for (const explorer of document.querySelectorAll(".explorer")) {
  const {values, answers} = JSON.parse(explorer.querySelector("script").textContent);
  const sliders = [...explorer.querySelectorAll("input")], own = sliders.map((slider) => slider.value);
  const show = () => {
    let place = 0;
    sliders.forEach((slider, i) => {
      const value = values[i][slider.value];
      slider.setAttribute("aria-valuetext", value);
      slider.nextElementSibling.textContent = value + (slider.value === own[i] ? " (its own)" : "");
      place = place * values[i].length + Number(slider.value);
    });
    explorer.querySelector(".answer").textContent = answers[place];
  };
  sliders.forEach((slider) => slider.addEventListener("input", show));
  explorer.querySelector("button").addEventListener("click", () => {
    sliders.forEach((slider, i) => { slider.value = own[i]; });
    show();
  });
  explorer.hidden = false;
  show();
}

for (const frames of document.querySelectorAll(".frames")) {
  const figures = [...frames.querySelectorAll("figure")], slider = frames.querySelector("input");
  const show = () => {
    figures.forEach((figure, i) => { figure.hidden = i !== Number(slider.value); });
    const name = figures[slider.value].dataset.frame;
    slider.setAttribute("aria-valuetext", name);
    slider.nextElementSibling.textContent = name;
  };
  slider.addEventListener("input", show);
  slider.parentElement.hidden = false;
  show();
}
