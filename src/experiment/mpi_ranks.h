#pragma once

#include <string>
#include <vector>

namespace ricochet::mpi {

/// Keeps the store in a child process, and hands out runs to the other ranks until all are made. If
/// a rank dies or is silent for too long, its unfinished runs are given to others. Returns the exit
/// code of the child, or 1 if no rank is left to make runs; sets `lost` if any rank was lost.
int hand_out_runs(std::vector<std::string> arguments, int ranks, bool& lost);

/// Makes the runs that rank 0 gives, in a child process, until there are no more.
void make_given_runs(const std::vector<std::string>& arguments);

}  // namespace ricochet::mpi
