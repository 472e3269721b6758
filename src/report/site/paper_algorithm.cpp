#include "src/report/site/paper_algorithm.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "src/report/site/comparison_data.h"

namespace ricochet::site {
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
