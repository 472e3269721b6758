#include "problems/carrier_track/integrators/integrator.h"

#include "problems/carrier_track/integrators/methods.h"

namespace ricochet::carrier_track {

std::vector<Integrator> all_integrators() {
  return {event_driven(), odeint_dopri5(),       odeint_rosenbrock4(), cvode_adams(),
          cvode_bdf(),    semi_implicit_euler(), runge_kutta_4(),      moreau_jean()};
}

}  // namespace ricochet::carrier_track
