#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "solvers/outside/outside.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/archive.h"
#include "src/experiment/archived_campaign.h"
#include "src/experiment/merge.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"
#include "src/experiment/stored_campaign.h"
#include "src/experiment/worker.h"
#include "src/report/json.h"
#include "src/report/text.h"
#include "src/studies/suite/suite.h"

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
  add_value(command, "--verify", verification.runs,
            "Repeat so many runs, drawn at random, before any is taken; 0: none")
      ->check(CLI::Range(0, 1'000'000));
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

namespace {

using report::Json;

struct ReplayOptions {
  std::string store;  ///< a file, or archive, see archive_named()
  std::string run;    ///< its number, or its key as address_of() writes it
  bool allow_programs = false;
  bool json = false;
};

struct MergeOptions {
  std::string out;
  std::vector<std::string> parts;
  Verification verification;
};

/// The programs of which one is the solver of this name: that one if the store says so; none if
/// the solver is of the suite or the plan.
std::vector<std::string> programs_for(const std::string& solver,
                                      const CampaignDescription& description, const Plan& plan) {
  for (const Solver& known : all_solvers()) {
    if (known.name == solver) return {};
  }
  for (const VariedSolver& varied : plan.solvers) {
    if (varied.name == solver) return {};
  }
  const auto own = description.made.find(StoredCampaign::program_key(solver));
  return own != description.made.end() ? std::vector{own->second} : programs_of(plan);
}

/// A repeated run, and what its solver consists of now.
struct MadeAgain {
  RunRecord record;
  std::string content;
};

/// Repeats a run; nothing if the plan has no such run. Starts these programs only.
std::optional<MadeAgain> made_again(const CampaignDescription& description, const Plan& plan,
                                    const RunKey& key, const std::vector<std::string>& programs) {
  Catalogue catalogue = studies::whole_catalogue();
  catalogue.own_solver = [&programs](const std::string& text) {
    const bool needed = std::find(programs.begin(), programs.end(), text) != programs.end();
    return needed ? outside::outside_solver(text) : outside::unstarted_solver(text);
  };
  const Campaign campaign = campaign_of(description, plan, catalogue);
  const PlannedRuns planned(campaign, key);
  if (planned.all().empty()) return std::nullopt;
  const Job& job = planned.all().front().job;
  MadeAgain again{{}, job.solver->content};
  run_all({job}, plan.limits,
          [&](std::size_t, RunRecord record) { again.record = std::move(record); });
  require_unchanged(*job.solver);
  return again;
}

/// A run made again, and in what it differs from the stored one; empty if in nothing.
struct Repetition {
  std::int64_t number;
  RunKey key;
  RunRecord record;
  std::string differs;
  bool solver_changed;  ///< a user's solver, since the stored run was made
};

/// The run with this number, or with this key as address_of() writes it; nothing if there is none.
std::optional<StoredRun> stored_run(const Store& store, const std::string& run) {
  if (const auto key = key_at(run)) return store.find(*key);
  const auto number = number_of_text<std::int64_t>(run);
  if (!number) {
    throw InputError(fmt::format(
        "run {}: must be a number, or "
        "PROBLEM/FORMULATION/PERTURBATION/SOLVER/BUDGET/PRICE/INSTANCE/SEED, as in 17 or "
        "top-speed-C1/count/plain/bisection/100/n/1/0",
        run));
  }
  return store.find(*number);
}

Repetition repetition_of(const Store& store, const std::string& file, const std::string& run,
                         bool allow_programs) {
  const auto stored = stored_run(store, run);
  if (!stored) {
    throw InputError(
        fmt::format("{}: there is no run {}: {} has runs 1 to {}", run, run, file, store.size()));
  }
  const CampaignDescription& description = store.description();
  const Plan plan = plan_from(description.plan, file);
  const std::vector<std::string> programs =
      programs_for(stored->key.cell.solver, description, plan);
  announce_programs(programs, allow_programs, file);
  const auto again = made_again(description, plan, stored->key, programs);
  if (!again) throw InputError(fmt::format("{}: run {} is none of its plan's", file, run));
  const RunRecord& record = again->record;
  const std::string differs = difference_when_repeated(description, *stored, record);
  const auto solver =
      std::ranges::find(description.solvers, stored->key.cell.solver, &StoredSolver::name);
  const bool changed = !solver->content.empty() && solver->content != again->content;
  if (changed) warn(fmt::format("{} changed since this run was made", solver->name));
  return {stored->number, stored->key, record, differs, changed};
}

int merge_stores(const MergeOptions& options) {
  const std::string& out = options.out;
  std::vector<std::string> parts;
  for (const std::string& part : options.parts) parts.push_back(archive_named(part));
  for (const std::string& part : parts) {
    check_as_known(Store::open(part, Store::For::reading), part);
    warn_of_missing_runs(part);
  }
  const std::string note = verified(
      parts, [](const RunKey&) { return true; }, options.verification);
  const std::map<std::string, std::string> made = {
      {"joined", report::counted(parts.size(), "store")}, {"verified", note}};
  merge({parts.begin(), parts.end()}, out, united, made);
  const Store store = Store::open(out, Store::For::reading);
  const auto completeness = told_completeness(store, out);
  fmt::print("{}: {}\nverified: {}\ndigest {}\n", counted_runs(store, completeness), one_line(out),
             note, store.digest());
  return 0;
}

int print_digest(const std::string& name) {
  const std::string store = archive_named(name);
  const Store opened = Store::open(store, Store::For::reading);
  warn_of_missing_runs(store);
  told_completeness(opened, store);
  fmt::print("{}\n", opened.digest());
  return 0;
}

/// Starts only the run's own solver, and that only if it is of the suite or programs are allowed.
int replay(const ReplayOptions& options) {
  if (!std::filesystem::exists(options.store) && std::filesystem::exists(options.run)) {
    throw InputError(fmt::format("{0} {1}: the store comes first: ricochet replay {1} {0}",
                                 options.store, options.run));
  }
  const std::string file = archive_named(options.store);
  const Store store = Store::open(file, Store::For::reading);
  warn_of_missing_runs(file);
  const auto [number, key, again, differs, solver_changed] =
      repetition_of(store, file, options.run, options.allow_programs);
  const Cell& cell = key.cell;
  const Json data = {
      {"run", number},
      {"problem", cell.problem},
      {"formulation", cell.formulation},
      {"perturbation", cell.perturbation},
      {"solver", cell.solver},
      {"budget", cell.budget},
      {"gradient_price", cell.gradient_price},
      {"instance", key.instance},
      {"seed", key.run},
      {"failure", again.failure},
      {"evaluations", again.ledger.charged},
      {"objective", again.trace.empty() ? Json() : Json(again.trace.back().true_values.objective)},
      {"differs", differs},
      {"solver_changed", solver_changed},
      {"same", differs.empty()}};
  if (options.json) {
    fmt::print("{}\n", data.dump(2));
  } else {
    fmt::print("{}\n{}\n",
               one_line(fmt::format(
                   "{} on {}, formulation {}, perturbation {}, instance {}, seed {}: {}{}.",
                   cell.solver, cell.problem, cell.formulation, cell.perturbation, key.instance,
                   key.run, report::counted(again.ledger.charged, "evaluation"),
                   again.failure.empty() ? "" : "; " + again.failure)),
               differs.empty() ? "The same, to the last bit."
                               : "NOT the same as stored: it differs in " + differs + ".");
  }
  return differs.empty() ? 0 : 1;
}

}  // namespace

void warn_of_missing_runs(const std::string& store) {
  const std::string warning = caution(store);
  if (!warning.empty()) warn(warning);
}

std::optional<Campaign> check_as_known(const Store& store, const std::string& file) {
  std::optional<Campaign> campaign;
  try {
    campaign = recorded_campaign(store);
  } catch (const InputError& error) {
    warn(fmt::format("{}: how many runs were planned cannot be told: {}", file, error.what()));
    return campaign;
  }
  check_content(*campaign, store, file);
  return campaign;
}

std::optional<Completeness> told_completeness(const Store& store, const std::string& file) {
  const std::optional<Campaign> campaign = check_as_known(store, file);
  if (!campaign) return std::nullopt;
  const Completeness found = completeness_of(*campaign, store);
  if (found.is_in_doubt()) warn(fmt::format("{}: {}", file, in_words(found)));
  return found;
}

std::string counted_runs(const Store& store, const std::optional<Completeness>& completeness) {
  if (!completeness || completeness->missing() == 0) return report::counted(store.size(), "run");
  return fmt::format("{} of {} planned runs", completeness->present, completeness->planned);
}

void add_replay(CommandLine& line) {
  CLI::App* command = line.add("replay", "Repeat a stored run and compare it bit by bit",
                               "  ricochet replay mine/runs.sqlite 17\n"
                               "  ricochet replay archive "
                               "top-speed-C1/count/plain/bisection/100/n/1/0");
  const auto options = std::make_shared<ReplayOptions>();
  add_value(command, "store", options->store,
            "A store, runs.sqlite; archive: that of the reference, which is included", "FILE")
      ->required();
  add_value(command, "run", options->run,
            "Number of the run, or problem/formulation/perturbation/solver/budget/price/"
            "instance/seed, as a comparison's own view writes it",
            "RUN")
      ->required();
  add_allowance(command, options->allow_programs);
  add_format(command, options->json);
  line.on_call(command, [options] { return replay(*options); });
}

void add_merge(CommandLine& line) {
  CLI::App* command = line.add("merge", "Join the stores of a campaign's shards",
                               "  ricochet merge runs.sqlite part-*/runs.sqlite");
  const auto options = std::make_shared<MergeOptions>();
  add_value(command, "out", options->out, "The new store", "FILE")->required();
  add_value(command, "parts", options->parts, "Stores of the same campaign", "FILE")->required();
  add_verification(command, options->verification);
  line.on_call(command, [options] { return merge_stores(*options); });
}

void add_digest(CommandLine& line) {
  CLI::App* command = line.add("digest", "Print a hash of a store's runs, times left out",
                               "  ricochet digest mine/runs.sqlite");
  const auto store = std::make_shared<std::string>();
  add_value(command, "store", *store, "A store, runs.sqlite", "FILE")->required();
  line.on_call(command, [store] { return print_digest(*store); });
}

}  // namespace ricochet::cli
