#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

/// The solvers of pagmo, all in the unit cube. Populations begin with the start and points uniform
/// in the box. Points without a finite value count as the worst. Unless stated otherwise, they take
/// bounds only, and end when a step, or the distance from the best point to the worst, is below
/// 1e-8 of the box, or when all points of a generation have the same value.
namespace ricochet {

inline constexpr Capabilities pagmo_bounds_only = {};
inline constexpr Capabilities pagmo_all_constraints = {.constraints =
                                                           Capabilities::Constraints::all};
inline constexpr Capabilities pagmo_needs_constraints = {
    .constraints = Capabilities::Constraints::all, .needs_constraints = true};

/// "pagmo-cmaes": the evolution strategy with covariance matrix adaptation (Hansen, in: Towards a
/// New Evolutionary Computation, 2006, 75-102; doi 10.1007/3-540-32494-1_4), with 4 + floor(3 ln n)
/// points a generation, at least 5. Tuned: with a first step of 0.25 of the box.
Solver pagmo_cmaes(Settings settings);

/// "pagmo-cmaes-ipop": the same, but whenever it ends, it restarts elsewhere with twice as many
/// points, until the evaluator refuses (Auger and Hansen, CEC 2005, 1769-1776; doi
/// 10.1109/CEC.2005.1554902, whose first step is 0.5 of the box, too).
Solver pagmo_cmaes_ipop(Settings settings);

/// "pagmo-xnes": exponential natural evolution strategies (Glasmachers et al., GECCO 2010, 393-400;
/// doi 10.1145/1830483.1830557), with as many points a generation as pagmo_cmaes().
Solver pagmo_xnes();

/// "pagmo-de": differential evolution (Storn and Price, J. Global Optim. 11 (1997) 341-359; doi
/// 10.1023/A:1008202821328) with pagmo's defaults: weight 0.8, crossover rate 0.9 and mutation
/// rand/1/exp. The population has 10 n points, at least 20 and at most 100.
Solver pagmo_de();

/// "pagmo-sade": the same, with self-adaptive weight and crossover rate, jDE (Brest et al., IEEE
/// Trans. Evol. Comput. 10 (2006) 646-657; doi 10.1109/TEVC.2006.872133).
Solver pagmo_sade();

/// "pagmo-de1220": the same, with self-adaptive mutation too; pagmo's own method.
Solver pagmo_de1220();

/// "pagmo-gaco": the extended ant colony (Schlueter, Egea and Banga, Comput. Oper. Res. 36 (2009)
/// 2217-2229; doi 10.1016/j.cor.2008.08.015) with as many points as pagmo_de(). Takes all
/// constraints. Ends only when the evaluator refuses.
Solver pagmo_gaco();

/// "pagmo-compass-search": searches from the start along one axis after the other and halves the
/// step if no axis improves (Kolda, Lewis and Torczon, SIAM Review 45 (2003) 385-482; doi
/// 10.1137/S003614450242889), from 0.25 to 1e-8 of the box. Takes all constraints: a point with
/// less violation is better, whatever its objective.
Solver pagmo_compass_search();

/// "pagmo-constrained-de": the search of pagmo_de() with a penalty that adapts to the population
/// after each generation (Farmani and Wright, IEEE Trans. Evol. Comput. 7 (2003) 445-455; doi
/// 10.1109/TEVC.2003.817236). Takes all constraints; requires at least one.
Solver pagmo_constrained_de();

/// The adjustable ones. Options of evolution strategies: "initial_step", as a share of the box, and
/// "population", with restarts also its "growth"; of differential evolution: "weight" (F),
/// "crossover" (CR), "population", and pagmo's numbers for the "variant" of the mutation and the
/// "adaptation"; of the ant colony: "population" and "kernel"; of compass search: "initial_step"
/// and "shrinkage".
std::vector<AdjustableSolver> adjustable_pagmo_cmaes();
AdjustableSolver adjustable_pagmo_xnes();
std::vector<AdjustableSolver> adjustable_pagmo_de();
AdjustableSolver adjustable_pagmo_gaco();
AdjustableSolver adjustable_pagmo_compass_search();
AdjustableSolver adjustable_pagmo_constrained_de();

}  // namespace ricochet
