#include "src/report/site/front_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "src/report/site/entries.h"
#include "src/report/site/machine_page.h"

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
  std::string text = fmt::format("{}, {}: {:.0f} % solved", choice.solver, choice.formulation,
                                 100 * choice.solved);
  if (choice.lower && choice.upper) {
    text += fmt::format(" [{:.0f}, {:.0f}]", 100 * *choice.lower, 100 * *choice.upper);
  }
  return text;
}

/// The best entry, and the best without derivatives if that is another.
std::string best_of(const Situation& one) {
  const Choice& first = one.entries.front();
  std::string text = told(first);
  const auto plain =
      std::ranges::find_if(one.entries, [](const Choice& choice) { return !choice.gradient; });
  if (first.gradient && plain != one.entries.end()) {
    text += "; without a gradient " + told(*plain);
  }
  return text;
}

/// The page about a perturbation.
std::string folder_under(const Chooser& chooser, const std::string& perturbation) {
  const auto found = std::ranges::find_if(
      chooser.situations, [&](const Situation& one) { return one.perturbation == perturbation; });
  return found == chooser.situations.end() ? chooser.folder : found->folder;
}

/// The best entries under a perturbation, of those kinds of problems that match.
template <class Matches>
std::string best_under(const Chooser& chooser, const std::string& perturbation,
                       const Matches& matches) {
  std::string text;
  for (const Situation& one : chooser.situations) {
    if (one.perturbation != perturbation || !matches(one)) continue;
    const std::string variables =
        one.variables.least == one.variables.most
            ? fmt::format("{}", one.variables.most)
            : fmt::format("{} to {}", one.variables.least, one.variables.most);
    text +=
        fmt::format("{}{} ({} {} problem{} of {} variable{}, {} runs)", text.empty() ? "" : ". ",
                    best_of(one), one.problems, one.family, one.problems == 1 ? "" : "s", variables,
                    one.variables.most == 1 ? "" : "s", one.runs.value_or(0));
  }
  return text.empty() ? text : text + ".";
}

std::string error_text(double error) {
  return error < 1e-4 ? fmt::format("{:.0e}", error) : fmt::format("{:.2g}", error);
}

/// The paper's algorithm, with its intervals and those of its rivals on its report's page.
std::optional<FrontExcerpt> fireworks_against_cmaes(const Answered& answered) {
  const std::string verdict = paper_algorithm_verdict(*answered.comparison);
  const std::string own = folder_of(answered.reports, "fireworks");
  if (verdict.empty()) return std::nullopt;
  return answer("Fireworks against CMA-ES: where does it win?", verdict,
                {{"with intervals", own.empty() ? answered.comparison->folder : own, ""}});
}

/// Error and cost of Dormand-Prince 5(4) at the tolerances around 1e-6, beside the reference.
std::optional<FrontExcerpt> on_rk45(const Pairs& pairs) {
  const PairedSimulation* reference = nullptr;
  std::string measured;
  for (const PairedSimulation& one : pairs.simulations) {
    if (one.reference) reference = &one;
    const bool near = one.control == "tolerance 1e-5" || one.control == "tolerance 1e-6" ||
                      one.control == "tolerance 1e-7";
    if (one.simulation != "odeint-dopri5" || !near || !one.error) continue;
    measured +=
        fmt::format("{}{}: {} rad/s off, {:.0f} µs a simulation", measured.empty() ? "" : "; ",
                    one.control, error_text(*one.error), 1e6 * one.seconds);
  }
  if (measured.empty() || reference == nullptr) return std::nullopt;
  return answer("What are error and cost of RK45 at 1e-6?",
                fmt::format("Dormand-Prince 5(4), {}. The event-driven simulation takes {:.0f} µs; "
                            "it is the reference.",
                            measured, 1e6 * reference->seconds),
                {{"all methods", pairs.folder, "#thresholds"}});
}

/// The threshold of C4 with a restitution between.
std::optional<FrontExcerpt> on_what_if(const PaperMachines& all,
                                       const std::vector<FoundReport>& reports) {
  constexpr double other = 0.5;
  const auto grid = machine_grid(reports);
  const auto machine =
      std::ranges::find_if(all.machines, [](const PaperMachine& one) { return one.id == "C4"; });
  if (!grid || machine == all.machines.end() || !machine->quiet_up_to) return std::nullopt;
  const auto speed = with_restitution(*grid, *machine, other);
  if (!speed) return std::nullopt;
  return answer(
      fmt::format("What if C4 had restitution {} in place of {}?", other, machine->restitution),
      fmt::format("It would be quiet up to {:.2f} rad/s in place of {:.2f}.", *speed,
                  *machine->quiet_up_to),
      {{"what if", "machine", "#what-if"}});
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
      fmt::format("C1 is quiet up to {:.2f} rad/s in the long run, {:.0f} % {} the paper's{}.",
                  *first->quiet_up_to, std::abs(off), off < 0 ? "below" : "above",
                  all.fitted
                      ? fmt::format(", after fitting {} parameters to its thresholds", *all.fitted)
                      : ""),
      {{"every case", all.folder, cases_anchor}});
}

/// The fastest quiet speed of one of the machines.
std::optional<FrontExcerpt> on_speed(const PaperMachines& all) {
  const auto machine =
      std::ranges::find_if(all.machines, [](const PaperMachine& one) { return one.id == "C3"; });
  if (machine == all.machines.end() || !machine->quiet_up_to) return std::nullopt;
  return answer(
      fmt::format("How fast may {} run?", machine->id),
      fmt::format("{:.2f} rad/s, {:.0f} rpm.", *machine->quiet_up_to, *machine->quiet_up_to * rpm),
      {{"every case", all.folder, cases_anchor}});
}

}  // namespace

std::vector<FrontExcerpt> first_answers(const Answered& answered) {
  std::vector<FrontExcerpt> all;
  if (answered.machines) {
    all.push_back(answer("How fast may it turn?", speed_sentence(*answered.machines),
                         {{"every machine", "machine", "#machines"}}));
  }
  if (answered.comparison != nullptr && answered.chooser) {
    const std::string verdict = paper_algorithm_verdict(*answered.comparison);
    const std::string own = folder_of(answered.reports, "fireworks");
    if (!verdict.empty()) {
      all.push_back(
          answer("Is the paper's fireworks algorithm worth it?", verdict,
                 {{"where it wins", own.empty() ? answered.comparison->folder : own, ""}}));
    }
    if (!answered.chooser->situations.empty()) {
      all.push_back(
          answer("Which solver?", solvers_sentence(*answered.chooser),
                 {{"choose", "", "#chooser"}, {"speed against accuracy", "", "#speed-accuracy"}}));
    }
  }
  if (answered.machines) {
    const std::string& moves = answered.machines->moves;
    if (!moves.empty()) {
      all.push_back(
          answer("What moves the threshold?", moves, {{"values between", "machine", "#what-if"}}));
    }
    all.push_back(answer("Does the paper agree?", agreement_sentence(*answered.machines),
                         {{"the paper's cases", answered.machines->folder, cases_anchor}}));
  }
  return all;
}

std::vector<FrontExcerpt> further_answers(const Answered& answered) {
  std::vector<FrontExcerpt> all;
  if (answered.machines) {
    if (auto one = on_speed(*answered.machines)) all.push_back(std::move(*one));
    if (auto one = on_paper(*answered.machines)) all.push_back(std::move(*one));
    if (auto one = on_what_if(*answered.machines, answered.reports)) {
      all.push_back(std::move(*one));
    }
  }
  if (answered.comparison != nullptr) {
    if (auto worth = fireworks_against_cmaes(answered)) all.push_back(std::move(*worth));
  }
  if (answered.chooser) {
    const Chooser& chooser = *answered.chooser;
    const std::string noise = best_under(chooser, "noisy", [](const Situation& one) {
      return one.variables.most > 1 && one.constraints.most == 0;
    });
    if (!noise.empty()) {
      all.push_back(answer(
          "Which solver for 4 variables, 400 evaluations and noise?", noise,
          {{"choose", "", "?variables=4&evaluations=400&trouble=noisy&gradient=yes#chooser"}}));
    }
    const std::string missing = best_under(chooser, "nan", [](const Situation&) { return true; });
    if (!missing.empty()) {
      all.push_back(answer("Which solver copes with missing values?", missing,
                           {{"by perturbation", folder_under(chooser, "nan"), "#perturbations"}}));
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

namespace {

constexpr const char* its_name = "fireworks";
constexpr const char* chance = "random-search";
constexpr const char* own_family = "top-speed";

/// Solvers of one kind, by a part of their names.
struct Kind {
  const char *label, *part;
};
constexpr Kind kinds[] = {{"CMA-ES", "cmaes"}, {"NLopt", "nlopt"}, {"Ipopt", "ipopt"}};

/// The solvers of a family with its largest budget that take all of its problems.
class Measured {
 public:
  Measured(const std::vector<SpeedAccuracy>& all, const std::string& family) {
    for (const SpeedAccuracy& one : all) {
      const bool whole = one.share && one.share_lower && one.share_upper;
      if (one.family == family && one.largest && one.complete && whole) rows_.push_back(one);
    }
  }

  /// The best solver that fits; null if none does.
  template <class Fits>
  const SpeedAccuracy* best(const Fits& fits) const {
    const SpeedAccuracy* found = nullptr;
    for (const SpeedAccuracy& one : rows_) {
      if (!fits(one.solver)) continue;
      const bool cheaper =
          found != nullptr && one.share == found->share && one.evaluations < found->evaluations;
      if (found == nullptr || one.share > found->share || cheaper) found = &one;
    }
    return found;
  }

  const SpeedAccuracy* named(const std::string& name) const {
    return best([&](const std::string& solver) { return solver == name; });
  }

 private:
  std::vector<SpeedAccuracy> rows_;
};

std::string told(const SpeedAccuracy& one) {
  return fmt::format("{} {:.0f} % ({:.0f} to {:.0f})", one.solver, 100 * *one.share,
                     100 * *one.share_lower, 100 * *one.share_upper);
}

/// The algorithm and its rivals in a family; empty if it is not there.
std::string rivals(const Measured& measured) {
  const SpeedAccuracy* own = measured.named(its_name);
  if (own == nullptr) return "";
  std::string text = told(*own), missing;
  if (const SpeedAccuracy* one = measured.named(chance)) text += ", " + told(*one);
  for (const Kind& kind : kinds) {
    const SpeedAccuracy* one = measured.best(
        [&](const std::string& solver) { return solver.find(kind.part) != std::string::npos; });
    if (one != nullptr) {
      text += ", " + told(*one);
    } else {
      missing += fmt::format("; none of {} takes all", kind.label);
    }
  }
  return text + missing;
}

std::string counted(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", names.size());
}

std::string percent(const SpeedAccuracy& one) {
  return fmt::format("{:.0f} %", 100 * *one.share);
}

/// Whether it is better than random search, by their intervals, beside the best of all.
std::string verdict(const Measured& measured, const std::string& where) {
  const SpeedAccuracy* own = measured.named(its_name);
  if (own == nullptr) return "";
  const SpeedAccuracy* drawn = measured.named(chance);
  std::string text;
  if (drawn != nullptr) {
    const bool better = own->share_lower > drawn->share_upper;
    const bool worse = own->share_upper < drawn->share_lower;
    text = fmt::format("{} than random search: on {} it solves {} of the runs, random search {}",
                       better  ? "Better"
                       : worse ? "Worse"
                               : "Not measurably better",
                       where, percent(*own), percent(*drawn));
  } else {
    text = fmt::format("On {} it solves {} of the runs", where, percent(*own));
  }
  const SpeedAccuracy* cmaes = measured.best(
      [](const std::string& solver) { return solver.find("cmaes") != std::string::npos; });
  if (cmaes != nullptr) text += ", CMA-ES " + percent(*cmaes);
  const SpeedAccuracy* first = measured.best([](const std::string&) { return true; });
  if (first != nullptr && first != own && first != cmaes) {
    text += fmt::format(", {} {}", first->solver, percent(*first));
  }
  return fmt::format("{} ({} problems).", text, own->problems.value_or(0));
}

/// Where it leads, of the families that it takes.
std::string wins(const std::vector<SpeedAccuracy>& all) {
  std::vector<std::string> families, most, over_chance;
  for (const SpeedAccuracy& one : all) {
    if (one.budget && std::ranges::count(families, one.family) == 0) {
      families.push_back(one.family);
    }
  }
  int taken = 0;
  for (const std::string& family : families) {
    const Measured measured(all, family);
    const SpeedAccuracy* own = measured.named(its_name);
    if (own == nullptr) continue;
    ++taken;
    const SpeedAccuracy* other =
        measured.best([](const std::string& solver) { return solver != its_name; });
    if (other == nullptr || own->share > other->share) most.push_back(family);
    const SpeedAccuracy* drawn = measured.named(chance);
    if (drawn != nullptr && own->share_lower > drawn->share_upper) over_chance.push_back(family);
  }
  return fmt::format(
      " It wins in {} of {} families{}{}, and beats random search, intervals apart, in {}{}{}.",
      counted(most), taken, most.empty() ? "" : ": ", fmt::join(most, ", "), counted(over_chance),
      over_chance.empty() ? "" : ": ", fmt::join(over_chance, ", "));
}

}  // namespace

std::string paper_algorithm_verdict(const FoundReport& comparison) {
  const std::vector<SpeedAccuracy> all = comparison.data.get<ComparisonData>().speed_accuracy;
  std::string own = verdict(Measured(all, own_family), "the paper's own problem");
  if (own.empty()) own = verdict(Measured(all, "all"), "all families together");
  return own.empty() ? own : own + wins(all);
}

std::optional<FrontExcerpt> paper_algorithm(const FoundReport& comparison) {
  const std::vector<SpeedAccuracy> all = comparison.data.get<ComparisonData>().speed_accuracy;
  std::string text;
  std::vector<FrontLink> links;
  for (const std::string& family : {std::string(own_family), std::string("all")}) {
    const Measured measured(all, family);
    const std::string here = rivals(measured);
    if (here.empty()) continue;
    const SpeedAccuracy& own = *measured.named(its_name);
    const std::string budget =
        own.budget ? fmt::format(", {} evaluations a variable", *own.budget) : "";
    text += fmt::format("{}{} ({} problems{}): {}.", text.empty() ? "" : " ",
                        own.budget ? "The paper's own problem, " + family : "All families",
                        own.problems.value_or(0), budget, here);
    links.push_back(own.budget ? FrontLink{family, comparison.folder + "/" + family, ""}
                               : FrontLink{"all families", comparison.folder, "#speed-accuracy"});
  }
  if (text.empty()) return std::nullopt;
  return FrontExcerpt{
      .heading = "What is the paper's fireworks algorithm worth?",
      .text = paper_algorithm_verdict(comparison) +
              " Runs solved by the returned point (95 % interval), beside the best solvers of "
              "CMA-ES, NLopt and Ipopt: " +
              text,
      .links = std::move(links)};
}

}  // namespace ricochet::site
