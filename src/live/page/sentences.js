"use strict";

// What the page says in words.

// A number with so many digits, as short as it can be; a very large one as 1e9.
const number = (x, digits = 3) => {
  const near = Number(x.toPrecision(digits));
  return Math.abs(near) >= 1e6 && Number.isFinite(near) ? near.toExponential().replace("e+", "e") : String(near);
};

// "1 turn", "1.38 turns".
const plural = (many, noun, digits) => `${number(many, digits)} ${noun}${many === 1 ? "" : "s"}`;

const rpm = (omega) => omega * 30 / Math.PI;

// "8.079 rad/s (77.15 rpm)", as the program writes it; or with the digits of `text`.
const bothUnits = (omega, text = omega.toFixed(3)) => `${text} rad/s (${number(rpm(omega), 4)} rpm)`;

// The fastest quiet speed below a border of the long run, as `ricochet threshold` has it: a multiple of 0.001 rad/s.
const quietBelow = (border) => (Math.ceil(border / 1e-3) - 1) * 1e-3;

const solving = "being solved …";

// The answer of the long run.
const answerOf = ({before, hasRegimes, louder, border}, state) => {
  if (hasRegimes === undefined) return `Fastest quiet speed: ${solving}${before ? ` Before the change: ${before}.` : ""}`;
  if (!hasRegimes) return "The long run of this machine is not known: it has another rule, or walls that give. What is below counts in the window.";
  if (louder < 0) return `Quiet up to ${bothUnits(state.fastest, number(state.fastest))} and perhaps beyond: no turn has more than two collisions in the long run.`;
  if (!border) return "Loud at every speed: some turn has more than two collisions in the long run.";
  return `Fastest quiet speed: ${bothUnits(quietBelow(border))}. Up to it, no turn has more than two collisions in the long run, one with each wall.`;
};

const windowOf = (state) => {
  const turns = state.get("revolutions");
  return Number.isNaN(turns) ? plural(state.get("seconds"), "second") : plural(turns, "turn");
};

// What is quiet in the window: the threshold by the paper's rule for a case of the paper, and the limit of another machine. Nothing
// while it is not known.
const windowAnswerOf = ({rule, fine, limit, hasRegimes, windowLimit}, state) => {
  const own = state.theCase();
  if (limit === undefined) return undefined;
  if (!own) {
    const why = windowLimit === undefined ? "half as many again as the slowest speeds usually have" : "as many as the window has just below the fastest quiet speed";
    return `The paper has no such machine, and its rule is not applied. In a window of ${windowOf(state)} after the start, at most ${plural(limit, "collision")} are called quiet below: ${why}.`;
  }
  const {threshold} = fine ?? rule;
  const found = Number.isNaN(threshold) ? "there is no threshold" : `the threshold is ${bothUnits(threshold, threshold.toFixed(fine ? 3 : 2))}`;
  const told = Number.isNaN(own.threshold) ? "The paper gives no threshold for this case" : `The paper's own threshold is ${bothUnits(own.threshold, number(own.threshold))} for this case`;
  return `By the paper's rule, which counts in a window of ${windowOf(state)} after a fitted start, ${found}: a count of at most ${limit} is quiet there. ${told}, ${own.id}.`;
};

const wordsOf = (key) => key.replaceAll("_", " ").replace(".", ": ");

// The five that move the fastest quiet speed most, the most effective first. Nothing while it is not known.
const movesOf = ({hasRegimes, border, sensitivities}, state) => {
  if (hasRegimes === undefined || (border && !sensitivities)) return undefined;
  const all = (sensitivities ?? []).filter(({percent}) => Math.abs(percent) >= 0.005).slice(0, 5).map(({key, percent}) => `${wordsOf(key)} ${percent < 0 ? "−" : "+"}${Math.abs(percent).toFixed(2)} %`);
  if (all.length === 0) return "";
  const fitted = state.theCase() ? " The counting limit, from which speed on an impact counts, was fitted to the paper's thresholds, not measured." : "";
  return `What moves it most, by 1 % more of each: ${all.join(", ")}.${fitted}`;
};

const motionAnswerOf = ({count, impacts, certain, doubt}, state) => {
  const omega = state.get("omega"), speed = bothUnits(omega, number(omega, 4));
  const sure = certain ? "" : ` That is not certain: ${doubt}.`;
  if (impacts.length === 0) return `At ${speed} the carrier strikes no wall in this window.`;
  return `At ${speed} the carrier strikes the walls ${impacts.length === 1 ? "once" : `${impacts.length} times`} in this window; ${count} ${count === 1 ? "impact is" : "impacts are"} fast enough to count.${sure}`;
};
