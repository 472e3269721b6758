#include "src/studies/surrogate/growth.h"

#include <ceres/jet.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"
#include "src/studies/surrogate/continuity.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;
using Jet = ceres::Jet<double, 1>;
using report::Json;

constexpr double box = 18;  // [rad/s]

Scene in_window(const Driven& driven, double turns) {
  Scene scene = driven.scene;
  scene.window = Seconds{turns * 2 * std::numbers::pi / driven.rate()};
  if (!driven.shaken) scene.window = Revolutions{turns};
  return scene;
}

/// Records how far the impacts move.
class Mover : public Observer {
 public:
  explicit Mover(const Driven& driven)
      : rate_(driven.rate()), slowest_(driven.scene.counting_limit) {}

  void impact(const Jet& time, Wall /*wall*/, const Jet& speed) {
    if (speed.a < slowest_) return;
    const double late = time.v[0] + time.a / rate_;  // [s] per rad/s, at the same phase
    const double length = std::hypot(speed.a * late, speed.v[0] / rate_);
    if (std::isfinite(length) && length > 0) moved.push_back({time.a, length});
  }

  std::vector<Stretched> moved;

 private:
  double rate_, slowest_;
};

}  // namespace

std::vector<Stretched> stretched_by_impact(const Driven& driven) {
  auto scene = lifted<Jet>(driven.scene);
  (driven.shaken ? scene.disturbance_frequency : scene.omega).v[0] = 1.0;
  Mover mover(driven);
  simulate(scene, mover);
  return mover.moved;
}

std::optional<double> rate_of(const std::vector<Stretched>& impacts, double window) {
  std::vector<Point> points;
  for (const Stretched& impact : impacts) {
    if (impact.time > 0.1 * window) points.push_back({impact.time, std::log(impact.length)});
  }
  return slope_of(points);
}

double GrowthCell::error_of(const Difference& difference) const {
  const double larger = std::max(std::abs(gradient), std::abs(difference.slope));
  if (larger == 0) return 0;
  const double apart = std::abs(gradient - difference.slope) / larger;
  return std::isfinite(apart) ? apart : 1.0;
}

GrowthCell growth_of(const Driven& driven, double turns) {
  Driven now = driven;
  now.scene = in_window(driven, turns);
  const double rate = now.rate();
  const Gradient exact = gradient_of<1>(now, Vector::Constant(1, rate), Vector::Constant(1, box));
  const double step = 1e-3 * rate;
  const auto value_at = [&](double x) { return value_of(now, Vector::Constant(1, x)); };
  return {turns,
          rate_of(stretched_by_impact(now), duration_of(now.scene)),
          dynamics::sensitivity_of(now.scene),
          exact.gradient[0],
          exact.trust,
          difference(value_at, rate, step),
          difference(value_at, rate, std::min(step, 0.25 * exact.trust.reach * box))};
}

std::vector<Driven> shaken_gaps() {
  const Scene chaotic = dynamics::benchmark_scene("chaotic", 1);
  std::vector<Driven> gaps = {{"chaotic scene", chaotic, true}};
  for (const double pull : {0.0, 0.5, 1.0}) {
    for (const double restitution : {0.6, 0.8, 0.9, 0.95}) {
      if (pull == 1 && restitution == chaotic.restitution_lower) continue;
      Scene scene = chaotic;
      scene.pull *= pull;
      scene.restitution_lower = scene.restitution_upper = restitution;
      gaps.push_back(
          {fmt::format("its pull x {:g}, restitution {:g}", pull, restitution), scene, true});
    }
  }
  return gaps;
}

GrowthStudy study_growth(const GrowthPlan& plan) {
  GrowthStudy study{plan, {}, {}};
  for (const Case& a_case : all_cases()) {
    for (const double speed : plan.speeds) {
      const Scene scene = at_speed(scene_of(a_case, default_machine()), speed);
      study.rows.push_back({{fmt::format("{} at {:g} rad/s", a_case.id, speed), scene}, {}, {}});
    }
  }
  for (Driven& gap : shaken_gaps()) study.rows.push_back({std::move(gap), {}, {}});
  Progress progress("growth", static_cast<double>(study.rows.size()));
  tbb::parallel_for(std::size_t{0}, study.rows.size(), [&](std::size_t k) {
    GrowthRow& row = study.rows[k];
    for (const double turns : plan.turns) row.cells.push_back(growth_of(row.driven, turns));
    Driven longest = row.driven;
    longest.scene = in_window(row.driven, plan.turns.back());
    row.stretched = stretched_by_impact(longest);
    progress.advance(1);
  });
  study.grazes = study_grazes(plan.grazes);
  return study;
}

namespace {

/// The turns of the first window in which a condition holds.
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

/// For the first three shaken gaps and two cases.
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

/// For the paper's cases, and for the chaotic ones of the shaken gaps.
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
