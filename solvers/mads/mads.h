#pragma once

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// "mads": mesh adaptive direct search (Audet and Dennis, SIAM J. Optim. 17 (2006) 188-217, doi
/// 10.1137/040603371) in the unit cube. It needs neither slopes nor continuity, and handles
/// constraints by a progressive barrier; see barrier.h. An iteration first looks further along the
/// step of the last success, up to four times its length. It then polls around the incumbents in
/// the n + 1 directions of OrthoMADS that point most along this step; see poll_directions.h. The
/// first point that beats an incumbent ends the iteration, and the mesh becomes coarser; if there
/// is none, the mesh is refined. Points outside the box are moved to its faces.
///
/// It polls in all directions around the feasible incumbent, and in two opposite directions around
/// the infeasible one if that has a lower objective. A feasible point that ties with its incumbent
/// is no success, but replaces it, so that the search moves along a plateau. Ends when the mesh is
/// finer than 1e-8 of the box, with polls at 1e-4 of it; it can then be restarted elsewhere.
Solver mads();

/// Options: "finest_mesh", as a share of the box; "mesh_index", the initial index, with polls at
/// 2^-index of the box; and "further", how far to look along the last success, in lengths of its
/// step (0: not at all).
AdjustableSolver adjustable_mads();

}  // namespace ricochet
