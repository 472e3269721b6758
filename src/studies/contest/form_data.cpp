#include "src/studies/contest/form_data.h"

#include <utility>

#include "src/contest/ceiling.h"
#include "src/studies/contest/share_data.h"

namespace ricochet::studies::contest {
using report::Json;

namespace {

void add_ceilings(Json& rows, const ContestPlan& plan, const Group& group) {
  for (const std::size_t q : group.questions) {
    const Question& question = plan.questions[q];
    for (const Form& form : question.forms(plan.widths)) {
      if (form.width == 0 || form.penalised) continue;
      const auto found = ceiling(question, form.width);
      if (!found) continue;
      rows.push_back({{"family", group.family},
                      {"question", question.name()},
                      {"width", form.width},
                      {"optimum", found->optimum},
                      {"best", (*question.stated.best_point)[0]},
                      {"distance", found->distance},
                      {"regret", found->regret},
                      {"solves", found->regret && *found->regret <= question.tolerance}});
    }
  }
}

}  // namespace

Json form_data(const ContestPlan& plan, const std::vector<Standing>& standings,
               const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    for (const auto& [solver, forms] : shares_by_form(plan, standings, group)) {
      if (forms.size() < 2) continue;
      for (const auto& [form, share] : forms) {
        Json row = {
            {"family", group.family}, {"solver", solver}, {"form", form}, {"runs", share.trials}};
        row.update(share_data(share));
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

Json ceiling_data(const ContestPlan& plan, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) add_ceilings(rows, plan, group);
  return rows;
}

}  // namespace ricochet::studies::contest
