#include <algorithm>
#include <cmath>

#include "src/studies/surrogate/growth.h"

namespace ricochet::studies::surrogate {
namespace {

using report::Json;

/// The turns of the first window in which something holds.
template <class Holds>
std::optional<double> first_turns(const GrowthRow& row, const Holds& holds) {
  for (const GrowthCell& cell : row.cells) {
    if (holds(cell)) return cell.turns;
  }
  return std::nullopt;
}

std::optional<double> sensitive_from(const GrowthRow& row) {
  return first_turns(row,
                     [](const GrowthCell& c) { return c.trust.doubt == GradientDoubt::sensitive; });
}

std::optional<double> blind_wrong_from(const GrowthRow& row) {
  return first_turns(row, [](const GrowthCell& c) { return c.error_of(c.blind) > useless; });
}

std::optional<double> within_wrong_from(const GrowthRow& row) {
  return first_turns(row, [](const GrowthCell& c) { return c.error_of(c.within) > useless; });
}

bool forgets(const GrowthRow& row) {
  return !row.cells.back().sensitivity.exponent();
}

/// Of the first three shaken gaps and of two cases.
Json courses_of(const GrowthStudy& study) {
  Json courses = Json::array();
  const auto add = [&](const GrowthRow& row) {
    Json impacts = Json::array();
    const double window = row.stretched.empty() ? 1 : row.stretched.back().time;
    const std::size_t stride = 1 + row.stretched.size() / 600;
    for (std::size_t k = 0; k < row.stretched.size(); k += stride) {
      impacts.push_back(
          {{"time", row.stretched[k].time / window}, {"length", row.stretched[k].length}});
    }
    if (impacts.empty()) return;
    courses.push_back({{"motion", row.driven.name}, {"impacts", std::move(impacts)}});
  };
  const auto gaps =
      std::ranges::find(study.rows, true, [](const GrowthRow& row) { return row.driven.shaken; });
  for (auto row = gaps; row != study.rows.end() && row < gaps + 3; ++row) add(*row);
  for (auto row = study.rows.begin(); row != gaps && courses.size() < 5; ++row) {
    if (row->driven.name.starts_with("C2 ") || row->driven.name.starts_with("C10 ")) add(*row);
  }
  return courses;
}

Json data_of(const GrowthRow& row) {
  const GrowthCell& longest = row.cells.back();
  return {{"motion", row.driven.name},
          {"exponent", longest.sensitivity.exponent()},
          {"growth", longest.sensitivity.growth},
          {"rate", longest.rate},
          {"slope_shortest", row.cells.front().gradient},
          {"slope_longest", longest.gradient},
          {"sensitive_from", sensitive_from(row)},
          {"blind_wrong_from", blind_wrong_from(row)},
          {"within_wrong_from", within_wrong_from(row)}};
}

/// Of the paper's cases, and of the chaotic ones of the shaken gaps.
Json totals_of(const GrowthStudy& study) {
  int cases = 0, forgetting = 0, doubted = 0;
  double fastest = 0, worst = 0;  // rate [1/s], and error of a difference
  int chaotic = 0, warned = 0, blind = 0, within = 0;
  double apart = 0;  // of rate and exponent, relative
  for (const GrowthRow& row : study.rows) {
    const GrowthCell& longest = row.cells.back();
    if (!row.driven.shaken) {
      ++cases;
      forgetting += forgets(row);
      doubted += sensitive_from(row).has_value();
      fastest = std::max(fastest, std::abs(longest.rate.value_or(0)));
      for (const GrowthCell& cell : row.cells) worst = std::max(worst, cell.error_of(cell.within));
    } else if (longest.sensitivity.chaotic() && longest.rate) {
      ++chaotic;
      apart = std::max(apart, std::abs(*longest.rate / longest.sensitivity.growth - 1));
      warned += sensitive_from(row).has_value();
      blind += blind_wrong_from(row).has_value();
      within += within_wrong_from(row).has_value();
    }
  }
  return {{"cases", cases},
          {"doubted", doubted > 0 ? Json(doubted) : Json()},
          {"forgetting", forgetting},
          {"all_forget", forgetting == cases},
          {"fastest", fastest},
          {"worst", worst},
          {"chaotic", chaotic},
          {"warned", warned},
          {"blind", blind},
          {"within", within},
          {"apart", apart}};
}

}  // namespace

Json data_of(const GrowthStudy& study) {
  Json motions = Json::array();
  double lowest = 0, highest = 0;  // growth
  for (const GrowthRow& row : study.rows) {
    motions.push_back(data_of(row));
    lowest = std::min(lowest, row.cells.back().sensitivity.growth);
    highest = std::max(highest, row.cells.back().sensitivity.growth);
  }
  return {{"shortest", study.plan.turns.front()},
          {"longest", study.plan.turns.back()},
          {"totals", totals_of(study)},
          {"motions", std::move(motions)},
          {"lowest", lowest},
          {"highest", highest},
          {"courses", courses_of(study)},
          {"grazes", data_of(study.grazes)}};
}

}  // namespace ricochet::studies::surrogate
