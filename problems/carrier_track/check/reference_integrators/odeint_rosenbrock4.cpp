#include <boost/version.hpp>

#include "problems/carrier_track/check/reference_integrators/located_events.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/check/reference_integrators/penalty.h"
#include "problems/carrier_track/check/reference_integrators/rosenbrock_flight.h"
#include "problems/carrier_track/check/reference_integrators/rosenbrock_steps.h"

namespace ricochet::carrier_track::inline reference_integrators {

Integrator odeint_rosenbrock4() {
  return {"odeint-rosenbrock4", "Boost " BOOST_LIB_VERSION, "relative tolerance",
          [](const Scene& scene, double tolerance) {
            const auto method = rosenbrock_flight(flight_setting(scene), tolerance);
            return run_with_located_events(scene, *method);
          }};
}

Integrator penalty_odeint_rosenbrock4() {
  return penalty_integrator("odeint-rosenbrock4", "Boost " BOOST_LIB_VERSION, "relative tolerance",
                            rosenbrock_steps);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
