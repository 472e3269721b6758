#include "src/studies/contest/speed_accuracy_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/contest/result.h"
#include "src/statistics/bootstrap.h"
#include "src/statistics/mean_share.h"
#include "src/statistics/order_statistic_interval.h"
#include "src/statistics/pareto_front.h"
#include "src/statistics/wilson_interval.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// The mean share with its interval: over questions, or of one alone over the runs that differ.
MeanShare share_of(const Entrant& entrant, const std::vector<double>& shares) {
  if (shares.size() > 1) return mean_share(shares);
  const double distinct = result_of(entrant.standings.front()->outcomes).distinct;
  return {shares.front(), wilson_interval(shares.front() * distinct, distinct)};
}

/// Adds the median regret with its interval.
void add_regret(Json& row, const Entrant& entrant, std::vector<double> regrets) {
  if (regrets.size() == 1) {
    regrets.clear();
    for (const Outcome& outcome : entrant.standings.front()->outcomes) {
      regrets.push_back(outcome.verdict.regret.value_or(std::numeric_limits<double>::infinity()));
    }
  }
  row["regret"] = finite(quantile(regrets, 0.5));
  const auto interval = order_statistic_interval(regrets);
  row["regret_lower"] = interval ? finite(interval->lower) : Json();
  row["regret_upper"] = interval ? finite(interval->upper) : Json();
}

Json row_of(const Campaign& campaign, const Field& field, const Entrant& entrant) {
  std::vector<double> evaluations;
  std::vector<double> seconds;
  std::vector<double> shares;
  std::vector<double> regrets;
  std::size_t runs = 0;
  for (const StoredStanding* standing : entrant.standings) {
    const OnQuestion one = on_question(campaign, *standing);
    evaluations.push_back(one.evaluations);
    seconds.push_back(one.seconds);
    shares.push_back(one.share);
    regrets.push_back(one.regret);
    runs += standing->outcomes.size();
  }
  const MeanShare share = share_of(entrant, shares);
  const bool joint = field.budget == 0;
  Json row = {{"family", field.family},
              {"part", joint ? Json() : Json(field.part + 1)},
              {"budget", joint ? Json() : Json(field.budget)},
              {"largest", field.largest},
              {"solver", entrant.solver},
              {"form", entrant.form},
              {"questions", entrant.standings.size()},
              {"complete", entrant.standings.size() == field.questions.size()},
              {"runs", runs},
              {"evaluations", mean_cost(evaluations)},
              {"seconds", mean_cost(seconds)},
              {"share", share.mean},
              {"share_lower", share.interval.lower},
              {"share_upper", share.interval.upper},
              {"regret", nullptr},
              {"regret_lower", nullptr},
              {"regret_upper", nullptr},
              {"on_front", false},
              {"on_time_front", false}};
  if (!joint) add_regret(row, entrant, std::move(regrets));
  return row;
}

/// Marks the rows that no other one beats in both.
void mark_front(Json& rows, const char* cost, const char* mark) {
  std::vector<CostAndError> points;
  for (const Json& row : rows) {
    points.push_back({row[cost].get<double>(), 1 - row["share"].get<double>()});
  }
  for (const std::size_t k : pareto_front(points)) rows[k][mark] = true;
}

/// The rows of those that take all questions.
Json complete_rows(const Campaign& campaign, const Field& field) {
  Json rows = Json::array();
  for (const Entrant& entrant : field.entrants) rows.push_back(row_of(campaign, field, entrant));
  mark_front(rows, "evaluations", "on_front");
  mark_front(rows, "seconds", "on_time_front");
  return rows;
}

std::string spent_text(double cost, bool by_time) {
  return by_time ? fmt::format("{:.2g} ms", 1e3 * cost) : fmt::format("{:.3g} evaluations", cost);
}

/// What the front says, in words.
std::string title_of(const std::string& name, const Json& front, std::size_t all, bool by_time) {
  const auto about = [&](const Json& dot) {
    return fmt::format("{} ({:.0f} %, {})", dot["solver"].get<std::string>(),
                       100 * dot["share"].get<double>(),
                       spent_text(dot["cost"].get<double>(), by_time));
  };
  const Json& fastest = front.front();
  const Json& surest = front.back();
  if (surest["share"].get<double>() == 0) {
    return fmt::format("{}: none of {} solvers solved a run", name, all);
  }
  if (fastest["cost"] == surest["cost"]) {
    return fmt::format("{}: {} is first in both, of {}", name, about(surest), all);
  }
  // The axis tells the cost: with it the title would be too long.
  return fmt::format("{}: {} of {} lead, from {} ({:.0f} %) to {} ({:.0f} %)", name, front.size(),
                     all, fastest["solver"].get<std::string>(),
                     100 * fastest["share"].get<double>(), surest["solver"].get<std::string>(),
                     100 * surest["share"].get<double>());
}

Json chart_of(const std::string& name, const Json& rows, bool by_time) {
  const char* const cost = by_time ? "seconds" : "evaluations";
  const char* const mark = by_time ? "on_time_front" : "on_front";
  Json front = Json::array();
  Json others = Json::array();
  double dearest = 0;
  for (const Json& row : rows) {
    Json dot = {{"solver", row["solver"]},
                {"cost", row[cost]},
                {"share", row["share"]},
                {"lower", row["share_lower"]},
                {"upper", row["share_upper"]}};
    dearest = std::max(dearest, row[cost].get<double>());
    (row[mark].get<bool>() ? front : others).push_back(std::move(dot));
  }
  std::stable_sort(front.begin(), front.end(), [](const Json& a, const Json& b) {
    return a["cost"].get<double>() < b["cost"].get<double>();
  });
  const double best = front.back()["share"].get<double>();
  const auto level = std::count_if(others.begin(), others.end(), [&](const Json& dot) {
    return dot["upper"].get<double>() >= best;
  });
  Json steps = front;
  steps.push_back({{"cost", dearest}, {"share", best}});
  return {{"name", fmt::format("speed-accuracy-{}{}", name, by_time ? "-seconds" : "")},
          {"family", name},
          {"about", by_time ? name + ", by time" : name},
          {"title", title_of(name, front, rows.size(), by_time)},
          {"axis", by_time ? "processor time until solved, or in all [s]"
                           : "evaluations for each variable until solved, or in all"},
          {"solvers", rows.size()},
          {"leading", front.size()},
          {"surest", front.back()["solver"]},
          {"level", level},
          {"front", std::move(front)},
          {"others", std::move(others)},
          {"steps", std::move(steps)}};
}

}  // namespace

Json speed_accuracy_data(const Campaign& campaign, const std::vector<Field>& fields) {
  Json all = Json::array();
  Json charts = Json::array();
  Json fronts = Json::array();
  const auto add = [&](const Field& field, bool draws_time) {
    Json rows = complete_rows(campaign, field);
    if (field.largest && !rows.empty()) {
      charts.push_back(chart_of(field.family, rows, false));
      if (draws_time) charts.push_back(chart_of(field.family, rows, true));
      for (const Json& row : rows) {
        if (!row["on_front"].get<bool>() && !row["on_time_front"].get<bool>()) continue;
        fronts.push_back(row);
      }
    }
    for (Json& row : rows) all.push_back(std::move(row));
    for (const Entrant& entrant : field.partial) {
      all.push_back(row_of(campaign, field, entrant));
    }
  };
  const Field joint = joint_field(campaign, fields);
  add(joint, true);
  for (const Field& field : fields) add(field, joint.entrants.empty());
  return {{"speed_accuracy", std::move(all)},
          {"speed_accuracy_charts", std::move(charts)},
          {"speed_accuracy_front", std::move(fronts)}};
}

}  // namespace ricochet::studies::contest
