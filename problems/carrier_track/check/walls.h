#pragma once

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/method.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// A run with more fixed steps than this is not started.
inline constexpr std::int64_t most_fixed_steps = 100'000'000;

/// The state after a step of that length [s] from a time of the system's flight [s].
using Rule = State (*)(const System& system, double time, const State& state, double length);

/// A method with error control as an integrator.
///
/// Between hard walls the discrete part of the motion is the same for all such methods:
/// - Impact: the velocity is reversed and multiplied by the restitution, and the method restarted.
/// - Rest: on a wall, unless the force leads away, once the rebound is at most slowest_rebound or
///   its height is lost in the rounding of the position; in the gap if the velocity is zero and
///   friction holds the body.
/// - Departure: when the applied force exceeds what friction and wall hold, detected by a sign
///   change between samples 1/64 of the shortest period apart and located to rounding. An excess
///   that lasts less than that is missed.
///
/// Through compliant walls it goes step by step, and does not locate the ends of contacts:
/// - A contact begins at a step that ends behind a wall and is over at one that ends before it. A
///   contact that begins and ends within a step is missed.
/// - Without a contact_speed, the damping of a contact is scaled with the speed at the beginning of
///   the step that enters it, at least resting_speed.
/// - The reported time and speed of an impact are those at which the state before that step, under
///   the force of that moment, reaches the wall: the error of the time is of the order of the step
///   cubed.
/// - A body further behind a wall than the gap is wide ends the run.
Integrator adaptive(const char* name, const char* version, const char* title, MakeMethod make);

/// A rule for equal steps as an integrator.
///
/// Between hard walls it goes the common way: if a step ends behind a wall, the body is put on the
/// wall at the end of the step, and its velocity is reversed and multiplied by the restitution. At
/// rest the body sticks while friction and wall hold it, checked at the start of every step. It
/// rests on a wall, unless the force leads away, once the rebound is at most slowest_rebound or the
/// change of velocity by the force in a step, so that its flight would end within two steps.
///
/// Through compliant walls it goes as a method with error control does.
Integrator stepped(const char* name, const char* title, Rule rule);

/// Makes a spring and a damper (Kelvin-Voigt, which pulls at a body that leaves the wall) of each
/// hard wall, by the share of the clearance that the fastest body gets deep. That share of its
/// speed is where friction is tanh(1) of its limit, and a tenth of it the relative tolerance of the
/// method: a tighter one is lost in the rounding of a body at rest in a stiff spring.
Integrator with_springs(const char* name, const char* version, const char* title, MakeMethod make);

/// `integrator` with its processor time measured, and with what it throws as a failure.
Integrator measured(Integrator integrator);

/// Equal steps that fill a window, none longer than requested.
struct StepPlan {
  std::int64_t count;
  double length;  ///< [s]
};

/// Throws std::runtime_error for more than most_fixed_steps.
StepPlan equal_steps(double window, double longest);

/// The velocity after friction has acted for a step: it moves towards zero by `change` [m/s], but
/// not beyond. This is implicit, set-valued friction: a body sticks while the applied force is no
/// larger.
inline double after_friction(double velocity, double change) {
  return std::copysign(std::max(std::abs(velocity) - change, 0.0), velocity);
}

/// Adds an impact. Throws std::runtime_error for more than most_impacts.
void add_impact(Outcome& outcome, double time, Wall wall, double speed);

// The integrators but for the event-driven one, which integrator.cpp lists.
Integrator odeint_dopri5();
Integrator odeint_rosenbrock4();
Integrator cvode_adams();
Integrator cvode_bdf();
Integrator semi_implicit_euler();
Integrator runge_kutta_4();
Integrator moreau_jean();
Integrator penalty();

}  // namespace ricochet::carrier_track::inline reference_integrators
