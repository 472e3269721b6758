#pragma once

#include <string>
#include <vector>

namespace ricochet::mpi {

/// Keeps the store, by a child, and hands out runs to the other ranks until all are made. What a
/// rank has not made that dies, or is silent for too long, is given to others. Returns the exit
/// code of the child, or 1 where no rank is left to make runs; `lost` says whether some rank was.
int hand_out_runs(std::vector<std::string> arguments, int ranks, bool& lost);

}  // namespace ricochet::mpi
