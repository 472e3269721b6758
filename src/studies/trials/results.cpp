#include "src/studies/trials/results.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "src/campaign/progress.h"
#include "src/studies/trials/all_trials.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

namespace {

/// What an evaluation of a trial that is searched briefly costs, in those of others.
constexpr double brief_price = 130;

struct SearchTask {
  const Trial* trial;
  TrialSearch search;

  double work() const {
    return static_cast<double>(search.evaluations) * (trial->brief ? brief_price : 1);
  }
};

/// Fetches or makes all fits, in parallel, the longest first.
std::vector<TrialFit> fits_of(const std::vector<SearchTask>& tasks, TrialFitStore& store) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tasks[a].work() > tasks[b].work(); });
  double work = 0;
  for (const SearchTask& task : tasks) work += task.work();
  Progress progress("fitting trials", work);
  std::vector<TrialFit> fits(tasks.size());
  std::atomic<std::size_t> next = 0;
  tbb::parallel_for(0U, std::max(1U, std::thread::hardware_concurrency()), [&](unsigned) {
    for (std::size_t k = next++; k < order.size(); k = next++) {
      const SearchTask& task = tasks[order[k]];
      const std::string key = key_of(*task.trial, task.search);
      if (const auto known = store.find(key)) {
        fits[order[k]] = *known;
      } else {
        fits[order[k]] = fit(*task.trial, task.search);
        store.add(key, fits[order[k]]);
      }
      progress.advance(task.work());
    }
  });
  return fits;
}

std::vector<JudgedTrial> searched(const std::vector<Trial>& all, const TrialPlan& plan,
                                  TrialFitStore& store) {
  std::vector<SearchTask> tasks;
  for (const Trial& trial : all) {
    for (const int seed : plan.seeds) {
      TrialSearch search = plan.search;
      search.seed = seed;
      if (trial.brief) search.evaluations = plan.brief_evaluations;
      tasks.push_back({&trial, search});
    }
  }
  const std::vector<TrialFit> fits = fits_of(tasks, store);
  std::vector<JudgedTrial> result;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (i % plan.seeds.size() == 0) {
      result.push_back({*tasks[i].trial, tasks[i].search.evaluations, {}, {}});
    }
    result.back().fits.push_back(fits[i]);
  }
  return result;
}

/// By counts that are trusted, or by those of steps, at the speeds of the plan.
std::vector<calibration::CaseAppraisal> judged_at(const Trial& trial,
                                                  const TrialConstants& constants,
                                                  const TrialPlan& plan) {
  return judged([&](const Case& a_case) { return trial.counts(a_case, constants, judging); },
                trial.brief ? plan.brief_step : plan.step);
}

void judge_all(std::vector<JudgedTrial>& all, const TrialPlan& plan) {
  double work = 0;
  for (const JudgedTrial& each : all) work += each.trial.brief ? 20 : 1;
  Progress progress("judging trials", work);
  for (JudgedTrial& each : all) {
    each.appraisal =
        calibration::summed_up(judged_at(each.trial, each.best().constants, plan),
                               static_cast<int>(each.trial.freed.size() + each.trial.own.size()));
    progress.advance(each.trial.brief ? 20 : 1);
  }
}

std::vector<DrawnThresholds> draws_of(const JudgedTrial& fitted, const TrialPlan& plan) {
  std::vector<DrawnThresholds> draws;
  Progress progress("drawing disturbances", static_cast<double>(plan.draws.size()));
  for (const std::uint64_t draw : plan.draws) {
    const Trial trial = random_disturbance(fitted.trial.base, draw);
    DrawnThresholds drawn{draw, misfit_of(trial, fitted.best().constants), {}};
    for (const auto& c : judged_at(trial, fitted.best().constants, plan)) {
      if (c.the_case.disturbance != 0 && c.the_case.claim.threshold) {
        drawn.thresholds.push_back(c.score.threshold);
      }
    }
    draws.push_back(std::move(drawn));
    progress.advance(1);
  }
  return draws;
}

SameConstants three_ways(const JudgedTrial& fitted, const Results& results) {
  const TrialPlan& plan = results.plan;
  const TrialConstants& constants = fitted.best().constants;
  const auto by = [&](const char* name) {
    return judged_at(results.trial(name).trial, constants, plan);
  };
  return {
      fitted.trial.name, constants, by("ode45-default"), by("ode45-tight"),
      judged([&](const Case& a_case) { return exact_walls(a_case, constants); }, plan.brief_step)};
}

}  // namespace

TrialPlan full_trial_plan(const Solver& global, const Solver& local) {
  return {{global, local, 2000}, 60, {1, 2}, 0.02, 0.1, {1, 2, 3, 4, 5, 6, 7, 8}};
}

TrialPlan quick_trial_plan(const Solver& global, const Solver& local) {
  return {{global, local, 12}, 3, {1, 2}, 0.3, 1.5, {1, 2}};
}

const TrialFit& JudgedTrial::best() const {
  return *std::min_element(fits.begin(), fits.end(), [](const TrialFit& a, const TrialFit& b) {
    return a.misfit < b.misfit;
  });
}

double JudgedTrial::worst() const {
  double worst = 0;
  for (const TrialFit& each : fits) worst = std::max(worst, each.misfit);
  return worst;
}

std::vector<Case> disturbed_cases() {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return c.disturbance == 0 || !c.claim.threshold; });
  return cases;
}

const JudgedTrial& Results::trial(const std::string& name) const {
  for (const JudgedTrial& each : trials) {
    if (each.trial.name == name) return each;
  }
  throw std::out_of_range(name);
}

const JudgedTrial& Results::baseline_of(const JudgedTrial& trial) const {
  return *std::find_if(baselines.begin(), baselines.end(), [&](const JudgedTrial& each) {
    return each.trial.base == trial.trial.base && each.trial.brief == trial.trial.brief;
  });
}

bool Results::is_nearer(const JudgedTrial& trial) const {
  return trial.worst() < baseline_of(trial).best().misfit;
}

Results try_all(const TrialPlan& plan, TrialFitStore& store) {
  Results results;
  results.plan = plan;
  std::vector<Trial> all = baselines();
  const auto baseline_count = static_cast<std::ptrdiff_t>(all.size());
  for (Trial& trial : all_trials()) all.push_back(std::move(trial));
  std::vector<JudgedTrial> found = searched(all, plan, store);
  judge_all(found, plan);
  results.baselines.assign(found.begin(), found.begin() + baseline_count);
  results.trials.assign(found.begin() + baseline_count, found.end());

  const JudgedTrial& one = results.trial("random-disturbance");
  const JudgedTrial& other = results.trial("random-disturbance-plain");
  const JudgedTrial& drawn = other.best().misfit < one.best().misfit ? other : one;
  results.drawn = drawn.trial.name;
  results.draws = draws_of(drawn, plan);

  Progress progress("integrating three ways", 2);
  for (const char* name : {"ode45-default", "ode45-tight"}) {
    results.integrations.push_back(three_ways(results.trial(name), results));
    progress.advance(1);
  }
  return results;
}

}  // namespace ricochet::studies::trials
