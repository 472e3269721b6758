#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/studies/contest/study.h"

namespace ricochet::cli {

/// Prints a plan to start from.
int new_plan();

/// Says what a plan would run, and for how long, or what is wrong with it.
int check_plan(const std::string& plan, bool json);

/// Prints a script for the workload manager Slurm that carries a plan out as so many jobs and joins
/// what they stored.
int slurm_script(const std::string& plan, int jobs);

struct RunOptions {
  std::string plan = "default";          ///< TOML file, or the name of one that comes along
  std::string out = "reports/campaign";  ///< folder of its store, runs.sqlite
  std::string shard = "1/1";
  bool resume = false;
  int jobs = 0;       ///< runs at once; 0: one on every core, and under MPI one
  std::string serve;  ///< under MPI, what this process does: "store" or "runs"; see service.h
};

/// Carries out a plan, or goes on with it, as one of the ranks where mpirun has started several; a
/// whole campaign ends with its report.
int run_plan(const RunOptions& options);

/// What solvers do on questions, as a campaign of its own, which goes on by itself where it was
/// interrupted.
int compare(const studies::ContestOptions& options, bool quick, const std::string& out);

/// Joins the stores of a campaign's parts into a new one.
int merge_stores(const std::vector<std::string>& parts, const std::string& out);

/// Prints the digest of a store.
int print_digest(const std::string& store);

/// Makes a run of a store again and says whether it ends in the same bits: exit code 0, or 1.
int replay(const std::string& store, std::int64_t number, bool json);

}  // namespace ricochet::cli
