#include "src/contest/contest.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "src/campaign/runner.h"

namespace ricochet::contest {
namespace {

/// A question as it is put to everybody who is shown it in one form.
struct Shown {
  std::size_t question;  ///< its index in the plan
  Form form;
  Problem problem;
  std::vector<Problem> instances;
};

std::vector<Shown> all_shown(const ContestPlan& plan) {
  std::vector<Shown> all;
  for (std::size_t q = 0; q < plan.questions.size(); ++q) {
    const Question& question = plan.questions[q];
    if (!question.stated.best_known) {
      throw std::invalid_argument(question.name() + ": its best value is not known");
    }
    for (const Form& form : question.forms(plan.widths)) {
      if (plan.wants(question, form)) all.push_back({q, form, question.problem(form), {}});
    }
  }
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
    for (int i = 1; i <= plan.instances; ++i) {
      all[k].instances.push_back(plan.instance_of(all[k].problem, i));
    }
  });
  return all;
}

/// A standing of the contest, without outcomes, and what it takes to make its runs.
struct Entry {
  Standing standing;
  std::vector<Outcome> outcomes;  ///< to be
  const Solver* solver;
  const Shown* shown;
};

std::vector<Entry> entries_of(const ContestPlan& plan, const std::vector<Shown>& all) {
  std::vector<Entry> entries;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    while (end < all.size() && all[end].question == all[first].question) ++end;
    for (const Solver& solver : plan.solvers) {
      for (std::size_t k = first; k < end; ++k) {
        const Shown& shown = all[k];
        if (!solver.accepts(shown.problem)) continue;
        for (std::size_t b = 0; b < plan.budgets.size(); ++b) {
          entries.push_back({{shown.question, solver.name, shown.form, b, {}},
                             std::vector<Outcome>(shown.instances.size()),
                             &solver,
                             &shown});
        }
      }
    }
  }
  return entries;
}

/// One run of the contest, and where its outcome goes.
struct Place {
  const Entry* entry;
  Outcome* outcome;
  Job job;
  double length;  ///< of the run, about
};

std::vector<Place> places_of(const ContestPlan& plan, std::vector<Entry>& entries) {
  std::vector<Place> places;
  for (Entry& entry : entries) {
    const double cost = plan.questions[entry.shown->question].cost;
    for (std::size_t i = 0; i < entry.shown->instances.size(); ++i) {
      const Problem& problem = entry.shown->instances[i];
      const std::int64_t evaluations = plan.budgets[entry.standing.budget] * problem.dimension();
      places.push_back({&entry,
                        &entry.outcomes[i],
                        {&problem, entry.solver, {evaluations}, plan.run},
                        cost * static_cast<double>(evaluations)});
    }
  }
  // The longest first: nobody waits for the last one.
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.length > b.length; });
  return places;
}

}  // namespace

std::vector<Standing> hold(const ContestPlan& plan) {
  const std::vector<Shown> shown = all_shown(plan);
  std::vector<Entry> entries = entries_of(plan, shown);
  const std::vector<Place> places = places_of(plan, entries);
  std::vector<Job> jobs;
  double work = 0;
  for (const Place& place : places) {
    jobs.push_back(place.job);
    work += place.length;
  }
  Progress progress("comparing solvers", std::max(work, 1.0));
  run_all(jobs, plan.limits, [&](std::size_t j, RunRecord record) {
    const double tolerance = plan.questions[places[j].entry->shown->question].tolerance;
    *places[j].outcome = outcome_of(record, *jobs[j].problem, tolerance);
    progress.advance(places[j].length);
  });
  std::vector<Standing> standings;
  for (Entry& entry : entries) {
    entry.standing.outcomes = std::move(entry.outcomes);
    standings.push_back(std::move(entry.standing));
  }
  return standings;
}

}  // namespace ricochet::contest
