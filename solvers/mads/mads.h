#pragma once

#include "solvers/adjustable_solver.h"
#include "src/core/solver.h"

namespace ricochet {

/// "mads": mesh adaptive direct search (Audet and Dennis, SIAM J. Optim. 17 (2006) 188-217, doi
/// 10.1137/040603371) in the unit cube. It needs neither slopes nor continuity, and takes
/// constraints by a progressive barrier; see barrier.h. An iteration first looks further along the
/// step of the last success, to four times its length, and then polls around the incumbents in the
/// n + 1 directions of OrthoMADS that lead most along it; see poll_directions.h. It goes on from
/// the first point that beats an incumbent, on a coarser mesh; else the mesh is refined. Points
/// beyond the box are moved to its faces.
///
/// Around the feasible incumbent it polls in full, around the infeasible one, where it is lower, in
/// two opposite directions. A feasible point that ties with its incumbent is no success, but takes
/// its place, so that a plateau is walked on, not only looked around. Ends where the mesh is finer
/// than 1e-8 of the box, at polls of 1e-4 of it, to be started again elsewhere.
Solver mads();

/// With "finest_mesh", in parts of the box; "mesh_index", where it begins, with polls at 2^-index
/// of the box; and "further", how many times the last success's step it looks further, 0: not at
/// all.
AdjustableSolver adjustable_mads();

}  // namespace ricochet
