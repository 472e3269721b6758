#include "src/studies/calibration/searches.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"
#include "src/experiment/worker.h"

namespace ricochet::studies::calibration {

using namespace carrier_track;

Search with_evaluations(Search search, std::int64_t evaluations) {
  search.evaluations = evaluations;
  return search;
}

const Fit& best_of(const std::vector<Fit>& fits) {
  return *std::ranges::min_element(fits, {}, &Fit::loss);
}

/// A search, and its next run.
struct Searches::Ongoing {
  Fit fit;  ///< the best so far
  Problem problem;
  const Solver* solver = nullptr;
  std::int64_t evaluations = 0;
  int number = 0;  ///< of the seed

  Ongoing(Fit start, const std::string& suffix)
      : fit(std::move(start)), problem(calibration_problem(fit, fit.left_out)) {
    problem.name += suffix;
    move_to(problem.start, problem.evaluate(problem.start).objective);
  }

  void move_to(const Vector& x, double loss) {
    problem.start = x;
    fit = {fit_at(fit, x), loss, fit.left_out};
  }

  void next(const Solver& its_solver, std::int64_t its_evaluations) {
    solver = &its_solver;
    evaluations = std::max<std::int64_t>(1, its_evaluations / cost());
  }

  /// Approximate cost of an evaluation, as a multiple of that of most interpretations.
  int cost() const {
    if (fit.interpretation.recovery == Recovery::contact_speed) return 60;
    switch (fit.interpretation.counted) {
      case Counted::from_start:
        return 1;
      case Counted::later:
        return 5;
      case Counted::long_run:
        return 20;
    }
    return 1;
  }

  /// Approximate length of the run.
  double length() const { return static_cast<double>(evaluations) * cost(); }

  /// The problem's name does not tell where the search begins.
  std::string stored_name() const {
    FnvHash hash;
    hash.add(fmt::format("{}", fmt::join(fit.constants, " ")));
    return fmt::format("{}-from-{:016x}", problem.name, hash.value());
  }

  RunKey key() const {
    const std::string formulation = problem.name_of(problem.formulations().front());
    return {{stored_name(), formulation, "plain", solver->name, evaluations}, 0, number};
  }

  StoredProblem stored_problem() const {
    StoredProblem stored;
    stored.name = stored_name();
    stored.family = "calibration";
    stored.variables = problem.dimension();
    stored.hash = problem_hash(problem);
    return stored;
  }
};

namespace {

/// A day and 2 GB for each run: a time limit would make results depend on the machine.
constexpr Limits limits{86'400, 2000};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw InputError(
      fmt::format("{}: is of {}: remove it, or choose another --out", file.string(), what));
}

/// Adds what the description of a store lacks. Throws InputError if it has another one of the name.
template <class Entry>
void add(std::vector<Entry>& entries, const Entry& entry, const std::filesystem::path& file) {
  const auto known = std::ranges::find(entries, entry.name, &Entry::name);
  if (known == entries.end()) {
    entries.push_back(entry);
  } else if (*known != entry) {
    refuse(file, "another " + entry.name);
  }
}

/// A store with this description and the runs of the earlier one, if there is one.
Store grown(const std::filesystem::path& file, const CampaignDescription& description,
            const std::optional<Store>& earlier) {
  if (!earlier) return Store::create(file, description);
  if (earlier->description() != description) {
    Store::replace(file, description, [&](const Store::AddRun& add) {
      earlier->each([&](const StoredRun& run) { add(run.key, run.record); });
    });
  }
  return Store::open(file, Store::For::adding);
}

}  // namespace

std::vector<RunRecord> Searches::records_of(const std::vector<Ongoing>& searches) {
  std::optional<Store> store;
  ricochet::Plan plan;  // each search of it depends on what others found
  plan.name = "calibration";
  plan.limits = limits;
  CampaignDescription known{text_of(plan), {}, {}, provenance_.program, provenance_.made};
  std::set<RunKey> there;
  if (std::filesystem::exists(file_)) {
    store.emplace(Store::open(file_, Store::For::reading));
    known = store->description();
    there = store->keys();
    if (known.program != provenance_.program) refuse(file_, "another program");
  }
  std::vector<const Ongoing*> missing;
  for (const Ongoing& one : searches) {
    add(known.problems, one.stored_problem(), file_);
    add(known.solvers, {one.solver->name, one.solver->version}, file_);
    if (there.insert(one.key()).second) missing.push_back(&one);
  }
  if (!missing.empty()) {
    // The longest first, so that the last ones end at about the same time.
    std::ranges::stable_sort(missing, std::ranges::greater(), &Ongoing::length);
    std::vector<Job> jobs;
    double work = 0;
    for (const Ongoing* one : missing) {
      jobs.push_back({&one->problem, one->solver, Budget{one->evaluations}, one->number});
      work += one->length();
    }
    store.emplace(grown(file_, known, store));
    Progress progress("searching", work);
    run_all(jobs, limits, [&](std::size_t k, const RunRecord& record) {
      if (!record.failure.empty()) {
        throw std::runtime_error(fmt::format("{}: {}", record.problem, record.failure));
      }
      store->add(missing[k]->key(), record);
      progress.advance(missing[k]->length());
    });
    store->finish();
  }
  std::vector<RunRecord> records;
  for (const Ongoing& one : searches) records.push_back(store->find(one.key()).value().record);
  return records;
}

void Searches::improve(std::vector<Ongoing>& searches) {
  const std::vector<RunRecord> records = records_of(searches);
  for (std::size_t i = 0; i < searches.size(); ++i) {
    if (records[i].trace.empty()) continue;
    const Improvement& found = records[i].trace.back();
    if (found.true_values.objective < searches[i].fit.loss)
      searches[i].move_to(found.x, found.true_values.objective);
  }
}

std::vector<Fit> Searches::by_turns(const std::vector<Fit>& starts, int seed,
                                    const std::vector<Turn>& turns) {
  std::vector<Ongoing> searches;
  for (const Fit& start : starts) {
    // The name alone determines the random numbers.
    searches.emplace_back(start, fmt::format("-seed-{}{}", seed, fmt::join(start.left_out, "")));
  }
  for (const auto& [solver, evaluations] : turns) {
    for (Ongoing& one : searches) one.next(*solver, evaluations);
    improve(searches);
  }
  std::vector<Fit> fits;
  for (Ongoing& one : searches) fits.push_back(std::move(one.fit));
  return fits;
}

std::vector<Fit> Searches::fits(const std::vector<Fit>& starts, const Search& search) {
  const std::int64_t sixth = search.evaluations / 3 / 2;
  return by_turns(starts, search.seed,
                  {{&search.global, search.evaluations * 2 / 3},
                   {&search.least_squares, sixth},
                   {&search.local, sixth}});
}

std::vector<Fit> Searches::polished(const std::vector<Fit>& starts, const Search& search) {
  const std::int64_t half = search.evaluations / 2;
  return by_turns(starts, search.seed, {{&search.least_squares, half}, {&search.local, half}});
}

std::vector<std::vector<Fit>> Searches::from_random_points(
    const std::vector<Parameterisation>& parameterisations, const std::vector<Solver>& solvers,
    const std::vector<int>& seeds, std::int64_t evaluations) {
  std::vector<Ongoing> searches;
  for (const Parameterisation& parameterisation : parameterisations) {
    for (const Solver& solver : solvers) {
      for (const int seed : seeds) {
        Ongoing& one = searches.emplace_back(Fit{parameterisation}, "");
        one.next(solver, evaluations);
        one.number = seed;
      }
    }
  }
  improve(searches);
  std::vector<std::vector<Fit>> fits(parameterisations.size());
  for (std::size_t i = 0; i < searches.size(); ++i)
    fits[i / (solvers.size() * seeds.size())].push_back(std::move(searches[i].fit));
  return fits;
}

}  // namespace ricochet::studies::calibration
