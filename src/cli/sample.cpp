#include <fmt/format.h>

#include <cstddef>

#include "ricochet/error.h"
#include "src/benchmark/comparison/sample_data.h"
#include "src/cli/agreement_text.h"
#include "src/cli/archive.h"
#include "src/cli/commands.h"
#include "src/cli/finished_campaign.h"
#include "src/cli/shared_options.h"

namespace ricochet::cli {
namespace {

using report::Json;

struct SampleOptions {
  std::string archive;
  double share = 0.15;
  bool json = false;
};

constexpr std::size_t least_problems = 3;

/// A family in a line, and its problems in the next.
std::string row_in_words(const Json& row) {
  std::string problems;
  for (const Json& drawn : row["problems"]) {
    problems += fmt::format("{}{} ({:.2f})", problems.empty() ? "" : ", ",
                            drawn["problem"].get<std::string>(), drawn["difficulty"].get<double>());
  }
  std::string leader = row["leader"];
  if (!row["returned"].is_null()) {
    leader += fmt::format(" ({:.0f} % solved", 100 * row["returned"].get<double>());
    if (!row["best"].is_null())
      leader += fmt::format(", P(best) {:.2f}", row["best"].get<double>());
    leader += ")";
  }
  const std::string on_sample =
      row["leader"] == row["sample_leader"]
          ? " on both"
          : fmt::format(", on the sample {}", row["sample_leader"].get<std::string>());
  return fmt::format("{}: {} of {} problems; {}; {} is first{}\n  {}\n",
                     row["family"].get<std::string>(), row["problems"].size(), row["of"].get<int>(),
                     agreement_in_words(row["agreement"]), leader, on_sample, problems);
}

int sample_problems(const SampleOptions& options) {
  const double share = options.share;
  if (!(share > 0 && share <= 1)) {
    throw InputError(fmt::format("--share {}: must be in (0, 1]", share));
  }
  const FinishedCampaign finished =
      finished_campaign(Store::open(archive_named(options.archive), Store::For::reading));
  const Json rows =
      studies::comparison::sample_data(finished.campaign, finished.results, share, least_problems);
  if (options.json) {
    fmt::print("{}\n", rows.dump(2));
    return 0;
  }
  for (const Json& row : rows) fmt::print("{}", row_in_words(row));
  return 0;
}

}  // namespace

void add_sample(CommandLine& line, CLI::App* plan) {
  CLI::App* sample =
      line.add_part(plan, "sample",
                    "Print a sample of an archive's problems, evenly over difficulty, and "
                    "how far its ranking agrees with that of all");
  const auto options = std::make_shared<SampleOptions>();
  sample->add_option("archive", options->archive, "An archive; archive: that of the reference")
      ->type_name("ARCHIVE")
      ->required();
  sample->add_option("--share", options->share, "Of each family; at least three problems")
      ->capture_default_str();
  add_format(sample, options->json);
  line.on_call(sample, [options] { return sample_problems(*options); });
}

}  // namespace ricochet::cli
