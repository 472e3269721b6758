// Ranks of contestants and the probability of being first, by the rules of src/analysis/rating.h and
// src/analysis/statistics/ranking.h. Nothing here knows the page.

// What a run is ranked by, less is better: a run that reaches the target by its evaluations until then, after all such
// others by the point that it returned. Where a run is stopped early, what it would return is unknown: then the levels
// that it reached until then count.
const rankedBy = (cell, run, {reached, evaluations}, cap) => {
  if (reached) return evaluations;
  const [first, then] = cap < cell.entry.budget ? [levels.length - run.times.filter((time) => time <= cap * cell.variables).length, 0] : [run.missing, run.place];
  return first * 2 ** 40 + then;
};

// The share of rivals ahead of each of these, where a tie counts half.
const sharesAhead = (keys) => {
  const order = [...keys.keys()].sort((a, b) => keys[a] - keys[b]), shares = new Float64Array(keys.length);
  for (let from = 0, to = 0; from < order.length; from = to) {
    while (to < order.length && keys[order[to]] === keys[order[from]]) ++to;
    for (let i = from; i < to; ++i) shares[order[i]] = (from + (to - from - 1) / 2) / (keys.length - 1);
  }
  return shares;
};

// Numbers in [0, 1) that depend on the seed alone (mulberry32).
const uniformNumbers = (seed) => () => {
  seed = (seed + 0x6d2b79f5) | 0;
  let x = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  x = (x + Math.imul(x ^ (x >>> 7), 61 | x)) ^ x;
  return ((x ^ (x >>> 14)) >>> 0) / 2 ** 32;
};

// The mean of rows, all of the same length.
const meanOver = (rows) => {
  const mean = new Float64Array(rows[0].length);
  for (const row of rows) for (let k = 0; k < mean.length; ++k) mean[k] += row[k];
  for (let k = 0; k < mean.length; ++k) mean[k] /= rows.length;
  return mean;
};

// Draws the instances of each problem with replacement, so many times in all, evenly over the problems. Returns a list: for
// each problem and draw the mean share of rivals ahead of each of `size` entries, 0 for those that do not take part.
const drawsOfInstances = 10000;
const drawnInstances = (problems, size, below) => {
  const draws = Math.ceil(drawsOfInstances / problems.length), means = new Float64Array(problems.length * draws * size);
  for (let row = 0; row < problems.length * draws; ++row) {
    const {who, shares} = problems[Math.floor(row / draws)];
    for (let i = 0; i < shares.length; ++i) {
      const drawn = shares[below(shares.length)];
      for (let k = 0; k < who.length; ++k) means[row * size + who[k]] += drawn[k] / shares.length;
    }
  }
  return {draws, means};
};

// The share of 2,000 samples of the clusters of problems, drawn with replacement, in which each of `size` entries has the least mean
// share of rivals ahead. For each problem a sample takes one of the draws of its instances, which are made before, so
// that a page need not wait. `problems`: {who: entries, shares: a row for each instance, cluster}.
const samplesDrawn = 2000;
const probabilitiesOfBeingFirst = (problems, size) => {
  const random = uniformNumbers(1), below = (end) => Math.floor(end * random()), times = new Float64Array(size);
  const clusters = placesOf(problems.map(({cluster}) => cluster));
  const {draws, means} = drawnInstances(problems, size, below), sums = new Float64Array(size), taken = new Float64Array(size);
  for (let sample = 0; sample < samplesDrawn; ++sample) {
    sums.fill(0);
    taken.fill(0);
    let whole = 0;  // problems that all take
    for (let draw = 0; draw < clusters.length; ++draw) for (const problem of clusters[below(clusters.length)]) {
      const row = (problem * draws + below(draws)) * size, {who} = problems[problem];
      for (let k = 0; k < size; ++k) sums[k] += means[row + k];
      if (who.length === size) ++whole;
      else for (let k = 0; k < who.length; ++k) ++taken[who[k]];
    }
    let least = Infinity;
    const first = [];
    for (let k = 0; k < size; ++k) {
      sums[k] /= taken[k] + whole;  // not a number for one that took part in none
      if (sums[k] < least) least = sums[k];
    }
    for (let k = 0; k < size; ++k) if (sums[k] <= least + 1e-12) first.push(k);
    for (const k of first) times[k] += 1 / first.length;
  }
  return times.map((one) => one / samplesDrawn);
};

// Of the problems, what these entries alone are drawn with: the others cannot be first.
const amongThese = (problems, entries) => problems.map(({who, shares, cluster}) => {
  const columns = [...who.keys()].filter((k) => entries.includes(who[k]));
  return {who: Int32Array.from(columns, (k) => entries.indexOf(who[k])), shares: shares.map((row) => Float64Array.from(columns, (k) => row[k])), cluster};
});

// Sets `rank` and `first`, the probability of being first, of those contestants that take at least this share of the problems.
// `cap`: evaluations for each variable after which runs are stopped. Returns how many are ranked.
const setRanks = (contestants, problems, share, cap) => {
  const ranked = contestants.filter((one) => one.counted.size >= share * problems.size), compared = [];
  for (const key of problems) {
    const who = [...ranked.keys()].filter((k) => ranked[k].counted.has(key)), results = who.map((k) => ranked[k].counted.get(key));
    if (who.length < 2) continue;
    const shares = results[0].outcomes.map((_, run) => sharesAhead(results.map(({cell, outcomes}) => rankedBy(cell, cell.runs[run], outcomes[run], cap))));
    compared.push({who, shares, cluster: results[0].cell.cluster});
  }
  const sums = new Float64Array(ranked.length), taken = new Float64Array(ranked.length);
  for (const {who, shares} of compared) meanOver(shares).forEach((share, k) => { sums[who[k]] += share; ++taken[who[k]]; });
  ranked.forEach((one, k) => Object.assign(one, {rank: 1 + (taken[k] ? sums[k] / taken[k] : 0) * (ranked.length - 1), first: undefined}));
  if (placesOf(compared.map(({cluster}) => cluster)).length < 2 || !ranked.some((one) => one.share > 0)) return ranked.length;
  // On hundreds of problems those far behind are never first: leaving them out saves most of the time.
  const ahead = [...ranked.keys()].sort((i, k) => ranked[i].rank - ranked[k].rank).slice(0, Math.max(16, Math.floor(4000 / compared.length)));
  const probabilities = probabilitiesOfBeingFirst(amongThese(compared, ahead), ahead.length);
  ranked.forEach((one, k) => { one.first = ahead.includes(k) ? probabilities[ahead.indexOf(k)] : 0; });
  return ranked.length;
};
