#include "src/cli/reproduce.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "solvers/solvers.h"
#include "src/report/file_set.h"
#include "src/studies/reproduction/page.h"

namespace ricochet::cli {

int reproduce(const ReproduceOptions& options) {
  using namespace studies::reproduction;
  report::require_writable(options.out);
  const Study study = make_study(options.quick ? quick_plan() : full_plan(), all_solvers());
  report::write_page(page_of(study), options.out);
  const Agreement agreement = agreement_of(study.cases);
  fmt::print("{} thresholds, {:.0f} % from the paper's; {} of {} example speeds right; {:.1f} s\n",
             agreement.thresholds, 100 * std::expm1(agreement.relative_error), agreement.right,
             agreement.examples, study.seconds);
  fmt::print("The report: {}\n",
             (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
  return 0;
}

}  // namespace ricochet::cli
