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
  LyapunovStudy study{plan, {}, {}, 0, 0, {}, {}};
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
  Scene shaken = benchmark_scene("mild", 1);
  study.restitution = shaken.restitution_lower;
  study.period = 2 * std::numbers::pi / shaken.disturbance_frequency;
  shaken.window = Seconds{10 * plan.turns * study.period};
  const double amplitude =
      shaken.disturbance / shaken.mass / std::pow(shaken.disturbance_frequency, 2);
  for (const double gap : plan.gaps) {
    shaken.wall_upper = gap * amplitude;
    shaken.start_position = 0.5 * shaken.wall_upper;
    study.shaken.push_back(sensitivity_of(shaken));
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

using report::Json;

using std::numbers::pi;
const double all_digits = 53 * std::log10(2.0);  // of a double: 15.95

/// Digits lost by a motion; null if it loses all.
Json digits_of(const Sensitivity& motion) {
  return motion.chaotic() ? Json() : Json(motion.digits_lost);
}

/// By impact, as far as it is drawn.
Json drawn_digits(const Course& course) {
  Json drawn = Json::array();
  for (const double digits : course.digits_lost) {
    if (digits > 22) break;
    drawn.push_back(std::max(digits, -2.0));
  }
  return drawn;
}

/// Growth per period of the shaking over the gap, with the values of closed forms.
Json shaken_data(const LyapunovStudy& study) {
  Json gaps = Json::array();
  for (std::size_t k = 0; k < study.shaken.size(); ++k) {
    const Sensitivity& shaken = study.shaken[k];
    gaps.push_back({{"gap", study.plan.gaps[k]},
                    {"growth", shaken.growth * study.period},
                    {"rests", !shaken.exponent()}});
  }
  const double rho = (1 - study.restitution) / (1 + study.restitution);
  return {{"gaps", std::move(gaps)},
          {"growth", 2 * std::log(study.restitution)},
          {"stable_from", (pi * pi - 4) / std::hypot(2, pi * rho)},
          {"stable_to", std::hypot(pi, 2 * rho) / rho}};
}

/// All motions of the paper's cases together.
Json cases_data(const LyapunovStudy& study) {
  int runs = 0, chaotic = 0, forgetting = 0;
  double digits = 0, speed = 0;  // worst case, and its speed [rad/s]
  std::string worst;
  double least_rests = 1e300, most_rests = 0;  // per turn, if there are several
  for (std::size_t c = 0; c < study.cells.size(); ++c) {
    for (std::size_t s = 0; s < study.cells[c].size(); ++s) {
      const Sensitivity& cell = study.cells[c][s];
      ++runs;
      chaotic += cell.chaotic();
      forgetting += !cell.exponent();
      if (cell.digits_lost > digits) {
        digits = cell.digits_lost;
        speed = study.plan.speeds[s];
        worst = study.cases[c];
      }
      const double rests = cell.rests_on_wall * 2 * pi / study.plan.speeds[s];
      if (rests * study.plan.turns < 1.5) continue;
      least_rests = std::min(least_rests, rests);
      most_rests = std::max(most_rests, rests);
    }
  }
  return {{"runs", runs},
          {"chaotic", chaotic},
          {"any_chaotic", chaotic > 0},
          {"forgetting", forgetting},
          {"all_forget", forgetting == runs},
          {"worst", {{"case", worst}, {"speed", speed}, {"digits", digits}}},
          {"no_chance", chaotic == 0 && digits < 0.5 * all_digits},
          {"least_rests", least_rests},
          {"most_rests", most_rests}};
}

Json data_of(const Course& course) {
  const Sensitivity& sensitivity = course.sensitivity;
  const double digits = sensitivity.growth / sensitivity.impacts / std::numbers::ln10;
  std::vector<int> parted = course.parted;
  std::sort(parted.begin(), parted.end());
  const bool any = !parted.empty();
  return {{"motion", course.name},
          {"impacts", course.impacts},
          {"digits_an_impact", digits},
          {"left_after_30", all_digits - 30 * digits},
          {"digits_at_worst", sensitivity.digits_lost},
          {"trusted", sensitivity.digits_lost <= all_digits},
          {"foretold", sensitivity.impacts_foretold()},
          {"parted", parted.size()},
          {"first_parted", any ? Json(parted.front()) : Json()},
          {"half_parted", any ? Json(parted[parted.size() / 2]) : Json()}};
}

}  // namespace

Json data_of(const LyapunovStudy& study) {
  const std::vector<double>& speeds = study.plan.speeds;
  const auto course_data = [](const Course& course) { return data_of(course); };
  const auto losses_of = [](const Course& course) -> Json {
    return {{"motion", course.name}, {"digits", drawn_digits(course)}};
  };
  const Json courses = report::list_of(study.courses, course_data);
  Json digits = Json::array();
  for (std::size_t c = 0; c < study.cases.size(); ++c) {
    digits.push_back(
        {{"case", study.cases[c]}, {"digits", report::list_of(study.cells[c], digits_of)}});
  }
  return {{"speeds",
           {{"tried", speeds.size()},
            {"first", speeds.front()},
            {"last", speeds.back()},
            {"all", speeds}}},
          {"turns", study.plan.turns},
          {"pairs", study.plan.starts},
          {"cases", cases_data(study)},
          {"lively", courses.front()},
          {"chaotic", courses.back()},
          {"courses", courses},
          {"all_digits", all_digits},
          {"losses", report::list_of(study.courses, losses_of)},
          {"digits", std::move(digits)},
          {"shaken", shaken_data(study)}};
}

}  // namespace ricochet::studies::dynamics
