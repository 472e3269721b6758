#include "src/studies/choice/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet::studies::choice {

namespace {

using namespace ricochet::comparison;

constexpr int resamples = 1000;

/// The problem as the setting declares it.
Problem declared(const Problem& problem, const Setting& setting) {
  if (setting.derivatives) return problem;
  Problem result = problem;
  result.differentiate = nullptr;
  result.lagrangian_hessian = nullptr;
  result.residuals = nullptr;
  result.smoothed = nullptr;
  return result;
}

bool may_run(const PlannedCell& cell, const Capabilities& can, const Setting& setting) {
  if (setting.derivatives) return true;
  return can.derivatives == Capabilities::Order::value && !can.needs_residuals &&
         !can.needs_smoothing && cell.formulation.smoothing == 0;
}

/// A solver and how it sees the problem, in words that mean the same for every family.
std::string entry_of(const std::string& solver, const Problem& problem,
                     const Formulation& formulation) {
  std::string name = solver;
  if (formulation.penalised) name += ", penalised";
  if (formulation.smoothing > 0) {
    const bool usual = formulation.smoothing == problem.smoothing;
    name += usual ? ", surrogate" : fmt::format(", surrogate-{}", formulation.smoothing);
  }
  return name;
}

double solved_share(const Outcomes& outcomes) {
  double solved = 0;
  for (const Outcome& outcome : outcomes) solved += outcome.solved() ? 1 : 0;
  return solved / static_cast<double>(outcomes.size());
}

}  // namespace

const std::vector<Setting>& all_settings() {
  static const std::vector<Setting> settings = {
      {"gradients at their measured cost", true, true},
      {"gradients at the cost of differences", true, false},
      {"values alone", false, false}};
  return settings;
}

const Setting& setting_of(const Problem& problem) {
  if (!problem.differentiate && !problem.residuals && !problem.smoothed) return all_settings()[2];
  return all_settings()[problem.gradient_cost.value_or(problem.dimension()) < problem.dimension()
                            ? 0
                            : 1];
}

std::vector<Case> cases_of(const Evidence& evidence, const Setting& setting) {
  const auto& [name, campaign, results] = evidence;
  const std::map<std::size_t, std::int64_t> largest = largest_budgets(results);
  std::map<std::size_t, std::map<std::string, double>> shares;
  std::map<std::size_t, Budget> budgets;
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const Solver& solver = campaign.solvers()[cell.solver];
    const bool counts = cell.cell.perturbation == "plain" &&
                        cell.cell.budget == largest.at(cell.problem) &&
                        cell.is_at_price(setting.measured ? "measured" : "n") && !solver.chooses &&
                        may_run(cell, solver.capabilities, setting);
    if (!counts) continue;
    shares[cell.problem][entry_of(solver.name, campaign.problems()[cell.problem],
                                  cell.formulation)] = solved_share(result.outcomes);
    budgets[cell.problem].evaluations = cell.budget.evaluations;
  }
  std::vector<Case> cases;
  for (auto& [place, of_entries] : shares) {
    const Problem problem = declared(campaign.problems()[place], setting);
    Budget budget = budgets[place];
    if (setting.measured) budget.gradient_price = problem.gradient_cost;
    const std::optional<Choice> choice = choice_of(Evaluator(problem, budget), campaign.solvers());
    if (!choice) continue;
    for (const Formulation& formulation : problem.formulations()) {
      if (formulation.penalised) continue;
      std::string chosen = entry_of(choice->solver, problem, formulation);
      if (!of_entries.contains(chosen)) continue;
      cases.push_back({problem.name, campaign.family_of(place), problem.cluster, choice->line,
                       std::move(chosen), std::move(of_entries)});
      break;
    }
  }
  return cases;
}

double Case::share_of(const std::string& entry) const {
  const auto found = shares.find(entry);
  return found == shares.end() ? 0 : found->second;
}

std::vector<Case> only(const std::vector<Case>& cases,
                       const std::function<bool(const Case&)>& wanted) {
  std::vector<Case> some;
  std::copy_if(cases.begin(), cases.end(), std::back_inserter(some), wanted);
  return some;
}

std::map<std::string, std::vector<std::size_t>> by_family(const std::vector<Case>& cases) {
  std::map<std::string, std::vector<std::size_t>> families;
  for (std::size_t i = 0; i < cases.size(); ++i) families[cases[i].family].push_back(i);
  return families;
}

Sample all_of(const std::vector<Case>& cases) {
  Sample sample;
  for (auto& [family, places] : by_family(cases)) sample.push_back(places);
  return sample;
}

double mean_over_families(const Sample& sample, const std::vector<double>& values) {
  double sum = 0;
  for (const auto& places : sample) {
    double of_family = 0;
    for (const std::size_t i : places) of_family += values[i];
    sum += of_family / static_cast<double>(places.size());
  }
  return sum / static_cast<double>(sample.size());
}

std::vector<Sample> resampled(const std::vector<Case>& cases) {
  std::vector<std::vector<std::vector<std::size_t>>> families;  // clusters of places
  for (const auto& [family, places] : by_family(cases)) {
    std::vector<std::string> names;
    for (const std::size_t i : places) names.push_back(cases[i].cluster);
    families.push_back(places_by_cluster(names));
    for (auto& cluster : families.back()) {
      for (std::size_t& place : cluster) place = places[place];
    }
  }
  Random random(1);
  std::vector<Sample> samples(resamples);
  for (Sample& sample : samples) {
    for (const auto& clusters : families) {
      std::vector<std::size_t>& places = sample.emplace_back();
      for (std::size_t k = 0; k < clusters.size(); ++k) {
        const auto drawn =
            static_cast<std::size_t>(uniform(random) * static_cast<double>(clusters.size()));
        places.insert(places.end(), clusters[drawn].begin(), clusters[drawn].end());
      }
    }
  }
  return samples;
}

std::vector<double> values_of(const std::vector<Case>& cases,
                              const std::function<double(const Case&)>& value) {
  std::vector<double> values;
  for (const Case& each : cases) values.push_back(value(each));
  return values;
}

std::vector<double> chosen_shares(const std::vector<Case>& cases) {
  return values_of(cases, [](const Case& each) { return each.share_of(each.chosen); });
}

std::vector<Standing> standings(const std::vector<Case>& cases) {
  std::set<std::string> names;
  for (const Case& each : cases) {
    for (const auto& [name, share] : each.shares) names.insert(name);
  }
  const Sample all = all_of(cases);
  std::vector<Standing> order;
  for (const std::string& name : names) {
    std::vector<double> shares =
        values_of(cases, [&](const Case& each) { return each.share_of(name); });
    const double mean = mean_over_families(all, shares);
    order.push_back({name, std::move(shares), mean});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Standing& a, const Standing& b) { return a.mean > b.mean; });
  return order;
}

std::vector<double> probabilities_of_being_first(const std::vector<Case>& cases,
                                                 const std::vector<Standing>& order) {
  std::vector<double> probabilities(order.size());
  for (const Sample& sample : resampled(cases)) {
    std::vector<double> means;
    for (const Standing& each : order) means.push_back(mean_over_families(sample, each.shares));
    const double most = *std::max_element(means.begin(), means.end());
    const auto first = static_cast<double>(std::count(means.begin(), means.end(), most));
    for (std::size_t i = 0; i < means.size(); ++i) {
      if (means[i] == most) probabilities[i] += 1 / (first * resamples);
    }
  }
  return probabilities;
}

}  // namespace ricochet::studies::choice
