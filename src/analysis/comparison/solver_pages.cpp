#include "src/analysis/comparison/solver_pages.h"

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

using report::Json;

/// A page lists at most so many families in which its solver is behind.
constexpr std::size_t shown_families = 3;

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
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

/// A row for each family with a problem on which another solver solved more, the worst first.
Json failed_rows(const Campaign& campaign, const std::vector<Attempt>& attempts) {
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
  return report::list_of(order, [&](const Failure& failure) -> Json {
    const Attempt& worst = failure.worst;
    return {{"family", worst.set->family},
            {"behind", failure.behind},
            {"of", worst.entry->results.size()},
            {"problem", campaign.problems()[worst.result->cell->problem].name},
            {"share", worst.own.share},
            {"best", worst.best->solver},
            {"best_share", worst.best->share}};
  });
}

/// ERT for each variable of the problems that at least one run solved: their number, and the
/// geometric mean, null if there is none.
Json running_time_of(const Campaign& campaign, const Entry& entry) {
  std::vector<double> times;
  for (const CellResult* result : entry.results) {
    const auto time = result_of(result->outcomes).returned_running_time;
    const auto n = static_cast<double>(campaign.problems()[result->cell->problem].dimension());
    if (time) times.push_back(time->value / n);
  }
  return {{"solved", times.size()},
          {"running_time", times.empty() ? Json() : Json(mean_cost(times))}};
}

const Json nobody_ahead = {{"ahead", nullptr}, {"ahead_share", nullptr}};

/// The entry that dominates the row, with its share: of those at most as dear and at least as
/// accurate, the most accurate; null if there is none.
Json ahead_of(const Json& row, const Json& speed_accuracy) {
  const Json* first = nullptr;
  for (const Json& other : speed_accuracy) {
    const bool rival = other["on_front"].get<bool>() && other["family"] == row["family"] &&
                       other["part"] == row["part"] && other["budget"] == row["budget"] &&
                       other["solver"] != row["solver"] &&
                       other["evaluations"].get<double>() <= row["evaluations"].get<double>() &&
                       other["share"].get<double>() >= row["share"].get<double>();
    if (rival && (first == nullptr || other["share"] > (*first)["share"])) first = &other;
  }
  if (first == nullptr) return nobody_ahead;
  return {{"ahead", (*first)["solver"]}, {"ahead_share", (*first)["share"]}};
}

/// How the row stands to its family's Pareto front; empty if it is not on it.
std::string front_text(const Json& row) {
  if (!row["complete"].get<bool>()) return "not compared";
  const bool by_time = row["on_time_front"].get<bool>();
  if (row["on_front"].get<bool>()) return by_time ? "on the front, also by time" : "on the front";
  return by_time ? "on the front by time" : "";
}

Json family_row(const Campaign& campaign, const EntrySet& set, const Entry& entry,
                const Json& speed_accuracy) {
  const auto row = std::ranges::find_if(speed_accuracy, [&](const Json& other) {
    return other["solver"] == entry.solver && other["family"] == set.family &&
           other["part"] == set.part + 1 && other["budget"] == set.budget;
  });
  Json mine = {{"family", set.family},
               {"formulation", entry.formulation},
               {"problems", entry.results.size()},
               {"of", set.problems.size()}};
  for (const char* key : {"share", "share_lower", "share_upper"}) mine[key] = row->at(key);
  mine.update(running_time_of(campaign, entry));
  const std::string front = front_text(*row);
  mine["front"] = text_or_null(front);
  mine.update(front.empty() ? ahead_of(*row, speed_accuracy) : nobody_ahead);
  return mine;
}

/// How the solver did on the families that are joined; null if it does not take all of them.
Json joint_row(const std::string& solver, const Json& speed_accuracy) {
  for (const Json& row : speed_accuracy) {
    if (row["family"] != "all" || row["solver"] != solver) continue;
    Json joint = {{"share", row["share"]},
                  {"evaluations", row["evaluations"]},
                  {"problems", row["problems"]},
                  {"on_front", row["on_front"]}};
    joint.update(ahead_of(row, speed_accuracy));
    return joint;
  }
  return {};
}

/// The termination reasons of all starts by solver, the most frequent first.
std::map<std::string, Json> terminations_of(const std::vector<CellResult>& results) {
  std::map<std::string, std::map<std::string, int>> times;
  for (const CellResult& result : results) {
    auto& mine = times[result.cell->cell.solver];
    for (const Outcome& outcome : result.outcomes) {
      for (const std::string& reason : outcome.terminations) ++mine[reason];
      if (!outcome.failure.empty()) ++mine["failed: " + outcome.failure];
    }
  }
  std::map<std::string, Json> all;
  for (const auto& [solver, reasons] : times) {
    double sum = 0;
    std::vector<std::pair<int, std::string>> order;
    for (const auto& [reason, count] : reasons) {
      order.emplace_back(-count, reason);
      sum += count;
    }
    std::ranges::sort(order);
    Json& rows = all[solver] = Json::array();
    for (const auto& [less, reason] : order) {
      rows.push_back({{"reason", reason}, {"times", -less}, {"share", -less / sum}});
    }
  }
  return all;
}

Json settings_data(const std::string& solver) {
  const auto settings = settings_of(solver);
  if (!settings) return {};
  return {{"settings", settings->settings},
          {"from", text_or_null(settings->from)},
          {"note", text_or_null(settings->note)}};
}

/// The families on whose Pareto front of evaluations and accuracy a solver is.
Json fronts_of(const std::string& solver, const Json& speed_accuracy) {
  Json names = Json::array();
  for (const Json& row : speed_accuracy) {
    const bool joint = row["budget"].is_null();
    const bool mine = row["solver"] == solver && row["largest"].get<bool>() && !joint;
    if (mine && row["on_front"].get<bool>()) names.push_back(row["family"]);
  }
  return names;
}

/// The page of one solver.
Json page_of(const Campaign& campaign, const Solver& solver, const std::vector<EntrySet>& sets,
             const Json& speed_accuracy, const BestOn& best) {
  Json families = Json::array();
  std::vector<Attempt> attempts;
  for (const EntrySet& set : sets) {
    if (!set.largest) continue;
    each_entry(set, [&](const Entry& entry) {
      if (entry.solver != solver.name) return;
      families.push_back(family_row(campaign, set, entry, speed_accuracy));
      for (const CellResult* result : entry.results) {
        attempts.push_back({&set, &entry, result, on_problem(campaign, *result),
                            &best.at({&set, result->cell->problem})});
      }
    });
  }
  const auto solved =
      std::ranges::count_if(attempts, [](const Attempt& a) { return a.own.share > 0; });
  const auto unsolved_by_all =
      std::ranges::count_if(attempts, [](const Attempt& a) { return a.best->share == 0; });
  return {{"report", "comparison_solver"},
          {"solver", solver.name},
          {"joint", joint_row(solver.name, speed_accuracy)},
          {"version", solver.version},
          {"note", text_or_null(library_note(solver.version))},
          {"settings", settings_data(solver.name)},
          {"fronts", fronts_of(solver.name, speed_accuracy)},
          {"problems", attempts.size()},
          {"solved", solved},
          {"unsolved", static_cast<std::size_t>(solved) < attempts.size()},
          {"unsolved_by_all", unsolved_by_all},
          {"families", std::move(families)},
          {"failed", failed_rows(campaign, attempts)}};
}

}  // namespace

Json library_notes(const std::vector<Solver>& solvers) {
  std::map<std::string, Json> by_version;
  for (const Solver& solver : solvers) {
    if (library_note(solver.version).empty()) continue;
    by_version.try_emplace(solver.version, Json::array()).first->second.push_back(solver.name);
  }
  Json rows = Json::array();
  for (auto& [version, names] : by_version) {
    rows.push_back(
        {{"version", version}, {"note", library_note(version)}, {"solvers", std::move(names)}});
  }
  return rows;
}

Json solvers_page(const Campaign& campaign, const std::vector<CellResult>& results,
                  const std::vector<EntrySet>& sets, const Json& speed_accuracy) {
  const BestOn best = best_on(campaign, sets);
  std::map<std::string, Json> terminations = terminations_of(results);
  std::vector<const Solver*> solvers;
  for (const Solver& solver : campaign.solvers()) solvers.push_back(&solver);
  std::ranges::sort(solvers, {}, &Solver::name);
  Json rows = Json::array();
  Json pages = Json::array();
  for (const Solver* solver : solvers) {
    Json page = page_of(campaign, *solver, sets, speed_accuracy, best);
    page["terminations"] = terminations.contains(solver->name)
                               ? std::move(terminations.at(solver->name))
                               : Json::array();
    rows.push_back({{"solver", solver->name},
                    {"version", solver->version},
                    {"families", page["families"].size()},
                    {"problems", page["problems"]},
                    {"solved", page["solved"]},
                    {"fronts", page["fronts"]}});
    pages.push_back({{"folder", solver->name}, {"data", std::move(page)}});
  }
  return {{"report", "comparison_solvers"},
          {"library_notes", library_notes(campaign.solvers())},
          {"solvers", std::move(rows)},
          {"pages", std::move(pages)}};
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
