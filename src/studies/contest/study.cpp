#include "src/studies/contest/study.h"

#include <algorithm>
#include <map>

#include "problems/families.h"
#include "solvers/solvers.h"
#include "src/contest/chosen.h"
#include "src/studies/contest/form_data.h"
#include "src/studies/contest/group.h"
#include "src/studies/contest/order_data.h"
#include "src/studies/contest/twin_data.h"

namespace ricochet::studies {
namespace {

using namespace contest;
using report::Json;

/// What the standing contest asks: the paper's questions, and those of 2 to 64 variables that tell
/// solvers apart, of four machines.
constexpr const char* standing_questions =
    "count-*,top-speed-*,profile-count-[248]-C[149],profile-count-32-C[149],design-count-C[149],"
    "robust-*-C[149]";

/// Who leads in every group with every budget.
Json leaders_of(const Json& groups) {
  Json rows = Json::array();
  for (const Json& group : groups) {
    for (const Json& budget : group["budgets"]) {
      if (budget["leader"].is_null()) continue;
      Json row = budget["leader"];
      row.erase("progress");
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
      if (!outcome.failure.empty()) ++exits[standing.solver]["thrown: " + outcome.failure];
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

/// Leaves the forms whose names fit.
std::vector<Standing> in_forms(std::vector<Standing> standings, const Plan& plan,
                               const std::string& patterns) {
  std::erase_if(standings, [&](const Standing& s) {
    return !fits(plan.questions[s.question].name_of(s.form), patterns);
  });
  return standings;
}

Json compute(const ContestOptions& options, bool quick) {
  const std::vector<Family> families = all_families();
  Plan plan;
  plan.questions = chosen_questions(
      every_question(families), options.questions.empty() ? standing_questions : options.questions,
      "--questions");
  plan.solvers = chosen_solvers(all_solvers(), options.solvers, "--solvers");
  plan.widths = options.widths;
  plan.instances = quick ? std::min(options.instances, 5) : options.instances;
  plan.budgets = options.budgets;
  if (plan.budgets.empty())
    plan.budgets =
        quick ? std::vector<std::int64_t>{20, 100} : std::vector<std::int64_t>{100, 1000};
  const auto standings = in_forms(hold(plan), plan, options.forms);
  const std::vector<Group> groups = groups_of(plan, families);
  Plan repeated = plan;
  repeated.run = 1;
  repeated.budgets = {plan.budgets.front()};
  const auto again = in_forms(hold(repeated), repeated, options.forms);
  Json solvers = Json::array();
  for (const Solver& solver : plan.solvers) {
    solvers.push_back({{"name", solver.name}, {"version", solver.version}});
  }
  const Json group_rows = group_data(plan, standings, groups);
  return {{"plan",
           {{"instances", plan.instances},
            {"budgets", plan.budgets},
            {"least", plan.budgets.front()},
            {"most", plan.budgets.back()},
            {"questions", plan.questions.size()},
            {"solvers", plan.solvers.size()},
            {"standings", standings.size()}}},
          {"leaders", leaders_of(group_rows)},
          {"groups", group_rows},
          {"forms", form_data(plan, standings, groups)},
          {"ceilings", ceiling_data(plan)},
          {"orders", order_data(plan, standings, again, groups)},
          {"twins", twin_data(plan)},
          {"exits", exits_of(standings)},
          {"solvers", std::move(solvers)}};
}

}  // namespace

Study contest_study(const ContestOptions& options) {
  return {"contest", "Fewer instances and evaluations",
          [options](bool quick) { return compute(options, quick); }};
}

}  // namespace ricochet::studies
