#include "src/cli/plan.h"

#include <fmt/format.h>

#include <cmath>

#include "embedded/default_plan.h"
#include "embedded/full_plan.h"
#include "embedded/plan_template.h"
#include "embedded/quick_plan.h"
#include "embedded/slurm_template.h"
#include "src/campaign/forecast.h"
#include "src/cli/campaign_size.h"
#include "src/core/error.h"
#include "src/report/filled_text.h"
#include "src/studies/contest/catalogue.h"

namespace ricochet::cli {
namespace {

using report::Json;

/// A word of a shell, whatever it has in it.
std::string in_shell_quotes(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string in_words(const VariedSolver& varied) {
  std::string words = varied.of;
  for (const auto& [option, value] : varied.options) {
    words += fmt::format(", {} = {}", option, value);
  }
  return words;
}

}  // namespace

Plan plan_named(const std::string& name) {
  if (name == "quick") return plan_from(embedded::quick_plan, name);
  if (name == "default") return plan_from(embedded::default_plan, name);
  if (name == "full") return plan_from(embedded::full_plan, name);
  return read_plan(name);
}

int new_plan() {
  fmt::print("{}", embedded::plan_template);
  return 0;
}

int check_plan(const std::string& plan, bool json) {
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  Json size = size_of(campaign);
  const double seconds = foretold_seconds(campaign);
  size["seconds"] = seconds;
  size["cores"] = cores();
  Json with_options = Json::array();
  for (const VariedSolver& v : campaign.plan().solvers) {
    with_options.push_back({{"name", v.name}, {"of", v.of}, {"options", v.options}});
  }
  size["varied_solvers"] = std::move(with_options);
  if (json) {
    fmt::print("{}\n", size.dump(2));
  } else {
    fmt::print("{}; about {} on {} cores\n", in_words(size), duration(seconds / cores()), cores());
    for (const VariedSolver& varied : campaign.plan().solvers) {
      fmt::print("{}: {}\n", varied.name, in_words(varied));
    }
  }
  return 0;
}

int slurm_script(const std::string& plan, int jobs) {
  if (jobs < 1 || jobs > 10'000) {
    throw InputError(fmt::format("--jobs {}: must be from 1 to 10000", jobs));
  }
  if (plan == "-") throw InputError("the jobs read the plan: it must be a file");
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  const double hours = foretold_seconds(campaign) / jobs / 3600;
  const Json data = {{"plan", in_shell_quotes(plan)},
                     {"jobs", jobs},
                     {"hours", static_cast<int>(std::ceil(2 * hours + 0.1))}};
  fmt::print("{}", report::filled(embedded::slurm_template, {&data}));
  return 0;
}

}  // namespace ricochet::cli
