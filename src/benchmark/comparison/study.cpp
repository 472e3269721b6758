#include "src/studies/contest/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "problems/families.h"
#include "solvers/solvers.h"
#include "src/contest/chosen.h"
#include "src/contest/stored_contest.h"
#include "src/core/error.h"
#include "src/core/near_names.h"
#include "src/core/patterns.h"
#include "src/store/stored_parts.h"
#include "src/studies/contest/break_even_data.h"
#include "src/studies/contest/change_data.h"
#include "src/studies/contest/drawn_plan.h"
#include "src/studies/contest/factor_data.h"
#include "src/studies/contest/failure_data.h"
#include "src/studies/contest/feature_data.h"
#include "src/studies/contest/field.h"
#include "src/studies/contest/form_data.h"
#include "src/studies/contest/group.h"
#include "src/studies/contest/history_data.h"
#include "src/studies/contest/log_ratio_data.h"
#include "src/studies/contest/machine_data.h"
#include "src/studies/contest/order_data.h"
#include "src/studies/contest/pages.h"
#include "src/studies/contest/pair_data.h"
#include "src/studies/contest/profile_data.h"
#include "src/studies/contest/reported_part.h"
#include "src/studies/contest/speed_accuracy_data.h"
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

/// Patterns of solvers, and those that were added.
std::vector<std::string> solvers_of(const ContestOptions& options, const Catalogue& catalogue) {
  chosen_solvers(catalogue.solvers, options.solvers, "--solvers");
  std::vector<std::string> names;
  for (const Solver& solver : catalogue.solvers) names.push_back(solver.name);
  std::vector<std::string> solvers = split_patterns(options.solvers);
  for (const std::string& text : options.added_solvers) {
    const std::optional<Solver> own = catalogue.own_solver(text);
    const std::string& name = own ? own->name : text;
    const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
    if (own && is_known) {
      throw InputError(
          fmt::format("--solver {}: there is another solver of its name, {}", text, name));
    }
    if (!own && !is_known) {
      throw InputError(
          fmt::format("--solver {}: there is no such solver; {}", text, what_instead(text, names)));
    }
    if (own) names.push_back(name);
    solvers.push_back(text);
  }
  return solvers;
}

void check(const ContestOptions& options) {
  if (options.instances < 1) {
    throw InputError(fmt::format("--instances {}: must be >= 1", options.instances));
  }
  for (std::size_t b = 0; b < options.budgets.size(); ++b) {
    if (options.budgets[b] < (b == 0 ? 1 : options.budgets[b - 1] + 1)) {
      throw InputError(fmt::format("--budget {}: must be >= 1, and rise", options.budgets[b]));
    }
  }
  ricochet::check(options.limits);
  for (const double width : options.widths) {
    if (width > 0 && std::isfinite(width)) continue;
    throw InputError(fmt::format("--widths {}: must be finite and > 0", width));
  }
}

/// What came of one part: lists. `wider`: what a contest asks beside its own runs, of machines
/// drawn around the cases and of boxes with the best point elsewhere.
Json results_of(const Campaign& campaign, const std::vector<StoredStanding>& stored,
                const ReportedPart& part, bool wider) {
  const StoredContest contest = stored_contest(campaign, stored, part.usual);
  const ContestPlan& plan = contest.plan;
  std::vector<Group> groups = groups_of(contest);
  std::erase_if(groups,
                [&](const Group& group) { return part.asked_again.contains(group.family); });
  for (Group& group : groups) group.family = part.families.at(group.family);
  std::vector<Standing> again;
  if (const auto other = repetition_of(campaign, part.part)) {
    Conditions conditions = part.usual;
    conditions.part = *other;
    conditions.run = 1;
    again = stored_contest(campaign, stored, conditions).standings;
  }
  const Ratings ratings = ratings_of(plan, contest.standings, groups);
  Json group_rows = group_data(plan, contest.standings, groups, ratings);
  const Json twins = wider ? twin_data(plan) : Json{{"questions", 0}, {"rows", Json::array()}};
  std::int64_t least = plan.questions.front().stated.dimension();
  std::int64_t most = least;
  for (const Question& question : plan.questions) {
    least = std::min<std::int64_t>(least, question.stated.dimension());
    most = std::max<std::int64_t>(most, question.stated.dimension());
  }
  return {{"plans",
           {{{"variables",
              least == most ? std::to_string(least) : fmt::format("{} to {}", least, most)},
             {"questions", plan.questions.size()},
             {"several", most > 1},
             {"least", plan.budgets.front()},
             {"most", plan.budgets.back()},
             {"two_budgets", plan.budgets.size() > 1},
             {"instances", plan.instances},
             {"twins", twins["questions"]},
             {"standings", contest.standings.size()}}}},
          {"leaders", leaders_of(group_rows)},
          {"groups", group_rows},
          {"forms", form_data(plan, contest.standings, groups)},
          {"ceilings", ceiling_data(plan, groups)},
          {"orders", order_data(plan, contest.standings, again,
                                wider ? drawn_plan(plan) : ContestPlan{}, groups, ratings)},
          {"history", history_data(plan, contest.standings, groups)},
          {"twins", twins["rows"]},
          {"exits", exits_of(contest.standings)},
          {"failures", failure_data(plan, contest.standings)}};
}

Json compute(const Campaign& campaign, const Store& store, bool wider) {
  Digest digest(store.description());
  const std::vector<StoredStanding> stored = stored_standings(
      campaign, store, [&](const StoredRun& run) { digest.add(run.key, run.record); });
  const std::vector<ReportedPart> parts = reported_parts(campaign);
  Json data;
  for (const ReportedPart& part : parts) {
    Json results = results_of(campaign, stored, part, wider);
    for (auto& [key, rows] : results.items()) {
      if (data[key].is_null()) data[key] = Json::array();
      for (Json& row : rows) data[key].push_back(std::move(row));
    }
  }
  const std::vector<Field> fields = fields_of(campaign, stored, parts);
  data.update(speed_accuracy_data(campaign, fields));
  data["profile_families"] = profile_data(campaign, fields);
  data["pair_families"] = pair_data(campaign, fields);
  data["log_ratio_families"] = log_ratio_data(campaign, fields);
  data["break_even_families"] = break_even_data(campaign, fields);
  data.update(feature_data(campaign, stored));
  data.update(factor_data(campaign, stored, parts));
  data.update(machine_data(campaign, stored, parts));
  data["changes"] = change_data(campaign, stored, parts);
  Json solvers = Json::array();
  const std::vector<Solver> known = all_solvers();
  for (const Solver& solver : campaign.solvers()) {
    const bool outside = std::none_of(known.begin(), known.end(),
                                      [&](const Solver& k) { return k.name == solver.name; });
    solvers.push_back({{"name", solver.name}, {"version", solver.version}, {"outside", outside}});
  }
  data["campaign"] = campaign.plan().name;
  data["runs"] = campaign.runs();
  data["digest"] = digest.text();
  data["solvers"] = std::move(solvers);
  return in_pages(std::move(data));
}

}  // namespace

Plan contest_plan(const ContestOptions& options, bool quick, const Catalogue& catalogue) {
  check(options);
  Plan plan;
  plan.name = quick ? "compare --quick" : "compare";
  plan.limits = options.limits;
  PlanPart one;
  const std::string patterns = options.questions.empty() ? standing_questions : options.questions;
  one.questions = split_patterns(patterns);
  one.solvers = solvers_of(options, catalogue);
  one.forms = split_patterns(options.forms);
  one.widths = options.widths;
  one.instances = quick ? std::min(options.instances, 5) : options.instances;
  one.most_variables = 1;
  PlanPart several = one;
  several.least_variables = 2;
  several.most_variables = PlanPart().most_variables;
  using Budgets = std::vector<std::int64_t>;
  one.budgets = quick ? Budgets{20, 100} : Budgets{100, 1000};
  several.budgets = quick ? Budgets{20, 50} : Budgets{20, 200};
  const std::vector<Question> chosen =
      chosen_questions(every_question(catalogue.families), patterns, "--questions");
  for (PlanPart& part : {std::ref(one), std::ref(several)}) {
    if (!options.budgets.empty()) part.budgets = options.budgets;
    const bool any = std::any_of(chosen.begin(), chosen.end(), [&](const Question& question) {
      const std::int64_t n = question.stated.dimension();
      return part.least_variables <= n && n <= part.most_variables;
    });
    if (!any) continue;
    plan.parts.push_back(part);
    // The same with other seeds: would the order be another?
    PlanPart again = part;
    again.budgets = {part.budgets.front()};
    again.seeds = 2;
    plan.parts.push_back(again);
  }
  return plan;
}

Study contest_study(const Campaign& campaign, const Store& store, bool wider) {
  return {"contest", "Fewer instances and evaluations",
          [&campaign, &store, wider](bool) { return compute(campaign, store, wider); }};
}

}  // namespace ricochet::studies
