#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "src/experiment/mpi_ranks.h"

/// `ricochet run` becomes this program if mpirun has started several of it. Rank 0 keeps the store
/// and hands out runs; the other ranks make them. Child processes of `ricochet`, which know nothing
/// of MPI, do all work on campaigns; this program only transfers bytes.
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a failed write reports a child that has ended
  MPI_Init(&argc, &argv);
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int exit_code = 0;
  bool lost = false;
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (rank == 0) {
      exit_code = ricochet::mpi::hand_out_runs(arguments, ranks, lost);
    } else {
      ricochet::mpi::make_given_runs(arguments);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ricochet: rank %d: %s\n", rank, error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  if (lost) MPI_Abort(MPI_COMM_WORLD, exit_code);  // MPI_Finalize would wait for the lost rank
  MPI_Finalize();
  return exit_code;
}
