#include "src/analysis/comparison/solver_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "embedded/solvers.h"
#include "src/analysis/results.h"
#include "src/core/names.h"

namespace ricochet::studies::comparison {

namespace {

/// A page lists at most so many families in which its solver is behind.
constexpr std::size_t shown_families = 3;

std::optional<std::string> text_if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// The most that any solver solved on a problem, in its best formulation for the family.
struct Best {
  std::string solver;
  double share = 0;
};

/// The best on each problem, by set and problem.
using BestOn = std::map<std::pair<const EntrySet*, std::size_t>, Best>;

BestOn best_on(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  BestOn best;
  for (const EntrySet& set : sets) {
    if (!set.largest) continue;
    each_entry(set, [&](const Entry& entry) {
      for (const CellResult* result : entry.results) {
        Best& there = best[{&set, result->cell->problem}];
        const double share = on_problem(campaign, *result).share;
        if (there.solver.empty() || share > there.share) there = {entry.solver, share};
      }
    });
  }
  return best;
}

/// One problem, as one solver did on it.
struct Attempt {
  const EntrySet* set;
  const Entry* entry;
  const CellResult* result;
  OnProblem own;
  const Best* best;

  double behind() const { return best->share - own.share; }
};

/// The problem of a family on which the solver is furthest behind the best, and on how many it is.
struct Failure {
  Attempt worst;
  int behind = 0;
};

/// The families with a problem on which another solver solved more, the worst first.
Table failed_table(const Campaign& campaign, const std::vector<Attempt>& attempts) {
  std::map<const EntrySet*, Failure> by_family;
  for (const Attempt& attempt : attempts) {
    if (attempt.behind() <= 0) continue;
    Failure& failure = by_family.try_emplace(attempt.set, Failure{attempt}).first->second;
    ++failure.behind;
    if (attempt.behind() > failure.worst.behind()) failure.worst = attempt;
  }
  std::vector<Failure> order;
  for (const auto& [set, failure] : by_family) order.push_back(failure);
  std::ranges::sort(order, [](const Failure& a, const Failure& b) {
    return std::pair(b.worst.behind(), a.worst.set->family) <
           std::pair(a.worst.behind(), b.worst.set->family);
  });
  order.resize(std::min(order.size(), shown_families));
  Table table{"failed",
              {{"family"},
               {"behind", "behind on"},
               {"of"},
               {"problem", "worst problem"},
               {"share", "success rate [%]", ".0%", 3},
               {"best", "best solver"},
               {"best_share", "its success rate [%]", ".0%", 3}}};
  for (const Failure& failure : order) {
    const Attempt& worst = failure.worst;
    table.add(worst.set->family, failure.behind, worst.entry->results.size(),
              campaign.problems()[worst.result->cell->problem].name, worst.own.share,
              worst.best->solver, worst.best->share);
  }
  return table;
}

/// ERT for each variable of the problems that at least one run solved.
std::vector<double> running_times_of(const Campaign& campaign, const Entry& entry) {
  std::vector<double> times;
  for (const CellResult* result : entry.results) {
    const auto time = result_of(result->outcomes).returned_running_time;
    const auto n = static_cast<double>(campaign.problems()[result->cell->problem].dimension());
    if (time) times.push_back(time->value / n);
  }
  return times;
}

/// The entry that dominates the row: of those at most as dear and at least as accurate, the most
/// accurate; nothing if there is none.
std::optional<Row> ahead_of(const Row& row, const Table& speed_accuracy) {
  std::optional<Row> first;
  each_row(speed_accuracy, [&](const Row& other) {
    const bool rival = other.is("on_front") && other["family"] == row["family"] &&
                       other["part"] == row["part"] && other["budget"] == row["budget"] &&
                       other["solver"] != row["solver"] &&
                       other.number("evaluations") <= row.number("evaluations") &&
                       other.number("share") >= row.number("share");
    if (rival && (!first || other.number("share") > first->number("share"))) first = other;
  });
  return first;
}

/// How the row stands to its family's Pareto front: on it, or who is ahead.
std::string standing_of(const Row& row, const Table& speed_accuracy) {
  if (!row.is("complete")) return "not compared";
  const bool by_time = row.is("on_time_front");
  if (row.is("on_front")) return by_time ? "on the front, also by time" : "on the front";
  if (by_time) return "on the front by time";
  const auto ahead = ahead_of(row, speed_accuracy);
  return ahead ? fmt::format("{} {:.0f} %", ahead->text("solver"), 100 * ahead->number("share"))
               : "";
}

void add_family_row(Table& table, const Campaign& campaign, const EntrySet& set, const Entry& entry,
                    const Table& speed_accuracy) {
  const auto row = speed_accuracy.find([&](const Row& other) {
    return other["solver"] == value_of(entry.solver) && other["family"] == value_of(set.family) &&
           other["part"] == value_of(set.part + 1) && other["budget"] == value_of(set.budget);
  });
  const std::vector<double> times = running_times_of(campaign, entry);
  table.add(set.family, entry.formulation, entry.results.size(), set.problems.size(),
            (*row)["share"], (*row)["lower"], (*row)["upper"], times.size(),
            times.empty() ? Value() : value_of(mean_cost(times)),
            standing_of(*row, speed_accuracy));
}

/// How the solver did on the families that are joined; nothing if it does not take all of them.
std::optional<std::string> joint_sentence(const std::string& solver, const Table& speed_accuracy) {
  const auto row = speed_accuracy.find([&](const Row& other) {
    return other.text("family") == "all" && other.text("solver") == solver;
  });
  if (!row) return {};
  const auto ahead = ahead_of(*row, speed_accuracy);
  return fmt::format(
      "The families that most solvers take, together ({} problems): success rate {:.0f} %, with "
      "{:.3g} evaluations a variable{}{}.",
      row->number("problems"), 100 * row->number("share"), row->number("evaluations"),
      row->is("on_front") ? "; on the Pareto front" : "",
      ahead ? fmt::format("; {} is cheaper and solves {:.0f} %", ahead->text("solver"),
                          100 * ahead->number("share"))
            : "");
}

/// The termination reasons of all starts by solver, the most frequent first.
std::map<std::string, Table> terminations_of(const std::vector<CellResult>& results) {
  std::map<std::string, std::map<std::string, int>> times;
  for (const CellResult& result : results) {
    auto& mine = times[result.cell->cell.solver];
    for (const Outcome& outcome : result.outcomes) {
      for (const std::string& reason : outcome.terminations) ++mine[reason];
      if (!outcome.failure.empty()) ++mine["failed: " + outcome.failure];
    }
  }
  std::map<std::string, Table> all;
  for (const auto& [solver, reasons] : times) {
    double sum = 0;
    for (const auto& [reason, count] : reasons) sum += count;
    Table table{"terminations",
                {{"reason"}, {"times", "starts"}, {"share", "share [%]", ".1%", 3}}};
    for (const auto& [reason, count] : reasons) table.add(reason, count, count / sum);
    all[solver] = sorted(std::move(table), {"-times"});
  }
  return all;
}

/// The families on whose Pareto front of evaluations and accuracy a solver is.
std::string fronts_of(const std::string& solver, const Table& speed_accuracy) {
  std::vector<std::string> names;
  each_row(speed_accuracy, [&](const Row& row) {
    const bool joint = is_missing(row["budget"]);
    if (row.text("solver") == solver && row.is("largest") && !joint && row.is("on_front"))
      names.push_back(row.text("family"));
  });
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<std::string> settings_sentence(const std::string& solver) {
  const auto settings = settings_of(solver);
  if (!settings) return {};
  return fmt::format("{}.{}{}", settings->settings,
                     settings->from.empty() ? "" : " From: " + settings->from + ".",
                     settings->note.empty() ? "" : " Note: " + settings->note + ".");
}

/// The part of one solver on the page, and its row in the table of all.
void add_solver(report::Results& page, Table& all, const Campaign& campaign, const Solver& solver,
                const std::vector<EntrySet>& sets, const Table& speed_accuracy, const BestOn& best,
                Table terminations) {
  Table families{"families",
                 {{"family"},
                  {"formulation"},
                  {"takes"},
                  {"problems"},
                  {"share", "success rate [%]", ".0%", 3},
                  {"lower", "", ".0%", 3},
                  {"upper", "", ".0%", 3},
                  {"solved"},
                  {"running_time", "ERT [evaluations a variable]", ".3g", 3},
                  {"front", "Pareto front, or who is ahead"}}};
  std::vector<Attempt> attempts;
  for (const EntrySet& set : sets) {
    if (!set.largest) continue;
    each_entry(set, [&](const Entry& entry) {
      if (entry.solver != solver.name) return;
      add_family_row(families, campaign, set, entry, speed_accuracy);
      for (const CellResult* result : entry.results) {
        attempts.push_back({&set, &entry, result, on_problem(campaign, *result),
                            &best.at({&set, result->cell->problem})});
      }
    });
  }
  const auto solved =
      std::ranges::count_if(attempts, [](const Attempt& a) { return a.own.share > 0; });
  const auto solved_by_none =
      std::ranges::count_if(attempts, [](const Attempt& a) { return a.best->share == 0; });
  const std::string fronts = fronts_of(solver.name, speed_accuracy);
  all.add(solver.name, kind_of(solver.name), solver.version, families.rows.size(), solved,
          attempts.size(), fronts);
  report::Part part{solver.name, solver.name, {}};
  part.results.set("solver", solver.name);
  part.results.set("version", solver.version);
  part.results.set("note", text_if_any(library_note(solver.version)));
  part.results.set("settings", settings_sentence(solver.name));
  part.results.set("joint", joint_sentence(solver.name, speed_accuracy));
  part.results.set(
      "summary",
      fmt::format("It solved {} of the {} problems that it takes, each in at least one run{}. {}.",
                  solved, attempts.size(),
                  static_cast<std::size_t>(solved) < attempts.size()
                      ? fmt::format("; {} of the others no solver did", solved_by_none)
                      : "",
                  fronts.empty() ? "It is on no family's Pareto front of speed and accuracy"
                                 : "It is on the Pareto front of speed and accuracy of " + fronts));
  part.results.add(std::move(families));
  part.results.add(failed_table(campaign, attempts));
  part.results.add(std::move(terminations));
  page.add("solvers", std::move(part));
}

}  // namespace

Table library_notes(const std::vector<Solver>& solvers) {
  std::map<std::string, std::vector<std::string>> by_version;
  for (const Solver& solver : solvers) {
    if (!library_note(solver.version).empty()) by_version[solver.version].push_back(solver.name);
  }
  Table table{"notes", {{"version"}, {"note"}, {"solvers"}}};
  for (const auto& [version, names] : by_version) {
    table.add(version, library_note(version), fmt::format("{}", fmt::join(names, ", ")));
  }
  return table;
}

report::Results solvers_page(const Campaign& campaign, const std::vector<CellResult>& results,
                             const std::vector<EntrySet>& sets, const Table& speed_accuracy) {
  const BestOn best = best_on(campaign, sets);
  std::map<std::string, Table> terminations = terminations_of(results);
  std::vector<const Solver*> solvers;
  for (const Solver& solver : campaign.solvers()) solvers.push_back(&solver);
  std::ranges::sort(solvers, {}, &Solver::name);
  report::Results page;
  Table all{"solvers",
            {{"solver"},
             {"kind"},
             {"version"},
             {"families"},
             {"solved"},
             {"problems"},
             {"fronts", "on the Pareto front of"}}};
  for (const Solver* solver : solvers) {
    Table ends = terminations.contains(solver->name) ? std::move(terminations.at(solver->name))
                                                     : Table{"terminations"};
    add_solver(page, all, campaign, *solver, sets, speed_accuracy, best, std::move(ends));
  }
  page.add(std::move(all));
  page.add(library_notes(campaign.solvers()));
  return page;
}

namespace {

const toml::table& facts() {
  static const toml::table all = toml::parse(embedded::solvers);
  return all;
}

std::string text(const toml::table& of, const char* key) {
  return of[key].value_or(std::string());
}

/// The first table of a list that names the solver; null if there is none.
const toml::table* first_with(const char* list, const std::string& solver) {
  for (const toml::node& node : *facts()[list].as_array()) {
    const toml::table& one = *node.as_table();
    for (const toml::node& pattern : *one["solvers"].as_array()) {
      if (fits(solver, pattern.value<std::string>().value())) return &one;
    }
  }
  return nullptr;
}

}  // namespace

std::optional<SolverSettings> settings_of(const std::string& solver) {
  const toml::table* one = first_with("settings", solver);
  if (one == nullptr) return std::nullopt;
  return SolverSettings{text(*one, "settings"), text(*one, "from"), text(*one, "note")};
}

std::string kind_of(const std::string& solver) {
  const toml::table* one = first_with("kind", solver);
  return one == nullptr ? "other" : text(*one, "name");
}

std::string library_note(const std::string& version) {
  for (const toml::node& node : *facts()["library"].as_array()) {
    const toml::table& one = *node.as_table();
    if (version.starts_with(text(one, "version"))) return text(one, "note");
  }
  return "";
}

}  // namespace ricochet::studies::comparison
