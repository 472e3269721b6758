/// Makes a large store of a small one, to measure what a campaign's report takes: of every run
/// further ones, which differ in what they were charged and in times, are kept as those of further
/// instances.
///
///     repeat_runs STORE TIMES OUT      writes OUT/plan.toml and OUT/runs.sqlite
///
/// The plan is the store's own with as many times the instances: `ricochet run OUT/plan.toml --out
/// OUT --resume` draws its report. The runs are made up: no figure of it means anything.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "ricochet/random.h"
#include "src/core/files.h"
#include "src/experiment/plan.h"
#include "src/experiment/store.h"

namespace ricochet {
namespace {

/// The run a little faster or slower; in the same order, and within what it was allowed.
RunRecord changed(RunRecord record, Random& random) {
  const double factor = 0.7 + 0.6 * uniform(random);
  const auto scaled = [&](std::int64_t evaluations) {
    const auto all = static_cast<std::int64_t>(factor * static_cast<double>(evaluations));
    return std::clamp<std::int64_t>(all, std::min<std::int64_t>(1, evaluations),
                                    std::max(evaluations, record.budget.evaluations));
  };
  for (Improvement& step : record.trace) {
    step.evaluations = scaled(step.evaluations);
    step.seconds *= factor;
  }
  record.ledger.charged = scaled(record.ledger.charged);
  record.ledger.seconds *= factor;
  return record;
}

void repeat(const std::filesystem::path& file, int times, const std::filesystem::path& out) {
  const Store store = Store::open(file, Store::For::reading);
  CampaignDescription description = store.description();
  Plan plan = plan_from(description.plan, file.string());
  for (PlanPart& part : plan.parts) part.instances *= times;
  description.plan = text_of(plan);
  std::filesystem::create_directories(out);
  write_text_file(out / "plan.toml", description.plan);
  std::map<Cell, int> instances;
  store.each([&](const StoredRun& run) {
    int& most = instances[run.key.cell];
    most = std::max(most, run.key.instance);
  });
  Store large = Store::create(out / "runs.sqlite", description);
  Random random(1);
  store.each([&](const StoredRun& run) {
    for (int k = 0; k < times; ++k) {
      RunKey key = run.key;
      key.instance += k * instances.at(key.cell);
      RunRecord record = k == 0 ? run.record : changed(run.record, random);
      record.instance = key.instance;
      large.add(key, record);
    }
  });
  fmt::print("{} runs: {}\n", large.size(), (out / "runs.sqlite").string());
}

}  // namespace
}  // namespace ricochet

int main(int count, char** arguments) {
  const int times = count == 4 ? std::atoi(arguments[2]) : 0;
  if (times < 1) {
    fmt::print(stderr, "repeat_runs STORE TIMES OUT\n");
    return 2;
  }
  ricochet::repeat(arguments[1], times, arguments[3]);
}
