#include <algorithm>
#include <array>
#include <tuple>

#include "problems/carrier_track/questions/speed_problem.h"
#include "src/statistics/bootstrap.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using report::Json;
using Contests = std::vector<const ContestResult*>;

/// Whether it asks for the fewest collisions, and not for the fastest quiet speed.
bool asks_for_count(const ContestResult& contest) {
  return contest.question.stated.constraints == 0;
}

const Standing* standing_of(const ContestResult& contest, const std::string& solver) {
  const auto found = std::find_if(contest.standings.begin(), contest.standings.end(),
                                  [&](const Standing& s) { return s.solver == solver; });
  return found == contest.standings.end() ? nullptr : &*found;
}

/// All runs of one solver, over all cases.
Standing total_of(const Contests& contests, const std::string& solver) {
  Standing total;
  for (const ContestResult* contest : contests) {
    const Standing* s = standing_of(*contest, solver);
    if (s == nullptr) continue;
    total.form = s->form;
    total.failed += s->failed;
    total.regrets.insert(total.regrets.end(), s->regrets.begin(), s->regrets.end());
    total.evaluations.insert(total.evaluations.end(), s->evaluations.begin(), s->evaluations.end());
    total.seconds.insert(total.seconds.end(), s->seconds.begin(), s->seconds.end());
  }
  return total;
}

double share_solved(const Standing& standing) {
  const auto solved = std::count_if(standing.evaluations.begin(), standing.evaluations.end(),
                                    [](const Effort& e) { return e.reached; });
  return static_cast<double>(solved) / static_cast<double>(standing.evaluations.size());
}

Json rows_of(const Contests& contests, const std::vector<Solver>& solvers) {
  Json rows = Json::array();
  for (const Solver& solver : solvers) {
    const Standing total = total_of(contests, solver.name);
    if (total.regrets.empty()) continue;
    auto milliseconds = expected_running_time(total.seconds);
    if (milliseconds) *milliseconds *= 1e3;
    // Infinite, and so missing in the data, where half of the runs found nothing quiet.
    const double gap = quantile(total.regrets, 0.5);
    rows.push_back({{"solver", solver.name},
                    {"form", total.form},
                    {"runs", total.regrets.size()},
                    {"solved", share_solved(total)},
                    {"evaluations", expected_running_time(total.evaluations)},
                    {"milliseconds", milliseconds},
                    {"gap", gap},
                    {"failed", total.failed}});
  }
  return rows;
}

/// Which share of its runs each solver solves, case by case.
Json shares_of(const Contests& contests, const std::vector<Solver>& solvers) {
  Json rows = Json::array();
  for (const Solver& solver : solvers) {
    Json shares = Json::array();
    for (const ContestResult* contest : contests) {
      const Standing* s = standing_of(*contest, solver.name);
      if (s != nullptr) shares.push_back(share_solved(*s));
    }
    if (!shares.empty()) rows.push_back({{"solver", solver.name}, {"shares", std::move(shares)}});
  }
  return rows;
}

/// The cases whose progress is drawn: the paper's first at either restitution, and one disturbed.
bool is_charted(const std::string& case_id) {
  return case_id == "C1" || case_id == "C2" || case_id == "C9";
}

/// Solvers that share a chart: more than seven lines with bands cannot be told apart.
struct Group {
  const char* name;  ///< part of the file's name
  const char* title;
  bool (*holds)(const Standing&);
};

bool is_smooth(const Standing& standing) {
  return standing.form.ends_with("surrogate");
}

bool is_nlopt(const Standing& standing) {
  return standing.solver.starts_with("nlopt");
}

constexpr std::array<Group, 3> groups{
    {{"fireworks", "fireworks, evolution and chance",
      [](const Standing& s) { return !is_smooth(s) && !is_nlopt(s); }},
     {"count", "NLopt, shown the count",
      [](const Standing& s) { return !is_smooth(s) && is_nlopt(s); }},
     {"surrogate", "shown the surrogate", [](const Standing& s) { return is_smooth(s); }}}};

/// Below this gap [rad/s] the exhaustive scan cannot tell; the logarithmic axis ends here.
constexpr double smallest_gap = 1e-3;

Json progression_of(const Progression& progression, const ContestResult& contest) {
  const auto shown = [&](double reached) {
    return asks_for_count(contest)
               ? reached
               : std::max(smallest_gap, reached - *contest.question.stated.best_known);
  };
  Json points = Json::array();
  const auto at = [&](std::size_t k) {
    return std::tuple(progression.median[k], progression.lower[k], progression.upper[k]);
  };
  const std::size_t size = progression.price.size();
  for (std::size_t k = 0; k < size; ++k) {
    const bool level = k > 0 && k + 1 < size && at(k - 1) == at(k) && at(k) == at(k + 1);
    if (level) continue;  // a line is the same without it
    points.push_back({{"price", progression.price[k]},
                      {"median", shown(progression.median[k])},
                      {"lower", shown(progression.lower[k])},
                      {"upper", shown(progression.upper[k])}});
  }
  return {{"solver", progression.solver}, {"points", std::move(points)}};
}

Json progress_of(const ContestResult& contest, bool timed, const Group& group) {
  const bool exact = asks_for_count(contest);
  const auto& progressions = timed ? contest.by_seconds : contest.by_evaluations;
  Json solvers = Json::array();
  for (std::size_t i = 0; i < progressions.size(); ++i) {
    if (group.holds(contest.standings[i])) {
      solvers.push_back(progression_of(progressions[i], contest));
    }
  }
  return {{"id", contest.question.machine},
          {"exact", exact},
          {"timed", timed},
          {"best_known", exact ? Json(*contest.question.stated.best_known) : Json()},
          {"smallest_gap", exact ? Json() : Json(smallest_gap)},
          {"group", group.name},
          {"group_title", group.title},
          {"solvers", std::move(solvers)}};
}

/// The questions of which a run found a better value than was known, by how much, and who did.
Json new_bests_of(const std::vector<ContestResult>& contests) {
  Json rows = Json::array();
  for (const ContestResult& contest : contests) {
    double lowest = 0;
    std::string finder;
    for (const Standing& s : contest.standings) {
      for (const double regret : s.regrets) {
        if (regret < lowest) finder = s.solver;
        lowest = std::min(lowest, regret);
      }
    }
    if (finder.empty()) continue;
    rows.push_back(
        {{"question", contest.question.name()}, {"better_by", -lowest}, {"solver", finder}});
  }
  return rows;
}

}  // namespace

Json comparison_data(const Results& results) {
  Contests by_goal[2];
  Json progress = Json::array();
  for (const ContestResult& contest : results.contests) {
    by_goal[asks_for_count(contest) ? 1 : 0].push_back(&contest);
    if (!is_charted(contest.question.machine)) continue;
    for (const Group& group : groups) {
      for (const bool timed : {false, true}) progress.push_back(progress_of(contest, timed, group));
    }
  }
  const auto machine_of = [](const ContestResult* c) { return c->question.machine; };
  const auto goal = [&](const Contests& contests, const std::string& name, const char* title,
                        const char* unit, bool exact) -> Json {
    return {{"goal", title},
            {"name", name},
            {"unit", unit},
            {"exact", exact},
            {"rows", rows_of(contests, results.solvers)},
            {"machines", report::list_of(contests, machine_of)},
            {"shares", shares_of(contests, results.solvers)}};
  };
  const Json new_bests = new_bests_of(results.contests);
  return {{"penalty_weight", carrier_track::speed_penalty},
          {"new_bests", new_bests},
          {"some_new_bests", !new_bests.empty()},
          {"goals",
           {goal(by_goal[0], "top-speed", "fastest quiet speed", "rad/s", false),
            goal(by_goal[1], "count", "fewest collisions", "collisions", true)}},
          {"progress", std::move(progress)}};
}

}  // namespace ricochet::studies::reproduction
