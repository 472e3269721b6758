#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/sections.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

struct Leader {
  std::string family;
  std::optional<std::string> solver, formulation;  ///< nothing if none is first
  double budget;
  std::optional<double> best;  ///< nothing for one problem
  std::int64_t of;             ///< problems
  std::optional<bool> easy;    ///< too easy to name one
};
RICOCHET_FIELDS(Leader, family, solver, formulation, budget, best, of, easy);

struct Sized {
  double variables;
};
RICOCHET_FIELDS(Sized, variables);

struct PageData {
  std::optional<std::vector<Sized>> problems;
};
RICOCHET_FIELDS(PageData, problems);

struct Page {
  std::string folder;  ///< for a family's page: the family's name
  PageData data;
};
RICOCHET_FIELDS(Page, folder, data);

struct Change {
  std::string family, changed, setting;
  std::optional<double> returned;
};
RICOCHET_FIELDS(Change, family, changed, setting, returned);

struct FamilyName {
  std::string family;
};
RICOCHET_FIELDS(FamilyName, family);

struct SolverShares {
  std::string solver;
  std::vector<Json> shares;  ///< one for each family; null if the solver takes none of its problems
};
RICOCHET_FIELDS(SolverShares, solver, shares);

struct Comparison {
  std::vector<Leader> leaders;
  std::vector<Page> pages;
  std::vector<Change> changes;
  std::vector<FamilyName> families;
  std::vector<SolverShares> map;
};
RICOCHET_FIELDS(Comparison, leaders, pages, changes, families, map);

struct Link {
  std::string text, to;
};
RICOCHET_FIELDS(Link, text, to);

struct Answer {
  std::string problem, answer;
  std::vector<Link> links;
};
RICOCHET_FIELDS(Answer, problem, answer, links);

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// The leading entry of a family with one budget.
struct MeasuredLeader {
  Leader leader;
  double least, most;  ///< variables
  double distance;     ///< distance to the wanted size and budget, in the logarithms of the ratios
};

std::string told(const MeasuredLeader& one) {
  const std::string variables = one.least == one.most
                                    ? fmt::format("{}", one.most)
                                    : fmt::format("{} to {}", one.least, one.most);
  const Leader& leader = one.leader;
  const std::string problems = fmt::format("{} problem{}", leader.of, leader.of == 1 ? "" : "s");
  const std::string sure =
      leader.best ? fmt::format("P(best) {:.2f} on {}", *leader.best, problems) : "on " + problems;
  const std::string first =
      leader.solver
          ? fmt::format("{} on the {} formulation ({})", *leader.solver, *leader.formulation, sure)
      : leader.easy.value_or(false)
          ? fmt::format("none named, as random search solves {} at once", problems)
          : fmt::format(
                "none, as the entry with the least mean rank solved none "
                "of its runs on {}",
                problems);
  return fmt::format("{} ({} variables, {} evaluations each): {}", leader.family, variables,
                     leader.budget, first);
}

/// Returns the nearest leaders: of the family whose problems have this number of variables, or else
/// of the families with the next fewer and the next more variables.
std::vector<MeasuredLeader> nearest(const Comparison& all, double variables, double evaluations) {
  std::optional<MeasuredLeader> below, at, above;
  for (const Leader& leader : all.leaders) {
    const auto page = std::ranges::find(all.pages, leader.family, &Page::folder);
    if (page == all.pages.end() || !page->data.problems || page->data.problems->empty()) continue;
    const auto [least, most] = std::ranges::minmax(*page->data.problems, {}, &Sized::variables);
    MeasuredLeader one{leader, least.variables, most.variables, 0};
    const double there = std::clamp(variables, one.least, one.most);
    one.distance = std::abs(std::log(there / variables)) +
                   std::abs(std::log(leader.budget / (evaluations / variables)));
    auto& best = one.most < variables ? below : one.least > variables ? above : at;
    if (!best || one.distance < best->distance) best = std::move(one);
  }
  std::vector<MeasuredLeader> found;
  for (const auto& one : at ? std::vector{at} : std::vector{below, above}) {
    if (one) found.push_back(*one);
  }
  return found;
}

std::optional<Answer> on_solver(const Comparison& all) {
  constexpr double variables = 16, evaluations = 500;
  std::string text;
  std::vector<Link> links;
  bool measured = false;
  for (const MeasuredLeader& one : nearest(all, variables, evaluations)) {
    measured = one.least <= variables && variables <= one.most;
    text += (text.empty() ? "" : "; ") + told(one);
    links.push_back({one.leader.family, one.leader.family});
  }
  if (links.empty()) return std::nullopt;
  return Answer{
      fmt::format("Which solver for {} variables and {} evaluations?", variables, evaluations),
      fmt::format("{}{}.", measured ? "" : "Not measured itself; nearest: ", text), links};
}

std::optional<Answer> on_gradient(const Comparison& all) {
  std::string text;
  for (const Change& measured : all.changes) {
    if (measured.changed != "price of a gradient" || measured.setting != "measured") continue;
    for (const Change& differences : all.changes) {
      const bool same = differences.changed == measured.changed && differences.setting == "n" &&
                        differences.family == measured.family;
      if (!same || !measured.returned || !differences.returned) continue;
      text +=
          fmt::format("{} {} to {} on {}", text.empty() ? "" : ",", percent(*differences.returned),
                      percent(*measured.returned), measured.family);
    }
  }
  if (text.empty()) return std::nullopt;
  return Answer{"What does a gradient buy?",
                fmt::format("The best solver's runs solved, with gradients by differences and by "
                            "what exact ones were measured to cost:{}.",
                            text),
                {{"prices of a gradient", "#changes"}}};
}

std::optional<Answer> on_failures(const Comparison& all) {
  constexpr std::size_t told_of = 3;
  const auto row = std::ranges::find(all.map, "ipopt", &SolverShares::solver);
  if (row == all.map.end()) return std::nullopt;
  std::vector<std::pair<double, std::string>> shares;
  for (std::size_t f = 0; f < all.families.size(); ++f) {
    if (row->shares.at(f).is_number()) {
      shares.emplace_back(row->shares[f].get<double>(), all.families[f].family);
    }
  }
  if (shares.empty()) return std::nullopt;
  std::ranges::sort(shares);
  std::string text;
  for (std::size_t k = 0; k < std::min(told_of, shares.size()); ++k) {
    text += fmt::format("{}{} ({} solved)", k == 0 ? "" : ", ", shares[k].second,
                        percent(shares[k].first));
  }
  return Answer{"Where does Ipopt fail?",
                fmt::format("Most of all on {}, of {} kinds of problems.", text, shares.size()),
                {{"who solves what", "#map"}}};
}

}  // namespace

Json answers_data(const Json& all) {
  const auto comparison = all.get<Comparison>();
  Json answers = Json::array();
  for (const auto& answer :
       {on_solver(comparison), on_gradient(comparison), on_failures(comparison)}) {
    if (answer) answers.push_back(*answer);
  }
  return answers;
}

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
RICOCHET_FIELDS(FirstEntry, family, largest, solver, returned, best, problems);

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
