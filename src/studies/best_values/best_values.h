#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/hard_machines.h"
#include "ricochet/problem.h"
#include "src/report/table.h"

/// The best values of problems, by searches, from the runs of a store, and whether they are proven.
namespace ricochet::studies::best_values {

using carrier_track::BestKnown;
using carrier_track::BestValues;

/// Effort for a best value, in evaluations instead of seconds, so that results are reproducible.
struct Effort {
  /// Of each search: fifty times the largest budget of any plan.
  std::int64_t evaluations_per_variable = 50'000;
  int rounds = 2;  ///< of three searches each; none begins after two agree
};

/// Returns the best true objective of a problem. One variable is scanned at the problem's step. For
/// several, three solvers that do best on such problems are each restarted until their evaluations
/// are spent and improved by local solvers, and, where there are gradients, by basin hopping with
/// as many evaluations again, until two searches end within the problem's tolerance of the best, or
/// all rounds are over. Constraints are penalised for solvers that take none. The
/// problem's best known point stays if no search finds a better one. The provenance says how many
/// searches agree.
BestKnown best_of(const Problem& problem, const Effort& effort);

/// Which best values are searched for, and for how long.
struct Plan {
  std::string problems;  ///< a shell pattern, or a part of the name; empty: all
  double seconds = std::numeric_limits<double>::infinity();  ///< no search is begun later
  Effort effort = {};
};

/// The result of a search.
struct Outcome {
  std::size_t wanted = 0;      ///< problems of the plan
  std::size_t finished = 0;    ///< of those, in this call or earlier
  std::size_t improved = 0;    ///< better than the known value, or new
  std::size_t infeasible = 0;  ///< no feasible point evaluated
};

/// The problems whose name contains the pattern, or matches it as in a shell if it has * ? or [.
/// Throws InputError if there is none.
std::vector<Problem> matching(const std::vector<Problem>& problems, const std::string& pattern);

/// Searches for the best values of the problems, in parallel, and writes them to the file of
/// best_known.h once all are complete. Until then finished values are kept in "<file>.part", so
/// that an interrupted call can be resumed; values from calls for other problems are kept there
/// too. Known values, in the file or in the program, are evaluated again at their points, and stay
/// unless a better one is found; their provenance says how many searches agree. Throws InputError
/// if a pattern matches nothing, or if a file cannot be read or written.
Outcome find_best_values(const std::vector<Problem>& problems, const Plan& plan,
                         const std::filesystem::path& file);

/// The values in a file; none if there is no file. Throws InputError for invalid text.
BestValues read_if_there(const std::filesystem::path& file);

/// Takes the points of a store's runs that are better than the best values known by more than the
/// problem's tolerance, as reports have it, and writes all values to a file of best_known.h.
/// Returns the number of problems whose value is better than before. Every point is evaluated
/// again, in the problem as stated; the file stays unchanged if none is better. Throws InputError
/// if the store or the file cannot be read.
std::size_t take_stored_values(const std::vector<Problem>& problems,
                               const std::filesystem::path& store,
                               const std::filesystem::path& file);

/// Of the problems of one variable with a best known value, those of which a complete scan can tell
/// whether a better point exists (Problem::not_excluded): problem, best, whether it is proven that
/// none is better, and the ranges of the variable that are left, "none" if proven. In parallel.
Table proofs(const std::vector<Problem>& problems);

// The search for machines whose fastest quiet speed is hard to find.

/// Returns a random machine around a case of an interpretation, with the case's window. Every
/// parameter (see constants_of) is that of the interpretation times 1/2 to 2, log-uniform. The
/// disturbance, the only force whose frequency differs from the plate's, has 0.1 to 100 N and 1 to
/// 100 rad/s, both log-uniform; its phase and the plate's are uniform. The quiet limit is that of
/// machine_of(scene, ...). The result depends only on interpretation, case and number.
carrier_track::Machine random_machine(const carrier_track::Scene& interpretation,
                                      const std::string& around, int draw);

/// Returns how hard a machine is if all of these hold, else nothing:
/// - Of the speeds 1e-4, 2e-4, ..., 18 rad/s those of the last quiet interval are 0.1 % to 1 % of
///   the box, all of them quiet, and no speed beyond is quiet.
/// - The quiet interval lies at least 0.5 rad/s beyond the end of the first, and 0.1 rad/s above
///   the next quiet speed.
/// - The best speed, its end to 1e-7 rad/s, is below 17.9 rad/s, and the counts at it and 1e-4
///   rad/s to either side of it are certain.
/// - Bisection ends elsewhere if started in the middle of the box, at one of its ends, or from
///   three quarters of the places in between.
/// Scans more coarsely first, so that most machines are cheap.
std::optional<carrier_track::HardMachine> judged_hard(const carrier_track::Machine& machine);

/// Of `draws` machines around each case of the default interpretation, returns the `wanted` ones
/// with the narrowest last quiet intervals, at most five around one case. The narrowest is "01".
carrier_track::HardMachines find_hard_machines(int draws, std::size_t wanted);

}  // namespace ricochet::studies::best_values
