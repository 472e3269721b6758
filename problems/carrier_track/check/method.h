#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

// NOTE: plain C++17: Boost.Odeint's rosenbrock4 does not compile as C++20, and scene.h needs
// concepts.
namespace ricochet::carrier_track::inline scene {

template <class Scalar>
struct BasicScene;

}  // namespace ricochet::carrier_track::inline scene

namespace ricochet::carrier_track::inline reference_integrators {

struct State {
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// The applied forces of a scene, without contact and friction, divided by its mass: those of
/// push.h, in double precision.
class Forces {
 public:
  /// Of a valid scene.
  explicit Forces(const BasicScene<double>& scene);

  /// The acceleration [m/s^2] at a time [s]; of the smooth piece that the time `in` is in,
  /// continued beyond its ends. Counts as an evaluation.
  double applied(double time, double in) const {
    ++evaluations_;
    const Piece& piece = at(in);
    const double u = time - piece.from;
    double sum = at(piece.steady, u);
    for (const Term& term : piece.waves) sum += at(term.amplitude, u) * std::cos(at(term.phase, u));
    return sum;
  }
  double applied(double time) const { return applied(time, time); }

  /// Its derivative with respect to time [m/s^3].
  double applied_rate(double time, double in) const;

  /// Bound on the acceleration [m/s^2].
  double strongest() const { return strongest_; }

  /// [s], of the fastest wave; infinite without one.
  double shortest_period() const { return shortest_period_; }

  /// The end of the smooth piece that a time [s] is in; infinite if it is the last one.
  double smooth_until(double time) const;

  std::int64_t evaluations() const { return evaluations_; }

 private:
  using Polynomial = std::array<double, 3>;
  struct Term {
    Polynomial amplitude, phase;
  };
  struct Piece {
    double from;  // [s]
    Polynomial steady;
    std::vector<Term> waves;
  };

  static double at(const Polynomial& p, double u) { return p[0] + u * (p[1] + u * p[2]); }
  static double slope(const Polynomial& p, double u) { return p[1] + 2 * u * p[2]; }
  const Piece& at(double time) const {
    std::size_t k = pieces_.size() - 1;
    while (k > 0 && time < pieces_[k].from) --k;
    return pieces_[k];
  }

  std::vector<Piece> pieces_;
  double strongest_ = 0;
  double shortest_period_;
  mutable std::int64_t evaluations_ = 0;
};

/// The force of two compliant walls divided by the mass [m/s^2], as a function of the state: the
/// laws of contact_law.h, without events.
struct WallForce {
  struct Slopes {
    double by_position;  ///< [1/s^2]
    double by_velocity;  ///< [1/s]
  };

  double lower = 0, upper = 0;                  ///< [m], the walls; upper may be infinite
  double stiffness = 0;                         ///< K/m
  double exponent = 1;                          ///< n
  bool viscous = false;                         ///< Kelvin-Voigt
  bool pulls = false;                           ///< if viscous, at a body that leaves the wall
  double lower_damping = 0, upper_damping = 0;  ///< D, or C/m [1/s] if viscous
  double speed = 1;                             ///< [m/s], v0 of the law

  /// Penetration [m], <= 0 between the walls.
  double depth(double position) const { return std::max(lower - position, position - upper); }

  double operator()(const State& state) const;
  Slopes slopes(const State& state) const;
};

/// The walls of a valid scene with compliant walls; `speed` is its contact_speed, or 1 m/s.
WallForce wall_force_of(const BasicScene<double>& scene);

/// The equation of motion that a method integrates, and its scales.
struct System {
  /// Of a valid scene. Compliant walls are part of it; hard ones end a flight.
  explicit System(const BasicScene<double>& scene);

  Forces forces;
  double lower, upper;            ///< [m], the walls; the upper one may be at infinity
  double window;                  ///< [s]
  double length;                  ///< [m], the width of the gap; if it is infinite, the start's
                                  ///< height above the lower wall, or 1 m on that wall
  std::optional<WallForce> wall;  ///< compliant walls
  double friction;                ///< [m/s^2], >= 0
  double creep = 0;               ///< [m/s]; > 0: friction is smooth, friction tanh(x' / creep)

  // Of the flight that a method is in.
  double start = 0;   ///< [s], of the window's time
  int direction = 0;  ///< of motion, against which set-valued friction acts; 0: the whole window

  /// The applied acceleration [m/s^2], `time` [s] after the flight's start. A flight knows that of
  /// the smooth piece alone in which it starts.
  double applied(double time) const {
    return forces.applied(start + time, direction != 0 ? start : start + time);
  }
  double applied_rate(double time) const {
    return forces.applied_rate(start + time, direction != 0 ? start : start + time);
  }

  /// The acceleration [m/s^2] but for set-valued friction.
  double pushed(double time, const State& state) const {
    double sum = applied(time);
    if (wall) sum += (*wall)(state);
    if (creep > 0) sum -= friction * std::tanh(state.velocity / creep);
    return sum;
  }
  double acceleration(double time, const State& state) const {
    return pushed(time, state) - direction * friction;
  }
  /// Its derivatives with respect to the state.
  WallForce::Slopes slopes(const State& state) const;

  /// The longest step [s]: half a period. Two velocity zeros in one step, which event location
  /// would miss, are then rare, and an error estimate cannot mistake a whole period for a constant
  /// force.
  double longest_step() const { return std::min(window, 0.5 * forces.shortest_period()); }
};

/// A flight without impact, which starts at rest or moves in `direction`. With friction it must end
/// at zero velocity; without, the body may turn and continue.
struct Leg {
  double start;    ///< [s] from the start of the window
  State state;     ///< within the gap
  int direction;   ///< +1 or -1
  double longest;  ///< [s], > 0; the rest of the window, or of a piece of the forces
};

enum class Finish { lower_wall, upper_wall, turn, limit };

struct Landing {
  Finish finish;
  double duration;  ///< [s] from the start of the leg
  State state;      ///< as integrated, so slightly off the wall or off zero velocity
};

/// A method that takes more steps than this in a run is stopped.
inline constexpr std::int64_t most_steps = 1'000'000;

/// A step-by-step integrator of a System, which must outlive it. One object serves all flights of a
/// run, so that it keeps its memory and history.
class Method {
 public:
  explicit Method(System& system) : system_(system) {}
  virtual ~Method() = default;

  /// Begins at time 0 of a flight of the system.
  virtual void start(const State& state) = 0;

  /// Takes one accepted step, and returns the time of its end [s], which may be behind the window.
  /// Throws std::runtime_error if the method fails.
  virtual double step() = 0;

  /// The state at a time of the last step; methods of fixed steps know that at its end alone.
  virtual State at(double time) = 0;

  /// Flies to the first event, found by sign changes of the dense output at(). Throws
  /// std::runtime_error if the method fails or needs more than most_steps in all.
  virtual Landing fly(const Leg& leg);

 protected:
  System& system_;
  std::int64_t steps_ = 0;  // of all flights
  double last_flight_ = 0;  // [s], how long it was; 0: none
};

/// Makes a method of a relative tolerance; absolute tolerances are that times the system's length
/// (and [m/s] alike). Or one of a step [s].
using MakeMethod = std::function<std::unique_ptr<Method>(System&, double setting)>;

/// Boost.Odeint's rosenbrock4. In a file of its own, because its source must be C++17.
std::unique_ptr<Method> rosenbrock(System& system, double tolerance);

}  // namespace ricochet::carrier_track::inline reference_integrators
