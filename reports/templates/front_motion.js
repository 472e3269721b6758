// Speed against accuracy of the ways to compute the motion, a scene at a time.
"use strict";

const drawMotion = () => {
  const view = site.motion.charts[Number(element("scene").value)], logarithmic = view.y.scale === "logarithmic";
  const sets = view.series.map((series, i) => {
    const data = series.samples.map(({position, value, name}) => ({x: position, y: value, series, control: name}));
    Object.assign(data.at(-1), {name: [series.label, data.at(-1).control].filter(Boolean).join(" "), short: series.label});
    if (data.length > 1) data[0].name = data[0].control;
    return {data, line: "straight", colour: series.pale ? ink : colours[i % colours.length], shape: series.pale ? "diamond" : "circle", radius: series.pale ? 6 : 3};
  });
  const points = sets.flatMap(({data}) => data), values = points.map(({y}) => y);
  charts["motion-chart"].draw({
    title: `${view.title}: ${view.y.label} over ${view.x.label}, of ${view.series.map((series) => series.label).join(", ")}.`,
    x: {title: view.x.label, ...around(points.map(({x}) => x))},
    // The reference lies on the lowest error that is drawn: it needs room below to be pointed at.
    y: {title: view.y.label, logarithmic, min: logarithmic ? Math.min(...values) / 10 : -5, max: Math.max(...values) * (logarithmic ? 1.3 : 1.05)},
    sets,
    tell: ({series, control, x, y}) => [[series.label, control].filter(Boolean).join(", tolerance or step "), `time ${number(x)}`,
                                        series.pale ? "exact: it is the reference" : `error ${number(y)}`],
    follow: () => { location.href = `${site.motion.folder}/index.html#${view.name}`; },
  });
};

if (site.motion) {
  fill(element("scene"), site.motion.charts.map((chart, index) => [index, chart.title]));
  element("scene").addEventListener("change", drawMotion);
  drawMotion();
}
