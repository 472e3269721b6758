// Does a chart show a mark for every datum that it offers? What is read is the picture alone and its CSV file: the axes
// from the labels of their ticks and the lines of the grid.

const numberOf = (label) => {
  const plain = label.replace(/−/g, "-").replace(/,/g, "").replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+/, (up) => `^${[...up].map((one) => "⁰¹²³⁴⁵⁶⁷⁸⁹".includes(one) ? "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(one) : "-").join("")}`);
  const [, sign, factor, power] = plain.match(/^(-?)(?:(.+)×)?10\^(-?\d+)$/) ?? [];
  return power === undefined ? Number(plain) : Number(`${sign}${factor ?? 1}e${power}`);
};

// The outlines of a path: lists of corners [x, y]; of a circle its middle.
export const outlinesOf = (d) => {
  const outlines = [];
  let x = 0, y = 0, from = [0, 0], own = null;
  for (const [, command, rest] of d.matchAll(/([MmLlHhVvAaZz])([^MmLlHhVvAaZz]*)/g)) {
    const numbers = (rest.match(/-?(?:\d+\.?\d*|\.\d+)/g) ?? []).map(Number), relative = command === command.toLowerCase(), kind = command.toLowerCase();
    const to = (nextX, nextY) => { [x, y] = [nextX, nextY]; own.corners.push([x, y]); };
    if (kind === "z") { own.closed = true; [x, y] = from; }
    else if (kind === "a") for (let i = 0; i < numbers.length; i += 7) {
      const [radius] = numbers.slice(i), back = [x, y];
      [x, y] = relative ? [x + numbers[i + 5], y + numbers[i + 6]] : numbers.slice(i + 5, i + 7);
      if (Math.hypot(x - back[0], y - back[1]) > radius) own.corners = [[(x + back[0]) / 2, (y + back[1]) / 2]];  // half a circle
    }
    else if (kind === "h") for (const step of numbers) to(relative ? x + step : step, y);
    else if (kind === "v") for (const step of numbers) to(x, relative ? y + step : step);
    else for (let i = 0; i + 1 < numbers.length; i += 2) {
      const place = relative ? [x + numbers[i], y + numbers[i + 1]] : [numbers[i], numbers[i + 1]];
      if (kind === "m" && i === 0) {
        [x, y] = from = place;
        outlines.push(own = {corners: [place], closed: false});
      } else to(...place);
    }
  }
  return outlines;
};

const rowsOf = (csv) => {
  const rows = [[""]];
  for (let i = 0, quoted = false; i < csv.length; ++i) {
    const row = rows.at(-1), one = csv[i];
    if (one === '"') {
      if (quoted && csv[i + 1] === '"') { row[row.length - 1] += '"'; ++i; } else quoted = !quoted;
    } else if (one === "," && !quoted) row.push("");
    else if (one === "\n" && !quoted) rows.push([""]);
    else row[row.length - 1] += one;
  }
  return rows.filter((row) => row.length > 1);
};

// What may turn a position into pixels: two labels alone fit a linear axis and a logarithmic one. `ticks`: pixels of labelled
// ticks, `labels`: their texts.
const axesOf = (ticks, labels) => {
  const values = labels.map(numberOf);
  if (values.some((value) => !Number.isFinite(value))) return [(name) => ticks[labels.indexOf(name)]];
  if (ticks.length < 2) return [];
  const last = ticks.length - 1, scaled = (scale) => (value) => ticks[0] + (scale(value) - scale(values[0])) / (scale(values[last]) - scale(values[0])) * (ticks[last] - ticks[0]);
  const error = (axis) => Math.max(...ticks.map((tick, i) => Math.abs(axis(values[i]) - tick)));
  return [scaled((value) => value), scaled(Math.log)].filter((axis) => error(axis) <= .6).map((axis) => (text) => axis(Number(text)));
};

const distance = ([x, y], [[ax, ay], [bx, by]]) => {
  const across = bx - ax, down = by - ay, length = across ** 2 + down ** 2;
  const along = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * across + (y - ay) * down) / length)) : 0;
  return Math.hypot(x - ax - along * across, y - ay - along * down);
};

const colourOf = ({stroke, fill}) => stroke ?? fill;

// Places of marks of one colour, by whole pixels, so that looking is quick.
class Marks {
  constructor(paths) {
    this.dots = new Map();
    this.segments = [];
    for (const {d} of paths) for (const {corners, closed} of outlinesOf(d)) {
      const middle = [0, 1].map((k) => corners.reduce((sum, corner) => sum + corner[k], 0) / corners.length);
      const key = middle.map(Math.round).join();
      this.dots.set(key, [...(this.dots.get(key) ?? []), middle]);
      for (let i = 1; i < corners.length; ++i) this.segments.push([corners[i - 1], corners[i]]);
      if (closed) this.segments.push([corners.at(-1), corners[0]]);
    }
    this.segments.sort((a, b) => Math.min(a[0][0], a[1][0]) - Math.min(b[0][0], b[1][0]));
  }
  has([x, y]) {
    for (let i = -1; i <= 1; ++i) for (let k = -1; k <= 1; ++k) {
      if ((this.dots.get(`${Math.round(x) + i},${Math.round(y) + k}`) ?? []).some((dot) => Math.hypot(dot[0] - x, dot[1] - y) <= within)) return true;
    }
    for (const segment of this.segments) {
      if (Math.min(segment[0][0], segment[1][0]) > x + within) break;
      if (distance([x, y], segment) <= within) return true;
    }
    return false;
  }
}

const within = 1;  // pixels

// How many cells, in the order of the rows, are not painted, or hatched though they have a value.
const cellsMissing = (rows, paths) => {
  const hatched = paths.filter(({fill}) => fill?.endsWith("-hatching)")), columns = rows.findIndex((row) => row[0] !== rows[0][0]);
  const painted = [...paths.filter(({fill}) => fill?.startsWith("#")), ...hatched.slice(0, -1)];  // the last is in the legend
  const boxes = painted.flatMap(({fill, d}) => outlinesOf(d).map(({corners}) => {
    const [x, y] = [0, 1].map((k) => corners.map((corner) => corner[k]));
    return {known: fill.startsWith("#"), left: Math.min(...x), right: Math.max(...x), top: Math.min(...y), bottom: Math.max(...y)};
  }));
  const wide = columns < 0 ? rows.length : columns, high = rows.length / wide;
  const [left, top] = ["left", "top"].map((side) => Math.min(...boxes.map((box) => box[side]))), [right, bottom] = ["right", "bottom"].map((side) => Math.max(...boxes.map((box) => box[side])));
  return rows.filter((row, i) => {
    const x = left + (right - left) * (i % wide + .5) / wide, y = top + (bottom - top) * (Math.floor(i / wide) + .5) / high;
    const box = boxes.find((one) => one.left <= x && x <= one.right && one.top <= y && y <= one.bottom);
    return box?.known !== (row[2] !== "");
  }).length;
};

// Of a series, where it has data: pixels.
const placesOf = (row, spread, xAxis, yAxis) => {
  const values = row[2] !== "" || spread < 0 ? [row[2]] : row.slice(spread, spread + 2);  // an area has two edges
  return row[1] === "" ? [] : values.filter((y) => y !== "").map((y) => [xAxis(row[1]), yAxis(y)]);
};

const seriesMissing = ([head, ...rows], marks, frame, xAxis, yAxis) => {
  const [[left, top], , [right, bottom]] = frame, spread = head.indexOf("lower"), series = new Map();
  const found = {data: 0, missing: 0, clipped: 0, of: []};
  for (const row of rows) series.set(row[0], [...(series.get(row[0]) ?? []), ...placesOf(row, spread, xAxis, yAxis)]);
  for (const [name, places] of series) {
    const inside = places.filter(([x, y]) => x >= left - .5 && x <= right + .5 && y >= top - .5 && y <= bottom + .5);
    const missing = Math.min(...marks.map((one) => inside.filter((place) => !one.has(place)).length), inside.length);
    found.data += places.length;
    found.clipped += places.length - inside.length;
    found.missing += missing;
    if (missing) found.of.push(`${missing} of ${inside.length} of "${name}"`);
  }
  return found;
};

// `paths`: {stroke, fill, d}, in their order; `texts`: {colour, bold, text}; `csv`: the numbers; `cells`: it is a heat map.
// Returns {data, missing, clipped, of}: how many data there are, how many inside of the axes have no mark in the one colour
// that has most of their series, how many lie outside, and which are missing; or `unread`: why the axes cannot be read.
export const marksOf = ({paths, texts, csv, cells}) => {
  const rows = rowsOf(csv);
  if (cells) return {data: rows.length - 1, missing: cellsMissing(rows.slice(1), paths), clipped: 0, of: ["cells"]};
  const grid = outlinesOf(paths[0].d).map(({corners}) => corners), frame = outlinesOf(paths[1].d).at(-1).corners;
  const upright = grid.filter(([a, b]) => a[0] === b[0]), level = grid.filter(([a, b]) => a[1] === b[1]);
  const labels = texts.filter(({colour, bold}) => colour === "#444444" && !bold).map(({text}) => text);
  const xAxes = axesOf(upright.map(([a]) => a[0]), labels.slice(0, upright.length));
  const yAxes = axesOf(level.map(([a]) => a[1]), labels.slice(upright.length, upright.length + level.length));
  if (xAxes.length === 0 || yAxes.length === 0) return {unread: `its axes have ${upright.length} and ${level.length} labels`};
  const colours = [...new Set(paths.slice(2).map(colourOf))];
  const marks = colours.map((colour) => new Marks(paths.slice(2).filter((path) => colourOf(path) === colour)));
  return xAxes.flatMap((xAxis) => yAxes.map((yAxis) => seriesMissing(rows, marks, frame, xAxis, yAxis)))
    .reduce((best, one) => one.missing + one.clipped < best.missing + best.clipped ? one : best);
};

const attributesOf = (tag) => Object.fromEntries([...tag.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));
const plain = (text) => text.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, '"').replace(/&amp;/g, "&");

// What marksOf takes of every chart of a page that offers numbers, with its `name` and the words `told` below it.
export const chartsOf = (html) => [...html.matchAll(/(<svg class="ricochet-chart".*?<\/svg>)\s*<script type="application\/json" class="chart-csv">(.*?)<\/script>.*?<figcaption>(.*?)<\/figcaption>/gs)]
  .map(([, svg, csv, told]) => ({
    name: plain(svg.match(/<title[^>]*>(.*?)<\/title>/)[1]), told, csv: JSON.parse(csv), cells: svg.includes("<linearGradient"),
    paths: [...svg.replace(/<pattern.*?<\/pattern>/s, "").matchAll(/<path ([^>]*)>/g)].map(([, tag]) => attributesOf(tag)),
    texts: [...svg.matchAll(/<g fill="#(?:\w+)"[^>]*>.*?<\/g>/gs)].flatMap(([group]) => {
      const {fill, "font-weight": bold} = attributesOf(group.slice(0, group.indexOf(">")));
      return [...group.matchAll(/<text[^>]*>(.*?)<\/text>/g)].map(([, text]) => ({colour: fill, bold, text: plain(text)}));
    }),
  }));
