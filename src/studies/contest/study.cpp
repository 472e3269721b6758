#include "src/studies/contest/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "problems/families.h"
#include "solvers/outside/outside.h"
#include "solvers/solvers.h"
#include "src/contest/chosen.h"
#include "src/core/error.h"
#include "src/core/near_names.h"
#include "src/studies/contest/drawn_plan.h"
#include "src/studies/contest/failure_data.h"
#include "src/studies/contest/form_data.h"
#include "src/studies/contest/group.h"
#include "src/studies/contest/history_data.h"
#include "src/studies/contest/order_data.h"
#include "src/studies/contest/twin_data.h"

namespace ricochet::studies {
namespace {

using namespace contest;
using report::Json;

/// What the standing contest asks: the paper's questions, and those of 2 to 32 variables, which
/// tell solvers apart.
constexpr const char* standing_questions =
    "count-*,top-speed-*,hard-top-speed-*,profile-count-[28]-C[14],profile-count-32-C4,"
    "design-count-C[149],robust-worst-C4";

/// Who leads in every group with every budget.
Json leaders_of(const Json& groups) {
  Json rows = Json::array();
  for (const Json& group : groups) {
    for (const Json& budget : group["budgets"]) {
      if (budget["leader"].is_null()) continue;
      Json row = budget["leader"];
      row["family"] = group["family"];
      row["budget"] = budget["budget"];
      row["largest"] = budget == group["budgets"].back();
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// What the solvers said at the ends of their starts, over all standings.
Json exits_of(const std::vector<Standing>& standings) {
  std::map<std::string, std::map<std::string, int>> exits;
  for (const Standing& standing : standings) {
    for (const Outcome& outcome : standing.outcomes) {
      for (const std::string& exit : outcome.exits) ++exits[standing.solver][exit];
      if (!outcome.failure.empty()) ++exits[standing.solver]["failed: " + outcome.failure];
    }
  }
  Json rows = Json::array();
  for (const auto& [solver, reasons] : exits) {
    int all = 0;
    for (const auto& [reason, times] : reasons) all += times;
    for (const auto& [reason, times] : reasons) {
      rows.push_back({{"solver", solver},
                      {"reason", reason},
                      {"times", times},
                      {"share", times / static_cast<double>(all)}});
    }
  }
  return rows;
}

/// The solvers that the patterns fit, and those that were added.
std::vector<Solver> solvers_of(const ContestOptions& options) {
  std::vector<Solver> all = all_solvers();
  std::vector<std::string> names;
  for (const Solver& solver : all) names.push_back(solver.name);
  std::vector<std::string> added;
  for (const std::string& text : options.added_solvers) {
    const std::optional<Solver> brought = outside::outside_solver(text);
    const std::string& name = brought ? brought->name : text;
    const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
    if (brought && is_known) {
      throw InputError(
          fmt::format("--solver {}: there is another solver of its name, {}", text, name));
    }
    if (!brought && !is_known) {
      throw InputError(
          fmt::format("--solver {}: there is no such solver; {}", text, what_instead(text, names)));
    }
    if (brought) {
      all.push_back(*brought);
      names.push_back(name);
    }
    added.push_back(name);
  }
  std::vector<Solver> chosen = chosen_solvers(all, options.solvers, "--solvers");
  for (const Solver& solver : all) {
    const auto has_its_name = [&](const Solver& other) { return other.name == solver.name; };
    if (std::find(added.begin(), added.end(), solver.name) == added.end()) continue;
    if (std::none_of(chosen.begin(), chosen.end(), has_its_name)) chosen.push_back(solver);
  }
  return chosen;
}

/// The contests: of one variable, where a thousand evaluations are cheap, and of several.
std::vector<Plan> plans_of(const ContestOptions& options, bool quick,
                           const std::vector<Family>& families) {
  Plan plan;
  plan.questions = chosen_questions(
      every_question(families), options.questions.empty() ? standing_questions : options.questions,
      "--questions");
  plan.solvers = solvers_of(options);
  plan.widths = options.widths;
  plan.limits = options.limits;
  plan.wants = [forms = options.forms](const Question& question, const Form& form) {
    return fits(question.name_of(form), forms);
  };
  plan.instances = quick ? std::min(options.instances, 5) : options.instances;
  Plan several = plan;
  const auto is_one = [](const Question& q) { return q.stated.dimension() == 1; };
  std::erase_if(plan.questions, [&](const Question& q) { return !is_one(q); });
  std::erase_if(several.questions, is_one);
  using Budgets = std::vector<std::int64_t>;
  plan.budgets = quick ? Budgets{20, 100} : Budgets{100, 1000};
  several.budgets = quick ? Budgets{20, 50} : Budgets{20, 200};
  std::vector<Plan> plans;
  for (Plan& each : {std::ref(plan), std::ref(several)}) {
    if (!options.budgets.empty()) each.budgets = options.budgets;
    if (!each.questions.empty()) plans.push_back(each);
  }
  return plans;
}

/// What came of one contest: lists, but for the number of standings.
Json results_of(const Plan& plan, const std::vector<Family>& families) {
  const auto standings = hold(plan);
  const std::vector<Group> groups = groups_of(plan, families);
  Plan repeated = plan;
  repeated.run = 1;
  repeated.budgets = {plan.budgets.front()};
  const auto again = hold(repeated);
  const Json group_rows = group_data(plan, standings, groups);
  const Json twins = twin_data(plan);
  return {{"plans",
           {{{"variables", plan.questions.front().stated.dimension() == 1 ? "one" : "several"},
             {"questions", plan.questions.size()},
             {"several", plan.questions.front().stated.dimension() > 1},
             {"least", plan.budgets.front()},
             {"most", plan.budgets.back()},
             {"twins", twins["questions"]},
             {"standings", standings.size()}}}},
          {"leaders", leaders_of(group_rows)},
          {"groups", group_rows},
          {"forms", form_data(plan, standings, groups)},
          {"ceilings", ceiling_data(plan)},
          {"orders", order_data(plan, standings, again, drawn_plan(plan), groups)},
          {"history", history_data(plan, standings, groups)},
          {"twins", twins["rows"]},
          {"exits", exits_of(standings)},
          {"failures", failure_data(plan, standings)}};
}

Json compute(const ContestOptions& options, bool quick) {
  if (options.instances < 1) {
    throw InputError(fmt::format("--instances {}: must be >= 1", options.instances));
  }
  for (std::size_t b = 0; b < options.budgets.size(); ++b) {
    if (options.budgets[b] < (b == 0 ? 1 : options.budgets[b - 1] + 1)) {
      throw InputError(fmt::format("--budget {}: must be >= 1, and rise", options.budgets[b]));
    }
  }
  check(options.limits);
  for (const double width : options.widths) {
    if (width > 0 && std::isfinite(width)) continue;
    throw InputError(fmt::format("--widths {}: must be finite and > 0", width));
  }
  const std::vector<Family> families = all_families();
  const std::vector<Plan> plans = plans_of(options, quick, families);
  Json data;
  for (const Plan& plan : plans) {
    Json results = results_of(plan, families);
    for (auto& [key, rows] : results.items()) {
      if (data[key].is_null()) data[key] = Json::array();
      for (Json& row : rows) data[key].push_back(std::move(row));
    }
  }
  Json solvers = Json::array();
  for (const Solver& solver : plans.front().solvers) {
    solvers.push_back({{"name", solver.name}, {"version", solver.version}});
  }
  data["instances"] = plans.front().instances;
  data["solvers"] = std::move(solvers);
  return data;
}

}  // namespace

Study contest_study(const ContestOptions& options) {
  return {"contest", "Fewer instances and evaluations",
          [options](bool quick) { return compute(options, quick); }};
}

}  // namespace ricochet::studies
