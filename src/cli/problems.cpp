#include "src/cli/problems.h"

#include <fmt/format.h>

#include <filesystem>

#include "src/cli/families_choice.h"
#include "src/report/file_set.h"
#include "src/studies/problems/page.h"

namespace ricochet::cli {

int problems(const ProblemsOptions& options) {
  const std::vector<Family> families = choose_families(options.scene_file);
  report::require_writable(options.out);
  const std::string machines =
      options.scene_file.empty()
          ? "the paper's cases C1 to C12, and of the literature"
          : fmt::format("the machine {}",
                        std::filesystem::path(options.scene_file).filename().string());
  report::write_page(studies::problems::overview_of(families, machines), options.out);
  for (const Family& family : families) {
    if (family.questions.empty()) continue;
    report::write_page(studies::problems::page_of(family),
                       std::filesystem::path(options.out) / family.name);
  }
  fmt::print("The report: {}\n",
             (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
  return 0;
}

}  // namespace ricochet::cli
