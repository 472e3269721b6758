#include "src/studies/dynamics/lyapunov.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {

namespace {

using namespace carrier_track;

/// [rad/s]; of the forces that are not zero.
double fastest_rate(const Scene& scene) {
  return std::max(scene.omega, scene.disturbance != 0 ? scene.disturbance_frequency : 0.0);
}

template <class Scalar>
bool rests(const Motion<Scalar>& motion) {
  return motion.velocity == 0 && motion.acceleration == 0;
}

/// Propagates a difference along a simulation. Its length is normalised to one and the logarithms
/// of the factors are summed, so that windows of any length are possible.
class Tangent : public Observer {
 public:
  Tangent(const Scene& scene, const Difference& start)
      : scene_(scene), rate_(fastest_rate(scene)), difference_(start) {
    shorten();
  }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    const Motion<double> start = path.at(0.0);
    if (struck_ && rests(start)) forget();
    if (struck_ && !forgotten_) leap_at_wall(start);
    if (moving_ && !struck_) difference_.velocity *= start.acceleration / acceleration_;
    const Motion<double> end = path.at(duration);
    if (rests(end)) difference_.velocity = 0;  // also for a start at rest: friction holds both
    if (forgotten_ && !rests(end)) begin_anew();
    difference_.position += duration * difference_.velocity;
    moving_ = !rests(end);
    acceleration_ = end.acceleration;
    struck_ = false;
    time_ = time + duration;
    if (!forgotten_) shorten();
  }

  void impact(double /*time*/, Wall wall, double speed) {
    ++impacts_;
    struck_ = true;
    restitution_ = wall == Wall::upper ? upper_restitution(scene_) : lower_restitution(scene_);
    velocity_ = wall == Wall::upper ? speed : -speed;
  }

  double time() const { return time_; }  // [s], where the last flight ended
  std::int64_t impacts() const { return impacts_; }
  std::int64_t rests_on_wall() const { return rests_on_wall_; }
  double growth() const { return earlier_ + growth_; }  // of ln(length), in total
  double growth_since_rest() const { return growth_; }
  double largest_growth() const { return largest_; }  // since a rest or the start

  /// Since the start, if the body has not rested on a wall.
  Difference difference() const {
    const double length = std::exp(growth_);
    return {length * difference_.position, length * difference_.velocity};
  }

 private:
  void leap_at_wall(const Motion<double>& after) {
    const double earlier = difference_.position / velocity_;  // how much sooner it arrives [s]
    difference_.position *= -restitution_;
    difference_.velocity *= -restitution_;
    if (velocity_ == 0) return;
    difference_.velocity += (after.acceleration + restitution_ * acceleration_) * earlier;
  }

  void forget() {
    ++rests_on_wall_;
    forgotten_ = true;
    difference_ = {0, 0};
  }

  /// Restarts with an arbitrary difference, such as a rounding error.
  void begin_anew() {
    earlier_ += growth_;
    forgotten_ = false;
    difference_ = {1, rate_};
    shorten();
    growth_ = 0;
  }

  void shorten() {
    const double length = std::hypot(difference_.position, difference_.velocity / rate_);
    growth_ += std::log(length);
    difference_.position /= length;
    difference_.velocity /= length;
    if (time_ > 0) largest_ = std::max(largest_, growth_);
  }

  const Scene& scene_;
  double rate_;  // [rad/s]
  Difference difference_;
  double growth_ = 0;
  double earlier_ = 0;  // growth before the last rest on a wall
  double largest_ = 0;
  double time_ = 0;
  std::int64_t impacts_ = 0;
  std::int64_t rests_on_wall_ = 0;
  bool forgotten_ = false;
  bool moving_ = false;      // at the end of the last flight
  double acceleration_ = 0;  // there [m/s^2]
  bool struck_ = false;      // since
  double restitution_ = 0;   // of that impact
  double velocity_ = 0;      // and its approach [m/s]
};

/// A difference of length one.
Difference any_difference(const Scene& scene) {
  return {std::sqrt(0.5), std::sqrt(0.5) * fastest_rate(scene)};
}

/// Records growth and impacts at the ends of the parts of a window.
class GrowthByPart : public Tangent {
 public:
  static constexpr std::size_t parts = 10;
  struct Mark {
    double growth;
    std::int64_t impacts;
  };

  explicit GrowthByPart(const Scene& scene)
      : Tangent(scene, any_difference(scene)),
        settled_(0.1 * duration_of(scene)),
        part_(0.9 * duration_of(scene) / parts) {}

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    Tangent::stretch(time, path, duration);
    while (marks_.size() < parts &&
           Tangent::time() >= settled_ + static_cast<double>(marks_.size()) * part_) {
      marks_.push_back({growth(), impacts()});
    }
  }

  /// To be called after the simulation.
  Sensitivity sensitivity() {
    marks_.push_back({growth(), impacts()});
    const double window = part_ * parts;
    const Mark& first = marks_.front();
    const Mark& last = marks_.back();
    Sensitivity result{};
    result.growth = (last.growth - first.growth) / window;
    result.impacts = static_cast<double>(last.impacts - first.impacts) / window;
    double squares = 0;
    for (std::size_t k = 1; k < marks_.size(); ++k) {
      const double apart = (marks_[k].growth - marks_[k - 1].growth) / part_ - result.growth;
      squares += apart * apart;
    }
    result.growth_error = std::sqrt(squares / (parts * (parts - 1)));
    result.rests_on_wall = static_cast<double>(rests_on_wall()) / Tangent::time();
    result.digits_lost = largest_growth() / std::numbers::ln10;
    return result;
  }

 private:
  double settled_, part_;  // [s]
  std::vector<Mark> marks_;
};

class GrowthByImpact : public Tangent {
 public:
  GrowthByImpact(const Scene& scene, std::size_t impacts)
      : Tangent(scene, any_difference(scene)), most_(impacts) {}

  void impact(double time, Wall wall, double speed) {
    if (digits.size() < most_) digits.push_back(growth_since_rest() / std::numbers::ln10);
    Tangent::impact(time, wall, speed);
  }

  std::vector<double> digits;

 private:
  std::size_t most_;
};

std::vector<Impact> impacts_of(const Scene& scene) {
  struct Collector : Observer {
    void impact(double time, Wall wall, double speed) { impacts.push_back({time, wall, speed}); }
    std::vector<Impact> impacts;
  } collector;
  simulate(scene, collector);
  return collector.impacts;
}

Course course_of(std::string name, const Scene& scene, int starts) {
  constexpr std::size_t shown = 400;
  const Sensitivity sensitivity = sensitivity_of(scene);
  Course course{std::move(name),
                sensitivity,
                sensitivity.impacts * duration_of(scene),
                digits_lost_by_impact(scene, shown),
                {}};
  for (int k = 0; k < starts; ++k) {
    Scene start = scene;
    start.start_velocity *= 1 + 0.01 * k;
    if (const auto parted = impacts_until_parted(start)) course.parted.push_back(*parted);
  }
  return course;
}

}  // namespace

std::optional<Difference> carried(const Scene& scene, const Difference& start) {
  Tangent tangent(scene, start);
  simulate(scene, tangent);
  if (tangent.rests_on_wall() > 0) return std::nullopt;
  return tangent.difference();
}

std::optional<double> Sensitivity::impacts_foretold() const {
  if (!(growth > 3 * growth_error && impacts > 0)) return std::nullopt;
  return 53 * std::numbers::ln2 * impacts / growth;
}

Sensitivity sensitivity_of(const Scene& scene) {
  GrowthByPart growth(scene);
  simulate(scene, growth);
  return growth.sensitivity();
}

std::vector<double> digits_lost_by_impact(const Scene& scene, std::size_t impacts) {
  GrowthByImpact growth(scene, impacts);
  simulate(scene, growth);
  return growth.digits;
}

std::optional<int> impacts_until_parted(const Scene& scene) {
  Scene beside = scene;
  beside.start_velocity *= 1 + std::numeric_limits<double>::epsilon();
  const std::vector<Impact> one = impacts_of(scene);
  const std::vector<Impact> other = impacts_of(beside);
  const std::size_t both = std::min(one.size(), other.size());
  const double apart = 0.1 * duration_of(scene) / static_cast<double>(both);
  for (std::size_t k = 0; k < both; ++k) {
    if (one[k].wall != other[k].wall || std::abs(one[k].time - other[k].time) > apart) {
      return static_cast<int>(k);
    }
  }
  return std::nullopt;
}

LyapunovStudy study_lyapunov(const LyapunovPlan& plan) {
  LyapunovStudy study{plan, {}, {}, {}};
  const std::vector<Case> cases = all_cases();
  Progress progress("chaos", static_cast<double>(cases.size()));
  for (const Case& the_case : cases) {
    study.cases.push_back(the_case.id);
    auto& row = study.cells.emplace_back();
    Scene scene = scene_of(the_case, default_machine());
    scene.window = Revolutions{plan.turns};
    for (const double omega : plan.speeds) row.push_back(sensitivity_of(at_speed(scene, omega)));
    progress.advance(1);
  }
  constexpr double omega = 10;
  for (const char* id : {"C2", "C10"}) {
    Scene scene = scene_of(find_case(id), default_machine());
    scene.omega = omega;
    scene.window = Revolutions{plan.turns};
    study.courses.push_back(
        course_of(fmt::format("{} at {} rad/s", id, omega), scene, plan.starts));
  }
  study.courses.push_back(
      course_of("chaotic scene", benchmark_scene("chaotic", plan.turns), plan.starts));
  return study;
}

namespace {

using report::Chart;
using report::Direction;
using report::Mark;
using report::Series;

using std::numbers::pi;
const double all_digits = 53 * std::log10(2.0);      // of a double: 15.95
constexpr double most_drawn = 22, least_drawn = -2;  // digits

/// All motions of the paper's cases together.
struct CaseMotions {
  int runs = 0, chaotic = 0, forgetting = 0;
  double digits = 0, speed = 0;                ///< lost by the worst motion, and its speed [rad/s]
  std::string worst;                           ///< its case
  double least_rests = 1e300, most_rests = 0;  ///< a turn, if there are several
};

CaseMotions motions_of(const LyapunovStudy& study) {
  CaseMotions all;
  for (std::size_t c = 0; c < study.cells.size(); ++c) {
    for (std::size_t s = 0; s < study.cells[c].size(); ++s) {
      const Sensitivity& cell = study.cells[c][s];
      ++all.runs;
      all.chaotic += cell.chaotic();
      all.forgetting += !cell.exponent();
      if (cell.digits_lost > all.digits) {
        all.digits = cell.digits_lost;
        all.speed = study.plan.speeds[s];
        all.worst = study.cases[c];
      }
      const double rests = cell.rests_on_wall * 2 * pi / study.plan.speeds[s];
      if (rests * study.plan.turns < 1.5) continue;
      all.least_rests = std::min(all.least_rests, rests);
      all.most_rests = std::max(all.most_rests, rests);
    }
  }
  return all;
}

std::string finding_of(const LyapunovStudy& study, const CaseMotions& all) {
  const bool by_chance = all.chaotic > 0 || all.digits >= 0.5 * all_digits;
  return fmt::format(
      "{} of {} motions of the paper's cases are chaotic ({} cases at {} speeds from {:g} to {:g} "
      "rad/s, {:g} turns each). In {} of them the carrier rests on a wall, and there forgets its "
      "start entirely, in {} it never does; before, it loses {:.1f} of 16 digits at worst, in {} "
      "at {:g} rad/s.{}",
      all.chaotic, all.runs, study.cases.size(), study.plan.speeds.size(),
      study.plan.speeds.front(), study.plan.speeds.back(), study.plan.turns, all.forgetting,
      all.runs - all.forgetting, all.digits, all.worst, all.speed,
      by_chance ? ""
                : " So no count is a matter of chance: where a count jumps, an impact has crossed "
                  "the counting limit or the end of the window.");
}

/// Digits that each case loses at each speed; nothing where it loses all.
Chart digits_chart(const LyapunovStudy& study, const CaseMotions& all) {
  Chart chart{.name = "lyapunov-digits",
              .title = fmt::format("At worst {:.1f} of 16 digits of the start are lost, in {} at "
                                   "{:g} rad/s",
                                   all.digits, all.worst, all.speed),
              .x = {"speed [rad/s]"},
              .y = {"case"},
              .heat_map = report::HeatMap{"digits lost", {}, report::Range{0, 16}},
              .width = 860,
              .height = 420};
  for (const double speed : study.plan.speeds)
    chart.x.categories.push_back(fmt::format("{:g}", speed));
  for (std::size_t c = study.cases.size(); c-- > 0;) {
    chart.y.categories.push_back(study.cases[c]);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const Sensitivity& cell : study.cells[c])
      row.push_back(cell.chaotic() ? std::nullopt : std::optional(cell.digits_lost));
  }
  return chart;
}

Chart courses_chart(const LyapunovStudy& study) {
  const Sensitivity& chaotic = study.courses.back().sensitivity;
  Chart chart{.name = "lyapunov-courses",
              .title = fmt::format("The chaotic scene loses {:.2f} digits an impact; the paper's "
                                   "cases forget at every rest",
                                   chaotic.growth / chaotic.impacts / std::numbers::ln10),
              .x = {"impacts since the start"},
              .y = {.label = "decimal digits of the start lost",
                    .range = report::Range{least_drawn, most_drawn}},
              .lines = {{Direction::horizontal, all_digits, "nothing left of 16 digits"}},
              .width = 640,
              .height = 360};
  for (const Course& course : study.courses) {
    Series& series = chart.series.emplace_back(Series{course.name, Mark::line, {}});
    for (const double digits : course.digits_lost) {
      if (digits > most_drawn) break;
      series.samples.push_back(
          {static_cast<double>(series.samples.size()), std::max(digits, least_drawn)});
    }
  }
  return chart;
}

}  // namespace

void add_to(report::Results& results, const LyapunovStudy& study) {
  Table courses{"lyapunov-courses",
                {{"motion"},
                 {"digits_an_impact", "digits lost an impact", ".3f"},
                 {"digits_at_worst", "at worst before a rest", ".1f"},
                 {"foretold", "all lost by impact", ".0f"},
                 {"parted", "pairs of runs that part"},
                 {"first_parted", "the first at impact"},
                 {"half_parted", "half by impact"}}};
  for (const Course& course : study.courses) {
    const Sensitivity& sensitivity = course.sensitivity;
    std::vector<int> parted = course.parted;
    std::sort(parted.begin(), parted.end());
    const bool any = !parted.empty();
    courses.add(
        course.name, sensitivity.growth / sensitivity.impacts / std::numbers::ln10,
        sensitivity.digits_lost,
        sensitivity.digits_lost > all_digits ? sensitivity.impacts_foretold() : std::nullopt,
        parted.size(), any ? std::optional(parted.front()) : std::nullopt,
        any ? std::optional(parted[parted.size() / 2]) : std::nullopt);
  }
  const CaseMotions all = motions_of(study);
  results.set("chaos-finding", finding_of(study, all));
  results.set("least-rests", all.most_rests > 0 ? std::optional(all.least_rests) : std::nullopt);
  results.set("most-rests", all.most_rests > 0 ? std::optional(all.most_rests) : std::nullopt);
  results.set("pairs", study.plan.starts);
  results.add(std::move(courses));
  results.add(digits_chart(study, all));
  results.add(courses_chart(study));
}

}  // namespace ricochet::studies::dynamics
