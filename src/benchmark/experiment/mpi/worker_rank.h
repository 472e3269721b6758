#pragma once

#include <string>
#include <vector>

namespace ricochet::mpi {

/// Makes the runs that rank 0 gives, in a child process, until there are no more.
void make_given_runs(const std::vector<std::string>& arguments);

}  // namespace ricochet::mpi
