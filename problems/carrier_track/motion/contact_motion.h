#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "problems/carrier_track/motion/flight.h"

/// Extrapolation of a simple integration rule to a high order, for three variables.
/// Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.9.
namespace ricochet::carrier_track::inline models {

inline constexpr std::size_t most_extrapolation_rows = 8;

using ExtrapolationState = std::array<double, 3>;

/// Changes of state over one step; each row divides the step into more pieces than the row before.
using ExtrapolationTable = std::array<ExtrapolationState, most_extrapolation_rows>;

/// The piece numbers and weights of a table.
struct ExtrapolationRule {
  std::array<int, most_extrapolation_rows> pieces{};
  /// 1 / (r - 1) of the Aitken-Neville scheme for each pair of rows; r is the ratio of their
  /// numbers of pieces, squared if the rule's error is a series in the square of the piece's
  /// length.
  std::array<std::array<double, most_extrapolation_rows>, most_extrapolation_rows> weight{};

  constexpr ExtrapolationRule(int spacing, bool even) {
    for (std::size_t j = 0; j < most_extrapolation_rows; ++j) {
      pieces[j] = 2 + spacing * static_cast<int>(j);
      for (std::size_t i = 0; i < j; ++i) {
        const double ratio = static_cast<double>(pieces[j]) / pieces[i];
        weight[j][i] = 1 / ((even ? ratio * ratio : ratio) - 1);
      }
    }
  }
};

/// Gragg's explicit midpoint rule in 2, 4, 6, ... pieces: k rows have order 2 k.
inline constexpr ExtrapolationRule midpoint_rule(2, true);

/// The linearly implicit Euler rule in 2, 3, 4, ... pieces: k rows have order k.
inline constexpr ExtrapolationRule euler_rule(1, false);

struct Extrapolated {
  ExtrapolationState change;
  ExtrapolationState error;  ///< estimated: the difference to one row less
};

/// Combines the first `rows` >= 2 rows of a table.
Extrapolated extrapolated(const ExtrapolationRule& rule, std::size_t rows,
                          ExtrapolationTable table);

/// The table of the midpoint rule over a step of `length` from `start`, where the state's rate is
/// `start_rate`; rate(state) is called pieces - 1 times a row. All rows advance together and are
/// independent, so that the processor works on several at a time.
template <class Rate>
ExtrapolationTable midpoint(Rate rate, const ExtrapolationState& start,
                            const ExtrapolationState& start_rate, double length, std::size_t rows) {
  ExtrapolationTable before{};
  ExtrapolationTable here;
  for (std::size_t j = 0; j < rows; ++j) {
    const double h = length / midpoint_rule.pieces[j];
    for (std::size_t i = 0; i < 3; ++i) here[j][i] = h * start_rate[i];
  }
  for (int piece = 1; piece < midpoint_rule.pieces[rows - 1]; ++piece) {
    for (std::size_t j = 0; j < rows; ++j) {
      if (midpoint_rule.pieces[j] <= piece) continue;
      const double h = length / midpoint_rule.pieces[j];
      const ExtrapolationState f =
          rate({start[0] + here[j][0], start[1] + here[j][1], start[2] + here[j][2]});
      for (std::size_t i = 0; i < 3; ++i) {
        const double next = before[j][i] + 2 * h * f[i];
        before[j][i] = here[j][i];
        here[j][i] = next;
      }
    }
  }
  return here;
}

/// Contact force over mass [m/s^2] at depth d [m] and rate d' [m/s]; see contact_law.h.
/// With spring = stiffness d^exponent it is spring + damping d' if viscous, else spring + spring
/// damping d'.
struct ContactForce {
  double stiffness;  ///< K/m
  double exponent;   ///< n
  double damping;    ///< D/v0 [s/m]; viscous: C/m [1/s]
  bool viscous;      ///< Kelvin-Voigt
};

/// The inward acceleration [m/s^2] by applied forces and friction over the time of a step [s].
struct ContactPush {
  Flight<double>::Taylor taylor;
  std::function<double(double)> exact;  ///< for times beyond the reach of the series
};

enum class ContactEvent {
  none,     ///< a step without an event
  turn,     ///< the velocity reaches zero
  release,  ///< the depth reaches zero
  slack,    ///< the force of a viscous contact becomes negative (the wall would pull)
  grip,     ///< the force becomes positive again
  horizon   ///< nothing happened before the time limit
};

/// Motion of a body in a wall under harmonic forces, friction and the contact force: steps of
/// automatic length to a relative tolerance, the last of which ends on an event.
///
/// The state is y = sqrt(d), u = d' and t, and the independent variable s has dt = 2 y ds:
///   dy/ds = u,   du/ds = 2 y (forces - contact force),   dt/ds = 2 y.
/// In these variables the solution is smooth through d = 0 for n = 1, 3/2, 2, ...; in t it has a
/// singularity there that reduces the order of every method. The depth also leaves zero at a finite
/// rate.
///
/// Steps are extrapolated: from the explicit midpoint rule (Gragg, Bulirsch, Stoer) if accuracy
/// limits the step, and from the linearly implicit Euler rule (Deuflhard's SEULEX) if the contact's
/// stiffness would limit it. A body at rest in a wall is therefore simulated with steps as long as
/// the forces allow. Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I,
/// II.9, and II, IV.9. The last step to an event uses the event's function as independent variable
/// (Henon 1982).
class ContactMotion {
 public:
  /// Tolerance per step, relative to the largest depth and speed of the contact so far; implicit
  /// steps use 100 times this value. Allowed: 1e-12..1e-2; below 1e-12 rounding is larger.
  explicit ContactMotion(double tolerance) : tolerance_(tolerance) {}

  /// Starts a contact at a depth [m] >= 0 with an inward speed [m/s]. The scales are the expected
  /// depth and speed.
  void begin(const ContactForce& force, double depth, double speed, double depth_scale,
             double speed_scale);

  /// One step under `push`, whose friction must act against `direction`, +1 inward, -1 outward, no
  /// longer than `horizon` [s]. Throws std::runtime_error if no step is small enough.
  ContactEvent step(const ContactPush& push, int direction, double horizon,
                    std::int64_t& evaluations);

  double depth() const { return state_[0] * state_[0]; }
  double speed() const { return state_[1]; }

  /// Duration [s] of the last step.
  double elapsed() const { return state_[2]; }

  /// Contact force over mass [m/s^2] on a body at this depth without velocity.
  double resting_force() const { return spring(state_[0]); }

 private:
  using State = ExtrapolationState;  // y, u, t

  /// Derivatives of du/ds.
  struct Slopes {
    double by_root, by_speed, by_time;
  };

  double spring(double root) const;
  double force(double root, double speed) const;
  double push_at(double time) const;
  State rate(const State& state) const;
  Slopes slopes() const;
  double stiffness_of(const Slopes& slopes) const;

  State implicit(double length, int pieces) const;
  double judge(const Extrapolated& result, State& end) const;
  bool is_stiff(double length) const;
  double attempt(double length, State& end) const;
  double attempt_to(ContactEvent event, State& end) const;

  double value(ContactEvent event, const State& state) const;
  double slope(ContactEvent event, const State& state, const State& rate) const;
  bool passed(ContactEvent event, const State& state) const;
  double crossing(ContactEvent event, double length, const State& end) const;
  ContactEvent first_event(double length, const State& end, double& share) const;
  bool passed_any(const State& state) const;
  bool step_to(ContactEvent event, double length);
  ContactEvent finish(double length, State end);
  void update_scales();
  void end_at(ContactEvent event, const State& end);

  double tolerance_;
  ContactForce force_{};
  int twice_exponent_ = 0;  // 0 unless it is a small integer
  bool slack_ = false;
  State scale_{};
  double length_ = 0;  // of the next step, in s

  // Of the current step.
  State state_{};
  State start_rate_{};
  Slopes slopes_{};
  double stiffness_ = 0;
  const ContactPush* push_ = nullptr;
  int direction_ = 0;
  double horizon_ = 0;
  std::int64_t* evaluations_ = nullptr;
};

}  // namespace ricochet::carrier_track::inline models
