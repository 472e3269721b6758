#include "problems/carrier_track/check/reference_integrators/rosenbrock_flight.h"

#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <utility>

#include "problems/carrier_track/check/reference_integrators/dense_flight.h"
#include "problems/carrier_track/check/reference_integrators/rosenbrock.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

using namespace rosenbrock;

class RosenbrockFlight : public FlightMethod {
 public:
  RosenbrockFlight(const FlightSetting& setting, double tolerance)
      : setting_(setting),
        stepper_(Controller(tolerance * setting.length, tolerance,
                            longest_step(setting.forces, setting.window))),
        step_(0.1 * longest_step(setting.forces, setting.window)),
        longest_(step_),
        workspace_(2) {}

  Landing fly(const Leg& leg) override {
    const double friction = leg.direction * setting_.forces.friction;
    const auto pull = [&](double time) {
      ++evaluations_;
      return setting_.forces.applied(leg.start + time) - friction;
    };
    const auto slope = [&](const Vector& x, Vector& dxdt, double time) {
      dxdt[0] = x[1];
      dxdt[1] = pull(time);
    };
    const auto jacobian = [&](const Vector& /*x*/, Matrix& j, double time, Vector& dfdt) {
      j(0, 0) = 0;
      j(0, 1) = 1;
      j(1, 0) = 0;
      j(1, 1) = 0;
      dfdt[0] = 0;
      dfdt[1] = setting_.forces.applied_rate(leg.start + time);
    };
    // NOTE: the dense output is only as good as the tolerance, and a rebound much shorter than the
    // step is lost in it: without this limit a Zeno sequence goes on forever as noise.
    step_ = std::min(step_, longest_);
    const Landing landing = fly_dense(stepper_, std::make_pair(slope, jacobian), pull, setting_.gap,
                                      setting_.forces.friction > 0, leg, workspace_, step_, steps_);
    if (landing.duration > 0) longest_ = 2 * landing.duration;
    return landing;
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  FlightSetting setting_;
  boost::numeric::odeint::rosenbrock4_dense_output<Controller> stepper_;
  double step_;     // [s], proposed by the stepper
  double longest_;  // [s], the first step of the next leg
  Vector workspace_;
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace

std::unique_ptr<FlightMethod> rosenbrock_flight(const FlightSetting& setting, double tolerance) {
  return std::make_unique<RosenbrockFlight>(setting, tolerance);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
