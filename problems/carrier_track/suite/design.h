#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"

/// The machine and its speed, designed together.
namespace ricochet::carrier_track::inline problems {

/// Indices of the variables in a design's point.
enum DesignVariable : std::size_t {
  design_speed,        ///< [rad/s]
  design_pull,         ///< [N]
  design_clearance,    ///< [m]
  design_friction,     ///< coefficient
  design_restitution,  ///< of both walls
  design_size
};

/// Reference values of a design's cost: those of the given machine.
struct DesignScale {
  double speed;      ///< [rad/s]
  double pull;       ///< [N]
  double pull_span;  ///< [N], width of the bounds
  double clearance;  ///< [m]
};

DesignScale design_scale(const Machine& machine);

/// The scene of a design.
template <class Scalar>
BasicScene<Scalar> designed(const Scene& machine, std::span<const Scalar> x) {
  const double nominal = machine.wall_upper - machine.wall_lower;
  BasicScene<Scalar> scene =
      scaled_clearance(Scalar(x[design_clearance] / constant<Scalar>(nominal)),
                       at_speed(lifted<Scalar>(machine), x[design_speed]));
  scene.pull = x[design_pull];
  scene.friction = x[design_friction];
  scene.restitution_lower = scene.restitution_upper = x[design_restitution];
  return scene;
}

/// The dimensionless terms of a design's cost; smooth within the bounds. One unit is the machine's
/// profit at its nominal speed.
template <class Scalar>
struct DesignCost {
  Scalar production;  ///< -speed / nominal: yarn is braided, and sold, in proportion to the speed
  Scalar precision;   ///< 0.5 nominal clearance / clearance: the cost of a tolerance grows with its
                      ///< reciprocal (Chase and Greenwood, Manuf. Rev. 1 (1988) 49)
  Scalar damping;  ///< 0.25 ln(1 / restitution): proportional to the number of damping layers, each
                   ///< of which keeps the same share of the speed
  Scalar heat;  ///< 0.5 friction (speed / nominal)^3: power of friction, under a contact force that
                ///< grows, like centrifugal force, with the square of the speed
  Scalar tension;  ///< ((pull - nominal) / span of its bounds)^2: a braid is made for one tension;
                   ///< the loss of quality grows with the squared deviation (Taguchi)

  Scalar sum() const { return production + precision + damping + heat + tension; }
};

/// The cost of a design: the sum of its terms.
template <class Scalar>
DesignCost<Scalar> design_cost(const DesignScale& scale, std::span<const Scalar> x) {
  using std::log;
  const auto number = [](double y) { return constant<Scalar>(y); };
  const Scalar speed = x[design_speed] / number(scale.speed);
  const Scalar departure = (x[design_pull] - number(scale.pull)) / number(scale.pull_span);
  return {-speed, number(0.5 * scale.clearance) / x[design_clearance],
          number(-0.25) * log(x[design_restitution]),
          number(0.5) * x[design_friction] * speed * speed * speed, departure * departure};
}

/// Minimise the cost subject to count <= quiet limit, without derivatives. The surrogate has them;
/// its constraint is to stay below the half_level of the limit. The machine must have two walls.
Problem design_count_problem(const Machine& machine);

/// Returns true if the machine has two walls: the problem varies the clearance.
bool has_clearance(const Machine& machine);

}  // namespace ricochet::carrier_track::inline problems
