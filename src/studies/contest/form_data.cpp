#include "src/studies/contest/form_data.h"

#include <algorithm>
#include <map>

#include "src/contest/ceiling.h"
#include "src/statistics/wilson_interval.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

struct Tally {
  int solved = 0;
  int runs = 0;
};

}  // namespace

Json form_data(const Plan& plan, const std::vector<Standing>& standings,
               const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    std::map<std::string, std::map<std::string, Tally>> tallies;
    for (const Standing& standing : standings) {
      const bool here = std::find(group.questions.begin(), group.questions.end(),
                                  standing.question) != group.questions.end();
      if (!here || standing.budget + 1 != plan.budgets.size()) continue;
      Tally& tally =
          tallies[standing.solver][plan.questions[standing.question].name_of(standing.form)];
      for (const Outcome& outcome : standing.outcomes) {
        ++tally.runs;
        tally.solved += outcome.verdict.solved ? 1 : 0;
      }
    }
    for (const auto& [solver, forms] : tallies) {
      if (forms.size() < 2) continue;
      for (const auto& [form, tally] : forms) {
        const Interval interval = wilson_interval(tally.solved, tally.runs);
        rows.push_back({{"family", group.family},
                        {"solver", solver},
                        {"form", form},
                        {"runs", tally.runs},
                        {"share", tally.solved / static_cast<double>(tally.runs)},
                        {"lower", interval.lower},
                        {"upper", interval.upper}});
      }
    }
  }
  return rows;
}

Json ceiling_data(const Plan& plan) {
  Json rows = Json::array();
  for (const Question& question : plan.questions) {
    for (const Form& form : forms_of(question, plan.widths)) {
      if (form.width == 0 || form.penalised) continue;
      const auto found = ceiling(question, form.width);
      if (!found) continue;
      rows.push_back({{"question", question.name()},
                      {"width", form.width},
                      {"optimum", found->optimum},
                      {"best", (*question.stated.best_point)[0]},
                      {"distance", found->distance},
                      {"regret", found->regret},
                      {"solves", found->regret && *found->regret <= question.tolerance}});
    }
  }
  return rows;
}

}  // namespace ricochet::studies::contest
