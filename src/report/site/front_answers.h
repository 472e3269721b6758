#pragma once

#include <optional>
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

}  // namespace ricochet::site
