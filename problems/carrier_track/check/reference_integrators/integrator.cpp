#include "problems/carrier_track/check/reference_integrators/integrator.h"

#include "problems/carrier_track/check/reference_integrators/methods.h"

namespace ricochet::carrier_track::inline reference_integrators {

std::vector<Integrator> all_integrators() {
  return {
      event_driven(),        odeint_dopri5(), odeint_rosenbrock4(),
#ifdef RICOCHET_HAS_SUNDIALS
      cvode_adams(),         cvode_bdf(),
#endif
      semi_implicit_euler(), runge_kutta_4(), moreau_jean(),
  };
}

std::vector<Integrator> penalty_integrators() {
  return {
      event_driven(),
      penalty_odeint_dopri5(),
      penalty_odeint_rosenbrock4(),
#ifdef RICOCHET_HAS_SUNDIALS
      penalty_cvode_adams(),
      penalty_cvode_bdf(),
#endif
      penalty_semi_implicit_euler(),
      penalty_runge_kutta_4(),
  };
}

std::vector<std::string> missing_integrators() {
#ifdef RICOCHET_HAS_SUNDIALS
  return {};
#else
  return {"cvode-adams", "cvode-bdf"};
#endif
}

}  // namespace ricochet::carrier_track::inline reference_integrators
