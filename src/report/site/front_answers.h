#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/site/chooser.h"
#include "src/report/site/front.h"
#include "src/report/site/paper_machines.h"

namespace ricochet::site {

/// What the front page answers in sentences, as far as the reports say it.
struct Answered {
  const std::optional<PaperMachines>& machines;
  const std::optional<Chooser>& chooser;
  const std::optional<Pairs>& pairs;
  const FoundReport* comparison;  ///< null if there is none
  const std::vector<FoundReport>& reports;
};

/// The first answers: what the machine does, whether the paper's algorithm is worth it, which
/// solver.
std::vector<FrontExcerpt> first_answers(const Answered& answered);

/// A stranger's further questions. A link without a folder leads to a place of the front page.
std::vector<FrontExcerpt> further_answers(const Answered& answered);

/// Returns the answer whether the paper's algorithm, the solver `fireworks`, is worth it: the share
/// of runs that it solved by the returned point, with its interval, beside random search, the best
/// of its variants and the best solvers of CMA-ES, NLopt and Ipopt, on the paper's own problem and
/// on all families, each with its largest budget and in its best formulation; and the families in
/// which it leads. Nothing if the comparison did not run it on either. Throws Json::exception if
/// its data are of another version.
std::optional<FrontExcerpt> paper_algorithm(const FoundReport& comparison);

/// Returns the answer in one sentence, with its numbers: on the paper's own problem, or else on all
/// families; empty if the comparison did not run it on either.
std::string paper_algorithm_verdict(const FoundReport& comparison);

}  // namespace ricochet::site
