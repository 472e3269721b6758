#include "src/cli/surrogate.h"

#include <fmt/format.h>

#include <filesystem>

#include "src/report/file_set.h"
#include "src/studies/surrogate/page.h"

namespace ricochet::cli {

int surrogate(const SurrogateOptions& options) {
  using namespace ricochet::studies::surrogate;
  report::require_writable(options.out);
  const Study study = make_study(options.quick ? quick_plan() : full_plan());
  report::write_page(page_of(study), options.out);
  fmt::print("{} cases at {} smoothing widths, {} gradients compared; {:.1f} s\n",
             study.gap.cases.size(), study.plan.gap.widths.size(), study.plan.agreement.points,
             study.seconds);
  fmt::print("The report: {}\n",
             (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
  return 0;
}

}  // namespace ricochet::cli
