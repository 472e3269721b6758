// Buttons below every chart: its numbers as a CSV file, the picture as an SVG file, and the chart
// alone in the browser's print dialog, which makes a PDF of it. Nothing is asked from a network.
"use strict";

const saveChart = (text, type, name) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

// A frame of its own, so that the page's size is the chart's and nothing else is on it.
const printChart = (svg, text) => {
  const frame = document.createElement("iframe"), {width, height} = svg.viewBox.baseVal;
  frame.title = "the chart to print";
  frame.className = "chart-to-print";
  frame.srcdoc = `<style>@page { size: ${width}px ${height}px; margin: 0 } body { margin: 0 } svg { display: block }</style>${text}`;
  frame.addEventListener("load", () => {
    frame.contentWindow.addEventListener("afterprint", () => frame.remove());
    frame.contentWindow.print();
  });
  document.body.append(frame);
};

for (const data of document.querySelectorAll("figure > script.chart-csv")) {
  const figure = data.parentElement, svg = figure.querySelector(":scope > svg");
  if (!svg) continue;
  const name = svg.getAttribute("aria-labelledby").split(" ")[0].replace(/-title$/, "");
  const picture = () => new XMLSerializer().serializeToString(svg);
  const buttons = document.createElement("p");
  buttons.className = "chart-data";
  for (const [label, act] of [
    ["CSV", () => saveChart(JSON.parse(data.textContent), "text/csv", `${name}.csv`)],
    ["SVG", () => saveChart(picture(), "image/svg+xml", `${name}.svg`)],
    ["PDF", () => printChart(svg, picture())],
  ]) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.setAttribute("aria-label", `${label}: ${svg.querySelector("title").textContent}`);
    button.addEventListener("click", act);
    buttons.append(button);
  }
  figure.append(buttons);
}
