#include "problems/carrier_track/reference_integrators/integrator.h"

#include "problems/carrier_track/reference_integrators/methods.h"

namespace ricochet::carrier_track::inline reference_integrators {

std::vector<Integrator> all_integrators() {
  return {event_driven(), odeint_dopri5(),       odeint_rosenbrock4(), cvode_adams(),
          cvode_bdf(),    semi_implicit_euler(), runge_kutta_4(),      moreau_jean()};
}

std::vector<Integrator> penalty_integrators() {
  return {event_driven(),         penalty_odeint_dopri5(), penalty_odeint_rosenbrock4(),
          penalty_cvode_adams(),  penalty_cvode_bdf(),     penalty_semi_implicit_euler(),
          penalty_runge_kutta_4()};
}

}  // namespace ricochet::carrier_track::inline reference_integrators
