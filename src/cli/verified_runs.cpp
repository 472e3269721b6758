#include "src/cli/verified_runs.h"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/planned_runs.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/benchmark/experiment/campaign/stored_campaign.h"
#include "src/benchmark/experiment/store/archive.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/benchmark/experiment/store/stored_parts.h"
#include "src/cli/programs.h"
#include "src/cli/provenance.h"
#include "src/cli/recorded_campaign.h"
#include "src/cli/shared_options.h"
#include "src/core/progress.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {
namespace {

/// What this build can repeat of a store: runs of equal problems and solvers.
class Repeatable {
 public:
  Repeatable(const Store& store, const std::string& file, bool allow_programs)
      : campaign_(allow_programs ? with_programs(store, file) : recorded_campaign(store)) {
    const CampaignDescription& theirs = store.description();
    const CampaignDescription ours = campaign_.description();
    const auto hashes = theirs.hashes();
    for (const StoredProblem& problem : ours.problems) {
      const auto hash = hashes.find(problem.name);
      if (hash != hashes.end() && hash->second == problem.hash) problems_.insert(problem.name);
    }
    for (const StoredSolver& solver : ours.solvers) {
      const bool starts_nothing = !campaign_.own_texts().contains(solver.name);
      if ((starts_nothing || allow_programs) &&
          std::ranges::find(theirs.solvers, solver) != theirs.solvers.end()) {
        solvers_.insert(solver.name);
      }
    }
  }

  const Campaign& campaign() const { return campaign_; }

  bool has(const RunKey& key) const {
    return problems_.contains(key.cell.problem) && solvers_.contains(key.cell.solver) &&
           campaign_.has(key);
  }

 private:
  static Campaign with_programs(const Store& store, const std::string& file) {
    const Plan plan = plan_from(store.description().plan, file);
    announce_programs(programs_of(plan), true, file);
    return campaign_of(store.description(), plan, studies::whole_catalogue());
  }

  Campaign campaign_;
  std::set<std::string> problems_, solvers_;
};

/// A run of the sample, and where it is from.
struct Drawn {
  StoredRun run;
  const std::string* file;
  std::shared_ptr<const Repeatable> from;
  CampaignDescription description;
};

struct Sample {
  std::vector<Drawn> drawn;
  std::int64_t runs = 0, repeatable = 0;
};

std::string user() {
  const passwd* const entry = getpwuid(getuid());
  return entry != nullptr ? entry->pw_name : fmt::format("user {}", getuid());
}

/// Draws so that each set of runs is as likely as any other (algorithm R).
Sample drawn_from(const std::vector<std::string>& files,
                  const std::function<bool(const RunKey&)>& wanted,
                  const Verification& verification) {
  std::random_device source;  // not a seed of ours, which a forger could know
  std::mt19937_64 random((std::uint64_t{source()} << 32U) | source());
  const auto size = static_cast<std::size_t>(verification.runs);
  std::map<std::string, std::shared_ptr<const Repeatable>> by_description;
  Sample sample;
  for (const std::string& file : files) {
    const Store store = Store::open(file, Store::For::reading);
    const CampaignDescription& description = store.description();
    std::shared_ptr<const Repeatable> repeatable;
    if (size > 0) {
      auto& known = by_description[fmt::format("{:x}", checksum(description))];
      if (!known) known = std::make_shared<Repeatable>(store, file, verification.allow_programs);
      repeatable = known;
    }
    store.each([&](const StoredRun& run) {
      if (!wanted(run.key)) return;
      ++sample.runs;
      if (!repeatable || !repeatable->has(run.key)) return;
      const auto place = static_cast<std::size_t>(
          std::uniform_int_distribution<std::int64_t>(0, sample.repeatable++)(random));
      if (sample.drawn.size() < size) {
        sample.drawn.push_back({run, &file, repeatable, description});
      } else if (place < size) {
        sample.drawn[place] = {run, &file, repeatable, description};
      }
    });
  }
  return sample;
}

/// Searches again for the best values of the drawn problems for which a store has them found.
void search(const std::vector<Drawn>& drawn) {
  std::set<std::string> done;
  for (const Drawn& one : drawn) {
    const std::string& name = one.run.key.cell.problem;
    const auto stored = std::ranges::find(one.description.problems, name, &StoredProblem::name);
    if (stored->findings.empty() || !done.insert(name).second) continue;
    Plan plan = one.from->campaign().plan();
    for (PlanPart& part : plan.parts) part.solvers = {"random-search"};
    const auto searched = Campaign(plan, studies::whole_catalogue()).to_search();
    const auto problem = searched.find(name);
    if (problem == searched.end() || problem->second.search() == stored->findings) continue;
    throw InputError(
        fmt::format("{}: another search does not find the best value of {}", *one.file, name));
  }
}

void repeat(const std::vector<Drawn>& drawn) {
  std::vector<std::unique_ptr<PlannedRuns>> planned;
  std::vector<Job> jobs;
  Limits limits{0, 0};
  for (const Drawn& one : drawn) {
    const Campaign& campaign = one.from->campaign();
    planned.push_back(std::make_unique<PlannedRuns>(campaign, one.run.key));
    jobs.push_back(planned.back()->all().front().job);
    limits.seconds = std::max(limits.seconds, campaign.plan().limits.seconds);
    limits.megabytes = std::max(limits.megabytes, campaign.plan().limits.megabytes);
  }
  Progress progress("repeating runs", static_cast<double>(jobs.size()));
  run_all(jobs, limits, [&](std::size_t job, const RunRecord& again) {
    const std::string differs =
        difference_when_repeated(drawn[job].description, drawn[job].run, again);
    progress.advance(1);
    if (differs.empty()) return;
    throw InputError(fmt::format(
        "{}: run {} differs in {} when it is repeated: it is not what this program does",
        *drawn[job].file, drawn[job].run.number, differs));
  });
}

}  // namespace

void add_verification(CLI::App* command, Verification& verification) {
  command
      ->add_option("--verify", verification.runs,
                   "Repeat so many runs, drawn at random, before any is taken; 0: none")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  add_allowance(command, verification.allow_programs);
}

std::string verified(const std::vector<std::string>& files,
                     const std::function<bool(const RunKey&)>& wanted,
                     const Verification& verification) {
  const Sample sample = drawn_from(files, wanted, verification);
  if (!sample.drawn.empty()) {
    search(sample.drawn);
    repeat(sample.drawn);
  }
  const Provenance here = provenance();
  const std::string version = here.program.at("version");
  std::string others;
  if (verification.runs > 0 && sample.repeatable < sample.runs) {
    others = fmt::format("; {} are of programs, or of other versions, and were not drawn",
                         sample.runs - sample.repeatable);
  }
  if (sample.drawn.empty())
    return fmt::format("none of {} runs was repeated{}", sample.runs, others);
  return fmt::format(
      "{} of {} runs, drawn at random, were repeated to the last bit by {} with {} on {}{}",
      sample.drawn.size(), sample.runs, user(), version.substr(0, version.find('\n')),
      here.made.at("date"), others);
}

}  // namespace ricochet::cli
