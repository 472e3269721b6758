#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "solvers/automatic.h"
#include "src/analysis/results.h"

namespace ricochet::studies::choice {

/// What problems declare, and what a gradient costs.
struct Setting {
  const char* title;
  bool derivatives;  ///< as the problems have them; else values alone
  bool measured;     ///< gradients cost what was measured, not as many evaluations as differences
};

const std::vector<Setting>& all_settings();

/// The setting that is nearest to how a problem is evaluated.
const Setting& setting_of(const Problem& problem);

/// A problem, what "auto" chooses for it, and the share of runs, with the largest budget, in which
/// each entry returned a point that solves it.
struct Case {
  std::string problem, family, cluster;
  const RuleLine* line;
  std::string chosen;                    ///< an entry: a solver, penalised or not, surrogate or not
  std::map<std::string, double> shares;  ///< by entry; of those that take the problem

  /// 0 for an entry that does not take it.
  double share_of(const std::string& entry) const;
};

/// Runs to learn from: a campaign, complete.
struct Evidence {
  std::string name;  ///< as pages have it
  Campaign campaign;
  std::vector<comparison::CellResult> results;
};

/// The problems of a campaign for which the rule's choice was run there, without perturbations.
std::vector<Case> cases_of(const Evidence& evidence, const Setting& setting);

std::vector<Case> only(const std::vector<Case>& cases,
                       const std::function<bool(const Case&)>& wanted);

/// The places of the cases of each family.
std::map<std::string, std::vector<std::size_t>> by_family(const std::vector<Case>& cases);
using Sample = std::vector<std::vector<std::size_t>>;
Sample all_of(const std::vector<Case>& cases);

/// 1000 samples in which the clusters of problems are drawn again, with replacement, within each
/// family. The seed is fixed.
std::vector<Sample> resampled(const std::vector<Case>& cases);

/// One value for each case.
std::vector<double> values_of(const std::vector<Case>& cases,
                              const std::function<double(const Case&)>& value);
double mean_over_families(const Sample& sample, const std::vector<double>& values);

/// The shares that the choices solve.
std::vector<double> chosen_shares(const std::vector<Case>& cases);

/// An entry, and the shares of runs that it solves.
struct Standing {
  std::string entry;
  std::vector<double> shares;  ///< of the cases
  double mean;                 ///< over families
};

/// All entries on these problems, the best first.
std::vector<Standing> standings(const std::vector<Case>& cases);

/// How often each has the largest mean in resampled(); ties share theirs.
std::vector<double> probabilities_of_being_first(const std::vector<Case>& cases,
                                                 const std::vector<Standing>& order);

}  // namespace ricochet::studies::choice
