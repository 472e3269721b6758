#include "src/campaign/campaign.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "src/core/error.h"
#include "src/core/patterns.h"

namespace ricochet {
namespace {

/// Refuses a pattern that fits none of the names.
void check_patterns(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                    const std::string& place) {
  for (const std::string& pattern : patterns) require_fit({pattern}, names, place);
}

std::vector<Form> forms_of(const Question& question, const PlanPart& part) {
  std::vector<Form> forms = question.forms(part.widths);
  std::erase_if(forms, [&](const Form& f) { return !fits_any(question.name_of(f), part.forms); });
  return forms;
}

std::optional<std::int64_t> gradient_price_of(const std::string& price, const Question& question) {
  if (price == "n") return std::nullopt;
  if (price == "measured") return question.gradient_cost;
  return std::stoll(price);
}

struct Chosen {
  const Question* question;
  const std::string* family;
};

bool asks_for(const PlanPart& part, const Question& question) {
  const std::int64_t n = question.stated.dimension();
  return fits_any(question.name(), part.questions) && n >= part.least_variables &&
         n <= part.most_variables &&
         (!part.constrained || *part.constrained == (question.stated.constraints > 0));
}

std::vector<Chosen> questions_of(const PlanPart& part, const std::vector<Family>& families,
                                 const std::string& place) {
  std::vector<Chosen> chosen;
  std::vector<std::string> names;
  for (const Family& family : families) {
    for (const Question& question : family.questions) {
      if (!question.stated.best_known) continue;
      names.push_back(question.name());
      if (asks_for(part, question)) chosen.push_back({&question, &family.name});
    }
  }
  check_patterns(part.questions, names, place + ", questions");
  return chosen;
}

/// The families asked of the part's grid of machines. Best values are sought where they are asked
/// for.
std::vector<Family> families_of_grid(const PlanPart& part, const Catalogue& catalogue) {
  if (part.machines.around.empty()) return {};
  std::vector<Family> families = catalogue.families_of(part.machines);
  std::vector<Question*> sought;
  for (Family& family : families) {
    for (Question& question : family.questions) {
      const bool can_be = question.stated.dimension() == 1 && !question.stated.best_known;
      if (can_be && asks_for(part, question)) sought.push_back(&question);
    }
  }
  tbb::parallel_for(std::size_t{0}, sought.size(), [&](std::size_t k) {
    *sought[k] = catalogue.with_best(std::move(*sought[k]));
  });
  return families;
}

/// `own_texts`: by name, how the solvers of the user's own are called in the plan.
std::vector<Solver> solvers_of(const PlanPart& part, const Catalogue& catalogue,
                               std::map<std::string, std::string>& own_texts,
                               const std::string& place) {
  std::vector<std::string> patterns;
  std::vector<Solver> own;
  std::vector<std::string> names;
  for (const Solver& solver : catalogue.solvers) names.push_back(solver.name);
  for (const std::string& text : part.solvers) {
    if (auto solver = catalogue.own_solver ? catalogue.own_solver(text) : std::nullopt) {
      const std::string& known = own_texts.try_emplace(solver->name, text).first->second;
      if (known != text || std::find(names.begin(), names.end(), solver->name) != names.end()) {
        throw InputError(fmt::format("{}, solvers {}: there is another solver of its name, {}",
                                     place, text, solver->name));
      }
      names.push_back(solver->name);
      own.push_back(*std::move(solver));
    } else {
      patterns.push_back(text);
    }
  }
  check_patterns(patterns, names, place + ", solvers");
  std::vector<Solver> chosen;
  for (const Solver& solver : catalogue.solvers) {
    if (fits_any(solver.name, patterns)) chosen.push_back(solver);
  }
  chosen.insert(chosen.end(), own.begin(), own.end());
  return chosen;
}

std::vector<const Feature*> features_of(const PlanPart& part, const std::string& place) {
  std::vector<const Feature*> chosen;
  std::vector<std::string> names;
  for (const Feature& feature : all_features()) {
    names.push_back(feature.name);
    if (fits_any(feature.name, part.features)) chosen.push_back(&feature);
  }
  check_patterns(part.features, names, place + ", features");
  return chosen;
}

/// Those of the plan stand behind those of the suite.
Catalogue with_varied_solvers(Catalogue catalogue, const Plan& plan) {
  for (const VariedSolver& varied : plan.solvers) {
    const std::string place = "solver " + varied.name;
    for (const Solver& solver : catalogue.solvers) {
      if (solver.name != varied.name) continue;
      throw InputError(place + ": there is another solver of its name");
    }
    try {
      catalogue.solvers.push_back(catalogue.varied_solver(varied));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", place, error.what()));
    }
  }
  return catalogue;
}

}  // namespace

Campaign::Campaign(Plan plan, const Catalogue& catalogue) : plan_(std::move(plan)) {
  const Catalogue whole = with_varied_solvers(catalogue, plan_);
  for (std::size_t part = 0; part < plan_.parts.size(); ++part) add_part(part, whole);
}

std::size_t Campaign::index_of(const Question& question, const std::string& family) {
  const auto [place, fresh] = question_places_.try_emplace(question.name(), questions_.size());
  if (fresh) {
    questions_.push_back(question);
    families_.push_back(family);
  }
  return place->second;
}

std::size_t Campaign::index_of(const Solver& solver) {
  const auto [place, fresh] = solver_places_.try_emplace(solver.name, solvers_.size());
  if (fresh) solvers_.push_back(solver);
  return place->second;
}

void Campaign::add_part(std::size_t part_index, const Catalogue& catalogue) {
  const PlanPart& part = plan_.parts[part_index];
  const std::string place = fmt::format("part {}", part_index + 1);
  const std::vector<Family> of_grid = families_of_grid(part, catalogue);
  const auto chosen =
      questions_of(part, part.machines.around.empty() ? catalogue.families : of_grid, place);
  const std::vector<Solver> solvers = solvers_of(part, catalogue, own_texts_, place);
  const std::vector<const Feature*> features = features_of(part, place);
  bool any = false;
  const auto add = [&](const Question& question, const std::string& family, const Form& form,
                       const Feature& feature, const Solver& solver) {
    for (const std::string& price : part.gradient_prices) {
      for (const std::int64_t budget : part.budgets) {
        const Cell cell{
            question.name(), question.name_of(form), feature.name, solver.name, budget, price};
        const auto [known, fresh] = places_.try_emplace(cell, cells_.size());
        if (fresh) {
          Budget spent{budget * question.stated.dimension()};
          spent.gradient_price = gradient_price_of(price, question);
          cells_.push_back({cell,
                            index_of(question, family),
                            form,
                            &feature,
                            index_of(solver),
                            spent,
                            part.instances,
                            part.seeds,
                            {}});
        }
        PlannedCell& planned = cells_[known->second];
        planned.instances = std::max(planned.instances, part.instances);
        planned.seeds = std::max(planned.seeds, part.seeds);
        planned.parts.push_back(part_index);
        any = true;
      }
    }
  };
  for (const auto& [question, family] : chosen) {
    for (const Form& form : forms_of(*question, part)) {
      const Problem problem = question->problem(form);
      for (const Feature* feature : features) {
        if (!feature->applies(problem)) continue;
        const Problem seen = feature->perturbed(problem, 0);
        for (const Solver& solver : solvers) {
          if (solver.accepts(seen)) add(*question, *family, form, *feature, solver);
        }
      }
    }
  }
  if (!any) {
    throw InputError(
        fmt::format("{}: none of its solvers takes any of its questions in a form "
                    "and with a feature that it names",
                    place));
  }
}

const PlannedCell* Campaign::find(const Cell& cell) const {
  const auto place = places_.find(cell);
  return place == places_.end() ? nullptr : &cells_[place->second];
}

std::int64_t Campaign::runs() const {
  std::int64_t runs = 0;
  for (const PlannedCell& cell : cells_) runs += std::int64_t{cell.instances} * cell.seeds;
  return runs;
}

double Campaign::work() const {
  double work = 0;
  for (const PlannedCell& cell : cells_) {
    work += questions_[cell.question].cost * static_cast<double>(cell.budget.evaluations) *
            cell.instances * cell.seeds;
  }
  return work;
}

CampaignDescription Campaign::description() const {
  CampaignDescription description;
  description.plan = text_of(plan_);
  for (std::size_t q = 0; q < questions_.size(); ++q) {
    const Question& question = questions_[q];
    const Problem& stated = question.stated;
    description.questions.push_back({question.name(), families_[q], question.machine,
                                     stated.dimension(), stated.constraints, stated.equalities,
                                     question.tolerance, *stated.best_known, question.factors});
  }
  for (const Solver& solver : solvers_) {
    description.solvers.push_back({solver.name, solver.version});
  }
  return description;
}

}  // namespace ricochet
