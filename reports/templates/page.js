// What moves on a page: sliders over frames. Without it the page shows the same in pictures that
// stand still.
"use strict";

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
