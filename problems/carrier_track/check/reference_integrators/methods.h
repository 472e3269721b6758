#pragma once

#include "problems/carrier_track/check/reference_integrators/integrator.h"

/// One method per source file; integrator.cpp lists them.
namespace ricochet::carrier_track::inline reference_integrators {

/// ImpactModel: flights in closed form, events by conservative advancement. For compliant walls the
/// CompliantModel at its tightest tolerance, 1e-12. Ignores the control parameter.
Integrator event_driven();

/// Boost.Odeint's Dormand-Prince 5(4), events on its dense output.
Integrator odeint_dopri5();

/// Boost.Odeint's Rosenbrock method of order 4, events on its dense output.
Integrator odeint_rosenbrock4();

/// SUNDIALS CVODE, Adams-Moulton of order 1 to 12, with its own rootfinding.
Integrator cvode_adams();

/// SUNDIALS CVODE, backward differentiation of order 1 to 5, with its own rootfinding.
Integrator cvode_bdf();

/// Fixed steps; walls are detected at the end of a step.
Integrator semi_implicit_euler();
Integrator runge_kutta_4();

/// Moreau-Jean time-stepping, theta = 1/2: contact and friction as impulses at velocity level.
Integrator moreau_jean();

/// Penalty methods (penalty.h): integrate straight through the contacts of compliant walls. CVODE
/// iterates Adams-Moulton by fixed point, as for non-stiff motion, and BDF by Newton.
Integrator penalty_semi_implicit_euler();
Integrator penalty_runge_kutta_4();
Integrator penalty_odeint_dopri5();
Integrator penalty_odeint_rosenbrock4();
Integrator penalty_cvode_adams();
Integrator penalty_cvode_bdf();

}  // namespace ricochet::carrier_track::inline reference_integrators
