#include "src/contest/contest.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

#include "src/campaign/progress.h"

namespace ricochet::contest {
namespace {

/// Every standing of the contest, without outcomes, and its solver.
struct Entry {
  Standing standing;
  const Solver* solver;
};

std::vector<Entry> entries_of(const Plan& plan) {
  std::vector<Entry> entries;
  for (std::size_t q = 0; q < plan.questions.size(); ++q) {
    const Question& question = plan.questions[q];
    if (!question.stated.best_known) {
      throw std::invalid_argument(question.name() + ": its best value is not known");
    }
    for (const Solver& solver : plan.solvers) {
      for (const Form& form : forms_of(question, plan.widths)) {
        if (!plan.wants(question, form) || !solver.accepts(question.problem(form))) continue;
        for (std::size_t b = 0; b < plan.budgets.size(); ++b) {
          entries.push_back({{q, solver.name, form, b, {}}, &solver});
        }
      }
    }
  }
  return entries;
}

}  // namespace

std::vector<Form> forms_of(const Question& question, const std::vector<double>& widths) {
  std::vector<Form> forms = question.forms();
  if (!question.stated.smoothed) return forms;
  for (const double width : widths) {
    for (const bool penalised : {false, true}) {
      const Form form{width, penalised};
      if (penalised && question.stated.constraints == 0) continue;
      if (std::find(forms.begin(), forms.end(), form) == forms.end()) forms.push_back(form);
    }
  }
  return forms;
}

std::vector<Standing> hold(const Plan& plan) {
  std::vector<Entry> entries = entries_of(plan);
  const auto instances = static_cast<std::size_t>(plan.instances);
  double work = 0;
  for (Entry& entry : entries) {
    entry.standing.outcomes.resize(instances);
    work += static_cast<double>(plan.budgets[entry.standing.budget]) * plan.instances;
  }
  Progress progress("comparing solvers", std::max(work, 1.0));
  // The longest first: nobody waits for the last one.
  std::vector<std::size_t> order(entries.size() * instances);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto length = [&](std::size_t job) {
    const Standing& standing = entries[job / instances].standing;
    const Question& question = plan.questions[standing.question];
    return question.cost * static_cast<double>(question.stated.dimension()) *
           static_cast<double>(plan.budgets[standing.budget]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, order.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          auto& [standing, solver] = entries[order[i] / instances];
          const std::size_t number = order[i] % instances;
          const Question& question = plan.questions[standing.question];
          const Problem shown =
              plan.instance_of(question.problem(standing.form), static_cast<int>(number) + 1);
          const Budget budget{plan.budgets[standing.budget] * shown.dimension()};
          const RunRecord record = run(shown, *solver, budget, plan.run);
          standing.outcomes[number] = outcome_of(record, shown, question.tolerance);
          progress.advance(static_cast<double>(plan.budgets[standing.budget]));
        }
      },
      tbb::simple_partitioner());
  std::vector<Standing> standings;
  for (Entry& entry : entries) standings.push_back(std::move(entry.standing));
  return standings;
}

}  // namespace ricochet::contest
