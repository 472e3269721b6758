#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/experiment/plan.h"
#include "src/report/table.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

struct Ranked {
  std::string solver;
  double rank;  ///< mean
};

/// The first entry, or "none" if it solved no run, and the ranked entries by name.
struct Order {
  std::string leader = "none";
  std::map<std::string, Ranked> entries;
};

/// Returns the order of ratings sorted best first; an entry is a solver-formulation pair.
Order order_of(const std::vector<Rating>& ratings);

/// Returns the order of those with this formulation; an entry is a solver.
Order order_in(std::vector<Rating> ratings, const std::string& formulation);

/// Agreement of two orders, over the entries in both.
struct Agreement {
  std::size_t entries, solvers;
  double correlation;   ///< Kendall's
  double lower, upper;  ///< by resampling solvers, since entries of one solver are alike
};

/// Nothing for fewer than five solvers, or if all entries are tied.
std::optional<Agreement> agreement_of(const Order& a, const Order& b);

/// Is the ranking of the entries robust? Compares the order in every group with the one for other
/// seeds, for either half of the instances, for another formulation, for the largest budget instead
/// of the smallest, and for machines drawn around the problems' own, as far as the plan has parts
/// for it.
Table order_table(const std::vector<CellResult>& results, const std::vector<RatedPart>& parts);

/// Of a table of orders or changes, for each group of rows with equal values in these columns: how
/// many orders were compared, in how many the first stays first, and the median and the least
/// correlation.
Table summary_of(const Table& orders, std::string name, const std::vector<std::string>& by);

/// Does the order hold on problems held out? For every group, with the largest budget: how well the
/// order of the ranked entries on half of the problems predicts that on the other half. Without a
/// correlation for a group with too few problems or entries.
Table held_out_table(const std::vector<RatedPart>& parts);

/// For each part and family: which entry is first, with the largest budget and without
/// perturbations, and how well the order of the entries agrees with that of the first setting:
/// - for each price of a gradient, if a part has several;
/// - for the surrogate of each smoothing parameter, the default one first.
Table change_table(const Campaign& campaign, const std::vector<CellResult>& results,
                   const std::vector<RatedPart>& parts);

/// The same for the machines of each level of a factor that varies from machine to machine, such as
/// the fidelity of the simulation, the lowest level first.
Table level_table(const Comparison& comparison, const Group& group);

/// The families of a campaign with complete runs, by name, as its report names and ranks them.
std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results);

/// How far two campaigns order the entries of a family alike, with the largest budget of each.
struct FamilyAgreement {
  std::string family;
  std::size_t problems, other_problems;
  std::optional<Agreement> agreement;
  std::string leader;                ///< the first entry of the first campaign
  std::optional<double> best;        ///< its P(best) there
  std::optional<std::size_t> place;  ///< its place in the second; nothing if it is not ranked there
  std::string other_leader;          ///< the first of the second campaign
};

/// For each family of the first campaign that the second has, too. The runs of both are complete.
std::vector<FamilyAgreement> family_agreements(const Campaign& first,
                                               const std::vector<CellResult>& of_first,
                                               const Campaign& second,
                                               const std::vector<CellResult>& of_second);

/// A sample of the problems of a campaign whose runs are complete, drawn within each family from
/// strata of difficulty: the share of its runs, over all entries, that did not solve a problem.
struct SampledFamily {
  std::string family;
  std::size_t of;                                             ///< problems
  std::vector<std::pair<std::string, double>> problems = {};  ///< drawn, with their difficulties
  std::optional<Agreement> agreement = {};         ///< of the order on them with that on all
  std::string leader = {};                         ///< on all
  std::optional<double> returned = {}, best = {};  ///< its success rate and P(best)
  std::string sample_leader = {};
};

/// A share of the problems of each family, but at least `least`.
std::vector<SampledFamily> sampled_families(const Campaign& campaign,
                                            const std::vector<CellResult>& results, double share,
                                            std::size_t least);

/// The problems whose best known value a run is below by more than the problem's tolerance: an
/// error of the suite, since no such run can be scored rightly. A row for each, with the best run
/// and the number of runs below.
Table beaten_table(const Campaign& campaign, const std::vector<CellResult>& results);

/// The solvers, with their libraries, of `missing` that a part of the plan would have selected.
std::vector<MissingSolver> lacking(const Plan& plan, const std::vector<MissingSolver>& missing);

}  // namespace ricochet::studies::comparison
