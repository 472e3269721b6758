#include "src/studies/contest/twin_data.h"

#include <algorithm>
#include <map>

#include "src/contest/rating.h"
#include "src/contest/twin.h"
#include "src/statistics/fisher_exact_test.h"
#include "src/statistics/holm.h"
#include "src/studies/contest/share_data.h"

namespace ricochet::studies::contest {
namespace {

using namespace ricochet::contest;
using report::Json;

constexpr Place places[] = {Place::lower_end, Place::middle, Place::upper_end};
constexpr const char* names[] = {"lower", "middle", "upper"};

}  // namespace

Json twin_data(const ContestPlan& asked) {
  ContestPlan plan = asked;
  plan.budgets = {asked.budgets.front()};
  plan.widths.clear();
  // Those that are shown what is judged: a surrogate leans by itself.
  plan.wants = [](const Question&, const Form& form) { return form.width == 0; };
  std::erase_if(plan.questions, [](const Question& q) { return !has_twins(q.stated); });
  std::map<std::string, std::map<Place, Share>> tallies;
  for (const Place place : places) {
    plan.instance_of = [place](const Problem& problem, int number) {
      return twin(problem, place, number);
    };
    for (const Standing& standing : hold(plan)) {
      const Question& question = plan.questions[standing.question];
      add_runs(tallies[competitor(standing.solver, question.name_of(standing.form))][place],
               standing);
    }
  }
  std::vector<double> p_values;
  for (auto& [solver, shares] : tallies) {
    const Share ends{shares[Place::lower_end].successes + shares[Place::upper_end].successes,
                     shares[Place::lower_end].trials + shares[Place::upper_end].trials};
    p_values.push_back(fisher_exact_test(ends, shares[Place::middle]));
  }
  const std::vector<double> adjusted = holm(p_values);
  Json rows = Json::array();
  std::size_t k = 0;
  for (const auto& [solver, shares] : tallies) {
    Json row = {{"solver", solver}, {"p_value", adjusted[k++]}};
    for (std::size_t i = 0; i < std::size(places); ++i) {
      const Share& share = shares.at(places[i]);
      row["runs"] = share.trials;
      row[names[i]] = share_data(share);
    }
    row["leans"] = adjusted[k - 1] < 0.05;
    rows.push_back(std::move(row));
  }
  return {{"questions", plan.questions.size()}, {"rows", std::move(rows)}};
}

}  // namespace ricochet::studies::contest
