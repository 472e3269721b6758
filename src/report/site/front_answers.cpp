#include "src/report/site/front_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/report/site/paper_algorithm.h"

namespace ricochet::site {
namespace {

/// Folder of the report of a kind; empty if there is none.
std::string folder_of(const std::vector<FoundReport>& reports, const std::string& kind) {
  const auto found = std::ranges::find_if(
      reports, [&](const FoundReport& report) { return report.kind.name == kind; });
  return found == reports.end() ? "" : found->folder;
}

FrontExcerpt answer(std::string heading, std::string text, std::vector<FrontLink> links) {
  return {.heading = std::move(heading), .text = std::move(text), .links = std::move(links)};
}

/// How many different solvers are first, of the families that are not too easy.
std::string solvers_sentence(const Chooser& chooser) {
  std::set<std::string> first;
  std::size_t families = 0;
  std::int64_t problems = 0;
  for (const Situation& situation : chooser.situations) {
    if (situation.perturbation != "plain" || situation.random) continue;
    first.insert(situation.entries.front().solver);
    ++families;
    problems += situation.problems;
  }
  return fmt::format(
      "No solver is best everywhere: {} solvers are first in {} kinds of problems ({} problems). "
      "Choose by your problem.",
      first.size(), families, problems);
}

std::string told(const Choice& choice) {
  std::string text =
      fmt::format("{}, {}: {:.0f} % solved", choice.solver, choice.formulation, 100 * choice.solved);
  if (choice.lower && choice.upper) {
    text += fmt::format(" [{:.0f}, {:.0f}]", 100 * *choice.lower, 100 * *choice.upper);
  }
  return text;
}

/// The best entries under a perturbation, of those kinds of problems that match.
template <class Matches>
std::string best_under(const Chooser& chooser, const std::string& perturbation,
                       const Matches& matches) {
  std::string text;
  for (const Situation& one : chooser.situations) {
    if (one.perturbation != perturbation || !matches(one)) continue;
    text += fmt::format("{}{} ({} {} problems of {} variable{}, {} runs)", text.empty() ? "" : "; ",
                        told(one.entries.front()), one.problems, one.family,
                        one.variables.least == one.variables.most
                            ? fmt::format("{}", one.variables.most)
                            : fmt::format("{} to {}", one.variables.least, one.variables.most),
                        one.variables.most == 1 ? "" : "s", one.runs.value_or(0));
  }
  return text.empty() ? text : text + ".";
}

std::string error_text(double error) {
  return error < 1e-4 ? fmt::format("{:.0e}", error) : fmt::format("{:.2g}", error);
}

/// Error and cost of the pairs of order 5(4) with a tolerance of 1e-6, beside the reference.
std::optional<FrontExcerpt> on_rk45(const Pairs& pairs) {
  const PairedSimulation *rk45 = nullptr, *reference = nullptr;
  for (const PairedSimulation& one : pairs.simulations) {
    const bool order_5 = one.simulation == "odeint-dopri5";
    if (order_5 && one.control.find("1e-6") != std::string::npos) rk45 = &one;
    if (one.reference) reference = &one;
  }
  if (rk45 == nullptr || reference == nullptr || !rk45->error) return std::nullopt;
  return answer("What are error and cost of RK45 at 1e-6?",
                fmt::format("Dormand-Prince 5(4) with {}: the threshold is off by up to {} rad/s, "
                            "at {:.0f} µs for each simulation. The event-driven simulation is the "
                            "reference, at {:.0f} µs.",
                            rk45->control, error_text(*rk45->error), 1e6 * rk45->seconds,
                            1e6 * reference->seconds),
                {{"all methods", pairs.folder, "#thresholds"}});
}

/// The paper's threshold of its first case beside ours.
std::optional<FrontExcerpt> on_paper(const PaperMachines& all) {
  const auto first = std::ranges::find_if(
      all.machines, [](const PaperMachine& machine) { return machine.id == "C1"; });
  if (first == all.machines.end() || !first->quiet_up_to || !first->paper_threshold) {
    return std::nullopt;
  }
  const double off = 100 * (*first->quiet_up_to / *first->paper_threshold - 1);
  return answer(
      fmt::format("Is the paper's {} rad/s of C1 right?", *first->paper_threshold),
      fmt::format("Nearly: C1 is quiet up to {:.2f} rad/s in the long run, {:.0f} % {} the paper's.",
                  *first->quiet_up_to, std::abs(off), off < 0 ? "below" : "above"),
      {{"every case", all.folder, "#long-run"}});
}

}  // namespace

std::vector<FrontExcerpt> first_answers(const Answered& answered) {
  std::vector<FrontExcerpt> all;
  if (answered.machines) {
    const PaperMachines& machines = *answered.machines;
    all.push_back(answer("How fast may it turn?", speed_sentence(machines),
                         {{"every machine", "machine", "#machines"}}));
    const std::string effects = effects_sentence(machines);
    if (!effects.empty()) {
      all.push_back(answer("What moves this threshold?", effects,
                           {{"values between", "machine", "#what-if"}}));
    }
    all.push_back(answer("Does the paper agree?", agreement_sentence(machines),
                         {{"the paper's cases", machines.folder, "#thresholds"}}));
  }
  if (answered.comparison != nullptr && answered.chooser) {
    const std::string verdict = paper_algorithm_verdict(*answered.comparison);
    if (!verdict.empty()) {
      const std::string own = folder_of(answered.reports, "fireworks");
      all.push_back(answer("Is the paper's fireworks algorithm worth it?", verdict,
                           {{"the algorithm", own.empty() ? answered.comparison->folder : own, ""}}));
    }
    if (!answered.chooser->situations.empty()) {
      all.push_back(answer("Which solver?", solvers_sentence(*answered.chooser),
                           {{"choose", "", "#chooser"}, {"speed against accuracy", "", "#speed-accuracy"}}));
    }
  }
  return all;
}

std::vector<FrontExcerpt> further_answers(const Answered& answered) {
  std::vector<FrontExcerpt> all;
  if (answered.machines) {
    if (auto one = on_paper(*answered.machines)) all.push_back(std::move(*one));
    all.push_back(answer("What if C4 had restitution 0.5 in place of 0.9?",
                         "The thresholds over restitution, friction and disturbance say it.",
                         {{"what if", "machine", "#what-if"}}));
  }
  if (answered.chooser) {
    const Chooser& chooser = *answered.chooser;
    const std::string noise = best_under(chooser, "noisy", [](const Situation& one) {
      return one.variables.most > 1 && one.constraints.most == 0;
    });
    if (!noise.empty()) {
      all.push_back(answer("Which solver for 4 variables, 400 evaluations and noise?", noise,
                           {{"choose", "", "?variables=4&evaluations=400&trouble=noisy#chooser"}}));
    }
    const std::string missing =
        best_under(chooser, "nan", [](const Situation&) { return true; });
    if (!missing.empty()) {
      all.push_back(answer("Which solver copes with missing values?", missing,
                           {{"choose", "", "?trouble=nan#chooser"}}));
    }
  }
  if (answered.pairs) {
    if (auto one = on_rk45(*answered.pairs)) all.push_back(std::move(*one));
  }
  all.push_back(answer("How do I cite and repeat it?",
                       "One page has the versions, hashes and commands, and BibTeX.",
                       {{"cite and repeat", "cite", ""}}));
  return all;
}

}  // namespace ricochet::site
