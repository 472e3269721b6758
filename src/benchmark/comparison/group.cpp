#include "src/studies/contest/group.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "src/contest/result.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// A report has every standing of a group where there are no more.
constexpr std::size_t shown_rows = 80;

Json interval_of(const Interval& interval) {
  const auto end = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"lower", end(interval.lower)}, {"upper", end(interval.upper)}};
}

Json share_data(const SolvedShare& solved) {
  Json data = interval_of(solved.interval);
  data["share"] = solved.share;
  return data;
}

Json estimate_data(const Estimate& estimate) {
  Json data = interval_of(estimate.interval);
  data["value"] = std::isfinite(estimate.value) ? Json(estimate.value) : Json();
  return data;
}

Json standing_data(const ContestPlan& plan, const Standing& standing) {
  const Result result = result_of(standing.outcomes);
  Json exits = Json::array();
  for (const auto& [reason, times] : result.exits) {
    exits.push_back({{"reason", reason}, {"times", times}});
  }
  return {{"question", plan.questions[standing.question].name()},
          {"solver", standing.solver},
          {"form", plan.questions[standing.question].name_of(standing.form)},
          {"budget", plan.budgets[standing.budget]},
          {"runs", result.runs},
          {"distinct", result.distinct},
          {"found", share_data(result.found)},
          {"handed_over", share_data(result.handed_over)},
          {"running_time", result.running_time ? estimate_data(*result.running_time) : Json()},
          {"milliseconds", result.seconds_to_solve ? Json(1e3 * *result.seconds_to_solve) : Json()},
          {"gap", estimate_data(result.gap)},
          {"failed", result.failed},
          {"exits", std::move(exits)}};
}

Json rating_data(const Rating& rating) {
  Json progress = Json::array();
  for (const Reach& reach : rating.progress) {
    progress.push_back({{"evaluations", reach.evaluations},
                        {"share", reach.share},
                        {"lower", reach.interval.lower},
                        {"upper", reach.interval.upper}});
  }
  const Reach& last = rating.progress.back();
  return {{"solver", rating.solver},       {"form", rating.form},
          {"questions", rating.questions}, {"never", rating.never},
          {"found", rating.found},         {"handed_over", rating.handed_over},
          {"share", last.share},           {"lower", last.interval.lower},
          {"upper", last.interval.upper},  {"best", rating.probability_of_being_best},
          {"rank", rating.rank},           {"progress", std::move(progress)}};
}

/// Competitors that are shown beside each other, question by question.
constexpr std::size_t compared = 20;

/// A row for each of the first competitors with the share of runs that it solves of every question
/// with the largest budget; null where it does not take the question in this form.
Json share_rows(const ContestPlan& plan, const std::vector<Standing>& standings, const Group& group,
                const Json& ratings) {
  std::map<std::string, Json> rows;
  for (const Standing& standing : standings) {
    const auto place = std::find(group.questions.begin(), group.questions.end(), standing.question);
    if (place == group.questions.end() || standing.budget + 1 != plan.budgets.size()) continue;
    Json& cells =
        rows[competitor(standing.solver, plan.questions[standing.question].name_of(standing.form))];
    if (cells.is_null()) cells = Json(group.questions.size(), Json());
    cells[static_cast<std::size_t>(place - group.questions.begin())] =
        result_of(standing.outcomes).found.share;
  }
  Json all = Json::array();
  for (std::size_t i = 0; i < std::min(compared, ratings.size()); ++i) {
    const std::string name = competitor(ratings[i]["solver"], ratings[i]["form"]);
    all.push_back({{"competitor", name}, {"shares", std::move(rows.at(name))}});
  }
  return all;
}

}  // namespace

std::vector<Group> groups_of(const ContestPlan& plan, const std::vector<Family>& families) {
  std::vector<Group> groups;
  for (const Family& family : families) {
    Group group{family.name, {}};
    for (const Question& question : family.questions) {
      for (std::size_t q = 0; q < plan.questions.size(); ++q) {
        if (plan.questions[q].name() == question.name()) group.questions.push_back(q);
      }
    }
    if (!group.questions.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<Group> groups_of(const StoredContest& contest) {
  std::vector<Group> groups;
  for (std::size_t q = 0; q < contest.families.size(); ++q) {
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return group.family == contest.families[q];
    });
    if (known == groups.end()) {
      groups.push_back({contest.families[q], {q}});
    } else {
      known->questions.push_back(q);
    }
  }
  return groups;
}

Ratings ratings_of(const ContestPlan& plan, const std::vector<Standing>& standings,
                   const std::vector<Group>& groups) {
  Ratings ratings;
  for (const Group& group : groups) {
    auto& of_group = ratings.emplace_back();
    for (std::size_t b = 0; b < plan.budgets.size(); ++b) {
      of_group.push_back(rate(plan, standings, group.questions, b));
    }
  }
  return ratings;
}

Json group_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                const std::vector<Group>& groups, const Ratings& rated) {
  // A chart can tell so many lines apart.
  constexpr std::size_t drawn = 6;
  Json all = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    Json budgets = Json::array();
    for (std::size_t b = 0; b < plan.budgets.size(); ++b) {
      Json ratings = report::list_of(rated[g][b], rating_data);
      Json first = Json::array();
      for (std::size_t i = 0; i < std::min(drawn, ratings.size()); ++i) first.push_back(ratings[i]);
      for (Json& rating : ratings) rating.erase("progress");  // the first ones are drawn
      budgets.push_back({{"budget", plan.budgets[b]},
                         {"leader", ratings.empty() ? Json() : ratings[0]},
                         {"ratings", ratings},
                         {"first", std::move(first)}});
    }
    Json questions = Json::array();
    for (const std::size_t q : group.questions) {
      const Problem& stated = plan.questions[q].stated;
      questions.push_back({{"question", stated.name},
                           {"variables", stated.dimension()},
                           {"constraints", stated.constraints},
                           {"best_known", stated.best_known}});
    }
    std::vector<const Standing*> mine;
    for (const std::size_t q : group.questions) {
      for (const Standing& standing : standings) {
        if (standing.question == q) mine.push_back(&standing);
      }
    }
    const bool few = mine.size() <= shown_rows;
    Json rows = Json::array();
    if (few) {
      for (const Standing* standing : mine) rows.push_back(standing_data(plan, *standing));
    }
    const Json last = budgets.back();
    all.push_back({{"family", group.family},
                   {"ratings", last["ratings"]},  // with the largest budget
                   {"drawn", last["first"]},
                   {"budgets", std::move(budgets)},
                   {"questions", std::move(questions)},
                   {"shares", share_rows(plan, standings, group, last["ratings"])},
                   {"few", few},
                   {"standings", std::move(rows)}});
  }
  return all;
}

}  // namespace ricochet::studies::contest
