"use strict";

// What the page says in words.

// The answer of the long run.
const answerOf = ({regimes, hasRegimes, louder, longRun}, state) => {
  if (hasRegimes === undefined) return "Fastest quiet speed: being solved …";
  if (!hasRegimes) return "The long run of this machine is not known: it has another rule, or walls that give. What is below counts in the window.";
  if (louder < 0) return `Quiet up to ${shown(state.fastest)} rad/s and perhaps beyond: no turn has more than two collisions in the long run.`;
  if (!longRun) return "Loud at every speed: some turn has more than two collisions in the long run.";
  return `Fastest quiet speed: ${longRun.toFixed(3)} rad/s (${inTurns(longRun)}). Up to it, no turn has more than two collisions in the long run, one with each wall.`;
};

// The answer of the paper's rule, and what the paper says.
const windowAnswerOf = ({rule, fine, claimed}, state) => {
  if (!rule) return "";
  const {threshold, limit} = fine ?? rule, turns = state.get("revolutions");
  const of = Number.isNaN(turns) ? `${shown(state.get("seconds"))} s` : `${shown(turns)} turns`;
  const found = Number.isNaN(threshold) ? "there is no threshold" : `the threshold is ${threshold.toFixed(fine ? 3 : 2)} rad/s`;
  const told = Number.isNaN(claimed) ? state.theCase() ? " The paper gives no threshold for this case." : "" : ` The paper says ${shown(claimed)} for this case, ${state.theCase().id}.`;
  return `By the paper's rule, which counts in a window of ${of} after the start, ${found}: a count of at most ${limit} is quiet there.${told}`;
};

const motionAnswerOf = ({count, impacts, certain, doubt}, state) => {
  const omega = state.get("omega"), speed = `${shown(omega, 4)} rad/s (${inTurns(omega)})`;
  const sure = certain ? "" : ` That is not certain: ${doubt}.`;
  if (impacts.length === 0) return `At ${speed} the carrier strikes no wall in this window.`;
  return `At ${speed} the carrier strikes the walls ${impacts.length} times in this window; ${count} ${count === 1 ? "impact is" : "impacts are"} fast enough to count.${sure}`;
};
