#include "problems/carrier_track/motion/contact_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet::carrier_track::inline models {

namespace {

constexpr std::array events = {ContactEvent::turn, ContactEvent::release, ContactEvent::slack,
                               ContactEvent::grip, ContactEvent::horizon};

/// Number of rows of the midpoint rule's table with the least measured cost at a tolerance.
std::size_t midpoint_rows(double tolerance) {
  return tolerance > 3e-5 ? 3 : tolerance > 3e-9 ? 4 : 5;
}
std::size_t euler_rows(double tolerance) {
  return static_cast<std::size_t>(std::clamp(1.0 - 0.6 * std::log10(tolerance), 3.0,
                                             static_cast<double>(most_extrapolation_rows)));
}

/// Steps longer than this multiple of the contact's time scale use the implicit rule. Up to here
/// the explicit rule does not amplify an oscillation; beyond it the implicit rule damps one. With a
/// gap between the two, oscillations of the size of the tolerance would never decay.
double explicit_reach(double tolerance) {
  const std::size_t rows = midpoint_rows(tolerance);
  return rows == 3 ? 1.5 : rows == 4 ? 3.0 : 4.0;
}

/// The error of a stiff step may be this multiple of the tolerance. A stiff contact damps these
/// errors, and most of the estimate comes from oscillations as small as the tolerance, not from an
/// error. With a smaller multiple, steps would shrink to follow these oscillations.
constexpr double stiff_leniency = 100;

}  // namespace

void ContactMotion::begin(const ContactForce& force, double depth, double speed, double depth_scale,
                          double speed_scale) {
  force_ = force;
  const double twice = 2 * force.exponent;
  twice_exponent_ = twice == std::round(twice) && twice <= 4 ? static_cast<int>(twice) : 0;
  slack_ = false;
  state_ = {std::sqrt(depth), speed, 0};
  scale_ = {std::sqrt(depth_scale), speed_scale, depth_scale / speed_scale};
  length_ = 0.5 * scale_[0] / scale_[1];
}

double ContactMotion::spring(double root) const {
  switch (twice_exponent_) {
    case 2:
      return force_.stiffness * root * root;
    case 3:
      return force_.stiffness * root * root * root;
    case 4:
      return force_.stiffness * root * root * root * root;
    default:
      // NOTE: only trial steps go beyond d = 0; any smooth continuation will do.
      return std::copysign(force_.stiffness * std::pow(std::abs(root), 2 * force_.exponent), root);
  }
}

double ContactMotion::force(double root, double speed) const {
  if (slack_) return 0;
  const double elastic = spring(root);
  return elastic + force_.damping * speed * (force_.viscous ? 1.0 : elastic);
}

/// Inward acceleration by the applied forces and friction, `time` after the start of the step.
double ContactMotion::push_at(double time) const {
  const auto& [coefficient, reach] = push_->taylor;
  if (!(std::abs(time) < reach)) return push_->exact(time);
  double sum = coefficient.back();
  for (std::size_t k = coefficient.size() - 1; k-- > 0;) sum = sum * time + coefficient[k];
  return sum;
}

ExtrapolationState ContactMotion::rate(const State& state) const {
  ++*evaluations_;
  const double net = push_at(state[2]) - force(state[0], state[1]);
  return {state[1], 2 * state[0] * net, 2 * state[0]};
}

ContactMotion::Slopes ContactMotion::slopes() const {
  const double y = state_[0];
  const double u = state_[1];
  const double net = push_at(0) - force(y, u);
  const double jerk = push_->taylor.coefficient[1];
  if (slack_) return {2 * net, 0, 2 * y * jerk};
  const double elastic = spring(y);
  const double damped = 1 + (force_.viscous ? 0 : force_.damping * u);
  return {2 * net - 4 * force_.exponent * elastic * damped,
          -2 * y * force_.damping * (force_.viscous ? 1 : elastic), 2 * y * jerk};
}

double ContactMotion::stiffness_of(const Slopes& slopes) const {
  return std::abs(slopes.by_speed) + std::sqrt(std::abs(slopes.by_root));
}

ExtrapolationState ContactMotion::implicit(double length, int pieces) const {
  // (1 - h J) change = h f has one unknown, the change of u: the changes of y and t follow from it.
  const double h = length / pieces;
  const double by_root = slopes_.by_root + 2 * h * slopes_.by_time;
  const double divisor = 1 - h * (slopes_.by_speed + h * by_root);
  if (divisor < 0.1) return State{std::nan(""), 0, 0};
  State change{};
  State f = start_rate_;
  for (int piece = 0;; ++piece) {
    const double y = state_[0] + change[0];
    const double u = state_[1] + change[1];
    const double du = h * (f[1] + h * by_root * u + 2 * h * slopes_.by_time * y) / divisor;
    const double dy = h * (u + du);
    change[0] += dy;
    change[1] += du;
    change[2] += 2 * h * (y + dy);
    if (piece + 1 == pieces) return change;
    f = rate({state_[0] + change[0], state_[1] + change[1], state_[2] + change[2]});
  }
}

/// Sets `end` to the state after an extrapolated change, and returns its error as a share of the
/// tolerance.
double ContactMotion::judge(const Extrapolated& result, State& end) const {
  double error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    end[i] = state_[i] + result.change[i];
    const double size = scale_[i] + (i == 2 ? std::abs(result.change[2]) : 0.0);
    const double share = std::abs(result.error[i]) / (tolerance_ * size);
    if (std::isnan(share)) return share;
    error = std::max(error, share);
  }
  return error;
}

bool ContactMotion::is_stiff(double length) const {
  return length * stiffness_ > explicit_reach(tolerance_);
}

/// A step in s.
double ContactMotion::attempt(double length, State& end) const {
  if (is_stiff(length)) {
    const std::size_t rows = euler_rows(tolerance_);
    ExtrapolationTable table;
    for (std::size_t j = 0; j < rows; ++j) table[j] = implicit(length, euler_rule.pieces[j]);
    return judge(extrapolated(euler_rule, rows, table), end) / stiff_leniency;
  }
  const std::size_t rows = midpoint_rows(tolerance_);
  const auto f = [this](const State& at) { return rate(at); };
  return judge(extrapolated(midpoint_rule, rows, midpoint(f, state_, start_rate_, length, rows)),
               end);
}

/// A step in the function of an event, to its zero.
double ContactMotion::attempt_to(ContactEvent event, State& end) const {
  const auto divided = [&](const State& at, State f) {
    const double by = 1 / slope(event, at, f);
    for (double& x : f) x *= by;
    return f;
  };
  const auto f = [&](const State& at) { return divided(at, rate(at)); };
  const State start = divided(state_, start_rate_);
  const double length = -value(event, state_);
  const std::size_t rows = midpoint_rows(tolerance_);
  return judge(extrapolated(midpoint_rule, rows, midpoint(f, state_, start, length, rows)), end);
}

double ContactMotion::value(ContactEvent event, const State& state) const {
  switch (event) {
    case ContactEvent::turn:
      return direction_ * state[1];
    case ContactEvent::release:
      return state[0];
    case ContactEvent::horizon:
      return horizon_ - state[2];
    case ContactEvent::slack:
      return spring(state[0]) + force_.damping * state[1];
    case ContactEvent::grip:
      return -spring(state[0]) - force_.damping * state[1];
    case ContactEvent::none:
      break;
  }
  return 1;
}

double ContactMotion::slope(ContactEvent event, const State& state, const State& rate) const {
  switch (event) {
    case ContactEvent::turn:
      return direction_ * rate[1];
    case ContactEvent::release:
      return rate[0];
    case ContactEvent::horizon:
      return -rate[2];
    case ContactEvent::slack:
      return 2 * force_.stiffness * state[0] * rate[0] + force_.damping * rate[1];
    case ContactEvent::grip:
      return -2 * force_.stiffness * state[0] * rate[0] - force_.damping * rate[1];
    case ContactEvent::none:
      break;
  }
  return 0;
}

bool ContactMotion::passed(ContactEvent event, const State& state) const {
  switch (event) {
    case ContactEvent::turn:
      return value(event, state) < -0.1 * tolerance_ * scale_[1];  // else it is noise
    case ContactEvent::slack:
      return force_.viscous && force_.damping > 0 && !slack_ && value(event, state) < 0;
    case ContactEvent::grip:
      return slack_ && value(event, state) < 0;
    default:
      return value(event, state) < 0;
  }
}

/// The share in (0, 1] of a step at which the cubic through both ends has the event.
double ContactMotion::crossing(ContactEvent event, double length, const State& end) const {
  const double a = value(event, state_);
  const double b = value(event, end);
  const double da = length * slope(event, state_, start_rate_);
  const double db = length * slope(event, end, rate(end));
  double lower = 0;
  double upper = 1;
  for (int i = 0; i < 30; ++i) {
    const double x = 0.5 * (lower + upper);
    const double z = 1 - x;
    const double p = z * z * ((1 + 2 * x) * a + x * da) + x * x * ((1 + 2 * z) * b - z * db);
    (p > 0 ? lower : upper) = x;
  }
  return upper;
}

ContactEvent ContactMotion::first_event(double length, const State& end, double& share) const {
  ContactEvent first = ContactEvent::none;
  for (const ContactEvent event : events) {
    if (!passed(event, end)) continue;
    const double x = crossing(event, length, end);
    if (first != ContactEvent::none && x >= share) continue;
    first = event;
    share = x;
  }
  return first;
}

bool ContactMotion::passed_any(const State& state) const {
  return std::any_of(events.begin(), events.end(),
                     [&](ContactEvent event) { return passed(event, state); });
}

/// Steps to an event that the slope of its function predicts within `length`, if one step in the
/// function reaches it and it comes before any other event.
bool ContactMotion::step_to(ContactEvent event, double length) {
  const double left = -value(event, state_) / slope(event, state_, start_rate_);
  State end{};
  if (!(left > 0 && left < length) || !(attempt_to(event, end) <= 1) || passed_any(end)) {
    return false;
  }
  end_at(event, end);
  return true;
}

/// Ends a step of `length` to `end` at the first event within it, or before that event if it is too
/// far for one step in the event's function, or at `end` if there is no event.
ContactEvent ContactMotion::finish(double length, State end) {
  const double whole = length;
  for (;;) {
    double share = 1;
    const ContactEvent event = first_event(length, end, share);
    if (event == ContactEvent::none) {
      state_ = end;
      return event;
    }
    if (event == ContactEvent::turn && value(event, state_) < 0) {
      // The speed has passed zero within its noise: the body has turned.
      end_at(event, state_);
      return event;
    }
    length *= share;
    if (step_to(event, 2 * length)) return event;
    if (length < 1e-13 * whole) {
      end_at(event, end);
      return event;
    }
    length *= 0.8;
    attempt(length, end);
  }
}

void ContactMotion::end_at(ContactEvent event, const State& end) {
  state_ = end;
  if (event == ContactEvent::turn) state_[1] = 0;
  if (event == ContactEvent::release) state_[0] = 0;
  if (event == ContactEvent::horizon) state_[2] = horizon_;
  if (event == ContactEvent::slack) slack_ = true;
  if (event == ContactEvent::grip) slack_ = false;
}

void ContactMotion::update_scales() {
  scale_[0] = std::max(scale_[0], std::abs(state_[0]));
  scale_[1] = std::max(scale_[1], std::abs(state_[1]));
  scale_[2] = scale_[0] * scale_[0] / scale_[1];
}

ContactEvent ContactMotion::step(const ContactPush& push, int direction, double horizon,
                                 std::int64_t& evaluations) {
  push_ = &push;
  direction_ = direction;
  horizon_ = horizon;
  evaluations_ = &evaluations;
  state_[2] = 0;
  start_rate_ = rate(state_);
  slopes_ = slopes();
  stiffness_ = stiffness_of(slopes_);
  for (const ContactEvent event : {ContactEvent::turn, ContactEvent::release}) {
    if (!step_to(event, length_)) continue;
    update_scales();
    return event;
  }
  for (int rejected = 0; rejected < 200; ++rejected) {
    State end{};
    const double length = length_;
    const double error = attempt(length, end);
    const double order = static_cast<double>(is_stiff(length) ? euler_rows(tolerance_)
                                                              : 2 * midpoint_rows(tolerance_) - 1);
    const double factor = 0.85 * std::pow(std::max(error, 1e-12), -1 / order);
    if (error <= 1) {
      length_ *= std::clamp(factor, 0.3, 5.0);
      const ContactEvent event = finish(length, end);
      update_scales();
      return event;
    }
    length_ *= std::isnan(error) ? 0.1 : std::clamp(factor, 0.1, 0.7);
  }
  throw std::runtime_error("a contact cannot be integrated: no step is small enough");
}

Extrapolated extrapolated(const ExtrapolationRule& rule, std::size_t rows,
                          ExtrapolationTable table) {
  for (std::size_t j = 1; j < rows; ++j) {
    ExtrapolationState best = table[j];
    for (std::size_t m = 0; m < j; ++m) {
      const double weight = rule.weight[j][j - m - 1];
      for (std::size_t i = 0; i < 3; ++i) {
        const double next = best[i] + (best[i] - table[m][i]) * weight;
        table[m][i] = best[i];
        best[i] = next;
      }
    }
    table[j] = best;
  }
  Extrapolated result{table[rows - 1], {}};
  for (std::size_t i = 0; i < 3; ++i) result.error[i] = result.change[i] - table[rows - 2][i];
  return result;
}

}  // namespace ricochet::carrier_track::inline models
