#include "src/benchmark/comparison/opening.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace ricochet::studies::comparison {
namespace {

constexpr double surely = 0.9, probably = 0.5;  // P(best)
constexpr double least_named = 0.1;             // success rate: less is no advice

/// The first entry of a family.
struct FirstEntry {
  std::string family;
  bool largest;
  std::optional<std::string> solver;  ///< nothing if none is first
  std::optional<double> returned;     ///< success rate
  std::optional<double> best;         ///< P(best); nothing for one problem
  std::optional<std::int64_t> problems;
};
RICOCHET_READ_FROM_JSON(FirstEntry, family, largest, solver, returned, best, problems);

/// P(best) of an entry that is worth naming; 0 of others.
double certainty_of(const FirstEntry& entry) {
  if (!entry.solver || entry.returned.value_or(0) < least_named) return 0;
  return entry.best.value_or(0);
}

/// The families in which one solver is first.
struct FirstSolver {
  std::string solver;
  std::vector<std::string> families;
  double least = 1, most = 0;  ///< success rate
  std::int64_t problems = 0;
};

std::vector<FirstSolver> by_solver(const std::vector<FirstEntry>& entries, double from,
                                   double below) {
  std::vector<FirstSolver> solvers;
  for (const FirstEntry& entry : entries) {
    if (certainty_of(entry) < from || certainty_of(entry) >= below) continue;
    auto known = std::ranges::find(solvers, *entry.solver, &FirstSolver::solver);
    if (known == solvers.end()) known = solvers.insert(known, FirstSolver{*entry.solver, {}});
    known->families.push_back(entry.family);
    known->least = std::min(known->least, entry.returned.value_or(0));
    known->most = std::max(known->most, entry.returned.value_or(0));
    known->problems += entry.problems.value_or(0);
  }
  return solvers;
}

std::string text_of(const FirstSolver& one) {
  const std::string least = fmt::format("{:.0f}", 100 * one.least);
  const std::string most = fmt::format("{:.0f}", 100 * one.most);
  return fmt::format("{} on {} (success rate {} %, {} problems)", one.solver,
                     fmt::join(one.families, ", "),
                     least == most ? most : fmt::format("{} to {}", least, most), one.problems);
}

std::string text_of(const char* how, const std::vector<FirstSolver>& solvers) {
  if (solvers.empty()) return "";
  std::string text = how;
  for (const FirstSolver& one : solvers) {
    text += fmt::format("{}{}", &one == &solvers.front() ? " " : "; ", text_of(one));
  }
  return text + ". ";
}

}  // namespace

std::string opening_of(const report::Json& leaders) {
  std::vector<FirstEntry> entries;
  for (const report::Json& row : leaders) {
    if (row.at("largest").get<bool>()) entries.push_back(row.get<FirstEntry>());
  }
  const auto open = std::ranges::count_if(
      entries, [](const FirstEntry& entry) { return certainty_of(entry) < probably; });
  std::string text =
      text_of("First with a probability P(best) of 0.9 or more on problems like these:",
              by_solver(entries, surely, 2)) +
      text_of("Less sure, P(best) of 0.5 to 0.9:", by_solver(entries, probably, surely));
  if (open > 0) {
    text += fmt::format(
        "On {} of {} kinds of problems no entry is named so: too few solve them, "
        "several are as good, or random search is enough.",
        open, entries.size());
  }
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

}  // namespace ricochet::studies::comparison
