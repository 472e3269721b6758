#include "src/cli/dynamics.h"

#include <fmt/format.h>

#include <filesystem>

#include "src/report/file_set.h"
#include "src/studies/dynamics/page.h"

namespace ricochet::cli {

int dynamics(const DynamicsOptions& options) {
  using namespace ricochet::studies::dynamics;
  report::require_writable(options.out);
  const Study study = make_study(options.quick ? quick_plan() : full_plan());
  report::write_page(page_of(study), options.out);
  fmt::print(
      "{} contact laws, {} methods in {} scenes, {} cases by hard and compliant walls; {:.1f} s\n",
      study.laws.size(), study.integrators.size(), study.works.size(), study.fidelity.cases.size(),
      study.seconds);
  fmt::print("The report: {}\n",
             (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
  return 0;
}

}  // namespace ricochet::cli
