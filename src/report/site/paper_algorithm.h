#pragma once

#include <optional>
#include <string>

#include "src/report/site/front.h"

namespace ricochet::site {

/// Returns the answer whether the paper's algorithm, the solver `fireworks`, is worth it: the share
/// of runs that it solved by the returned point, with its interval, beside random search and the
/// best solvers of CMA-ES, NLopt and Ipopt, on the paper's own problem and on all families, each
/// with its largest budget and in its best formulation; and the families in which it leads. Nothing
/// if the comparison did not run it on either. Throws Json::exception if its data are of another
/// version.
std::optional<FrontExcerpt> paper_algorithm(const FoundReport& comparison);

/// Returns the answer in one sentence, with its numbers: on the paper's own problem, or else on all
/// families; empty if the comparison did not run it on either.
std::string paper_algorithm_verdict(const FoundReport& comparison);

}  // namespace ricochet::site
