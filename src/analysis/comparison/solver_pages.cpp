#include "src/analysis/comparison/solver_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "embedded/solvers.h"
#include "src/analysis/results.h"
#include "src/core/names.h"

namespace ricochet::studies::comparison {

namespace {

constexpr std::size_t shown_failures = 2;  // families
constexpr std::size_t shown_reasons = 2;

std::optional<std::string> text_if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// One solver on one problem, in its best formulation for the family: set, family, problem, solver,
/// share solved, running_time (ERT for each variable).
Table attempts_of(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  Table attempts{"attempts",
                 {{"set"}, {"family"}, {"problem"}, {"solver"}, {"share"}, {"running_time"}}};
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (!sets[s].largest) continue;
    each_entry(sets[s], [&](const Entry& entry) {
      for (const CellResult* result : entry.results) {
        const Problem& problem = campaign.problems()[result->cell->problem];
        const auto time = result_of(result->outcomes).returned_running_time;
        attempts.add(s, sets[s].family, problem.name, entry.solver,
                     on_problem(campaign, *result).share, value_of(time, [&](const Estimate& e) {
                       return e.value / static_cast<double>(problem.dimension());
                     }));
      }
    });
  }
  return attempts;
}

/// mean_cost() of the numbers; missing without any.
Value mean_cost_of(const std::vector<Value>& values) {
  std::vector<double> costs;
  for (const Value& value : values)
    if (const auto cost = number_in(value)) costs.push_back(*cost);
  return costs.empty() ? Value() : value_of(mean_cost(costs));
}

Value count_of_present(const std::vector<Value>& values) {
  return std::ranges::count_if(values, [](const Value& value) { return !is_missing(value); });
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
  if (row.is("on_front")) return "on the front";
  const auto ahead = ahead_of(row, speed_accuracy);
  return ahead ? fmt::format("{} {:.0f} %", ahead->text("solver"), 100 * ahead->number("share"))
               : "on the front by time";
}

/// The solver's rows of the families: those on whose front it is, then those in which it is
/// furthest behind the one that solves most. `attempts` are its own.
Table family_table(const std::string& solver, const std::vector<EntrySet>& sets,
                   const Table& attempts, const Table& speed_accuracy) {
  Table table{"families",
              {{"family"},
               {"formulation"},
               {"takes"},
               {"problems"},
               {"share", "success rate [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"solved"},
               {"running_time", "ERT [evaluations a variable]", ".3g", 3},
               {"front", "Pareto front, or who is ahead"},
               {"on_front"},
               {"behind", "", ".2f", 3}}};
  const Table solved = aggregated(attempts, {"set"},
                                  {{{"solved"}, "running_time", count_of_present},
                                   {{"running_time"}, "running_time", mean_cost_of}});
  each_row(solved, [&](const Row& own) {
    const EntrySet& set = sets[static_cast<std::size_t>(own.number("set"))];
    const Table rows = where(speed_accuracy, [&](const Row& row) {
      return row["family"] == value_of(set.family) && row["part"] == value_of(set.part + 1) &&
             row["budget"] == value_of(set.budget);
    });
    const Row row = *rows.find([&](const Row& one) { return one.text("solver") == solver; });
    double most = 0;
    each_row(rows, [&](const Row& one) { most = std::max(most, one.number("share")); });
    table.add(set.family, row["formulation"], row["problems"], set.problems.size(), row["share"],
              row["lower"], row["upper"], own["solved"], own["running_time"],
              standing_of(row, speed_accuracy), row["on_front"], most - row.number("share"));
  });
  return sorted(std::move(table), {"-on_front", "-behind"});
}

/// How the solver did on the families that are joined; nothing if it does not take all of them.
std::optional<std::string> joint_sentence(const std::string& solver, const Table& speed_accuracy) {
  const auto row = speed_accuracy.find([&](const Row& other) {
    return other.text("family") == "all" && other.text("solver") == solver;
  });
  if (!row) return {};
  const auto ahead = ahead_of(*row, speed_accuracy);
  return fmt::format("Of the {} problems that most solvers take it solves {:.0f} %{}{}.",
                     row->number("problems"), 100 * row->number("share"),
                     row->is("on_front") ? ", and is on the Pareto front" : "",
                     ahead ? fmt::format("; {} is cheaper and solves {:.0f} %",
                                         ahead->text("solver"), 100 * ahead->number("share"))
                           : "");
}

/// The problem of each family on which another solver solved most more than this one, at most two
/// families, the worst first; nothing if none did.
std::optional<std::string> failure_sentence(const Table& attempts) {
  const Table gaps = sorted(
      with(attempts, {"gap"},
           [](const Row& row) { return value_of(row.number("best_share") - row.number("share")); }),
      {"-gap", "family"});
  std::vector<std::string> worst;
  std::set<std::string> families;
  each_row(gaps, [&](const Row& row) {
    if (row.number("gap") <= 0 || worst.size() == shown_failures ||
        !families.insert(row.text("family")).second)
      return;
    worst.push_back(fmt::format("{} ({:.0f} %; {} {:.0f} %)", row.text("problem"),
                                100 * row.number("share"), row.text("best"),
                                100 * row.number("best_share")));
  });
  if (worst.empty()) return {};
  return fmt::format("It is furthest behind on {}.", fmt::join(worst, ", "));
}

/// The termination reasons of all starts: solver, reason, times, share; the most frequent first.
Table terminations_of(const std::vector<CellResult>& results) {
  std::map<std::string, std::map<std::string, int>> times;
  for (const CellResult& result : results) {
    auto& mine = times[result.cell->cell.solver];
    for (const Outcome& outcome : result.outcomes) {
      for (const std::string& reason : outcome.terminations) ++mine[reason];
      if (!outcome.failure.empty()) ++mine["failed: " + outcome.failure];
    }
  }
  Table table{"terminations",
              {{"solver"}, {"reason"}, {"times", "starts"}, {"share", "share [%]", ".1%", 3}}};
  for (const auto& [solver, reasons] : times) {
    double sum = 0;
    for (const auto& [reason, count] : reasons) sum += count;
    for (const auto& [reason, count] : reasons) table.add(solver, reason, count, count / sum);
  }
  return sorted(std::move(table), {"solver", "-times"});
}

/// "converged 81 %, stopped by the evaluator 19 %": the most frequent reasons.
std::string ends_of(const Table& terminations) {
  std::vector<std::string> ends;
  each_row(terminations, [&](const Row& row) {
    if (ends.size() < shown_reasons)
      ends.push_back(fmt::format("{} {:.0f} %", row.text("reason"), 100 * row.number("share")));
  });
  return fmt::format("{}", fmt::join(ends, "; "));
}

std::optional<std::string> settings_sentence(const std::string& solver) {
  const auto settings = settings_of(solver);
  if (!settings) return {};
  return fmt::format("{}.{}{}", settings->settings,
                     settings->from.empty() ? "" : " From: " + settings->from + ".",
                     settings->note.empty() ? "" : " Note: " + settings->note + ".");
}

/// "top-speed, hs": the families of this column's values.
std::string joined_names(const Table& table, const char* column) {
  std::vector<std::string> names;
  each_row(table, [&](const Row& row) { names.push_back(row.text(column)); });
  return fmt::format("{}", fmt::join(names, ", "));
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
                             const std::vector<EntrySet>& sets, const Table& speed_accuracy,
                             const Table& leaders) {
  const Table attempts = attempts_of(campaign, sets);
  Table best = only(sorted(attempts, {"-share"}), {"set", "problem", "solver", "share"});
  best.columns[2].name = "best";
  best.columns[3].name = "best_share";
  const Table compared = joined(attempts, best, {"set", "problem"});
  const Table terminations = terminations_of(results);
  const Table first = where(leaders, "largest", true);
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
             {"first", "first by mean rank on"},
             {"fronts", "on the Pareto front of"}}};
  for (const Solver* solver : solvers) {
    const std::string& name = solver->name;
    const Table own = where(compared, "solver", name);
    Table families = family_table(name, sets, own, speed_accuracy);
    const auto solved =
        where(own, [](const Row& row) { return row.number("share") > 0; }).rows.size();
    const std::string fronts = joined_names(where(families, "on_front", true), "family");
    const std::string firsts = joined_names(where(first, "solver", name), "family");
    all.add(name, kind_of(name), solver->version, families.rows.size(), solved, own.rows.size(),
            firsts, fronts);
    report::Part part{name, name, {}};
    part.results.set("solver", name);
    part.results.set("version", solver->version + tuned_mark(name));
    part.results.set("note", text_if_any(library_note(solver->version)));
    part.results.set("settings", settings_sentence(name));
    part.results.set("ends", text_if_any(ends_of(where(terminations, "solver", name))));
    std::string summary =
        fmt::format("It solved {} of the {} problems that it takes.", solved, own.rows.size());
    if (!firsts.empty()) summary += fmt::format(" It is first by mean rank on {}.", firsts);
    for (const auto& more : {joint_sentence(name, speed_accuracy), failure_sentence(own)})
      if (more) summary += " " + *more;
    part.results.set("summary", summary);
    part.results.add(std::move(families));
    page.add("solvers", std::move(part));
  }
  page.add(std::move(all));
  page.add(terminations);
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
  return SolverSettings{text(*one, "settings"), text(*one, "from"), text(*one, "note"),
                        (*one)["tuned"].value_or(false)};
}

std::string tuned_mark(const std::string& solver) {
  const auto settings = settings_of(solver);
  return settings && settings->tuned && !solver.ends_with("-tuned") ? " (tuned to this suite)" : "";
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
