#include "src/research/calibration/variant_results.h"

#include <algorithm>
#include <stdexcept>

#include "src/core/progress.h"
#include "src/research/calibration/variants/all_variants.h"

namespace ricochet::studies::calibration {

using namespace carrier_track;
using namespace variants;

namespace {

std::vector<JudgedVariant> fitted(const std::vector<ModelVariant>& all, const VariantPlan& plan,
                                  FitStore& store) {
  std::vector<JudgedVariant> result;
  std::vector<FitTask> tasks;
  for (const ModelVariant& variant : all) {
    Search search = with_evaluations(
        plan.search, variant.brief ? plan.brief_evaluations : plan.search.evaluations);
    for (const int seed : plan.seeds) {
      search.seed = seed;
      tasks.push_back(fit_task(variant, search));
    }
    result.push_back({variant, search.evaluations, {}, {}});
  }
  const std::vector<Fit> fits = fits_by("fitting model variants", tasks, store);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    result[i / plan.seeds.size()].fits.push_back(fits[i]);
  }
  return result;
}

std::vector<CaseAppraisal> judged_at(const ModelVariant& variant, const VariantConstants& constants,
                                     const VariantPlan& plan) {
  return judged([&](const Case& a_case) { return variant.counts(a_case, constants, judging); },
                variant.brief ? plan.brief_step : plan.step);
}

void judge_all(std::vector<JudgedVariant>& all, const VariantPlan& plan) {
  const auto price = [](const JudgedVariant& each) { return each.variant.brief ? 20 : 1; };
  double work = 0;
  for (const JudgedVariant& each : all) work += price(each);
  Progress progress("judging model variants", work);
  for (JudgedVariant& each : all) {
    each.appraisal =
        summed_up(judged_at(each.variant, variant_constants(each.best()), plan),
                  static_cast<int>(each.variant.free.size() + each.variant.own.size()));
    progress.advance(price(each));
  }
}

std::vector<DrawnThresholds> draws_of(const JudgedVariant& fitted, const VariantPlan& plan) {
  std::vector<DrawnThresholds> draws;
  const VariantConstants constants = variant_constants(fitted.best());
  Progress progress("drawing disturbances", static_cast<double>(plan.draws.size()));
  for (const std::uint64_t draw : plan.draws) {
    const ModelVariant variant = random_disturbance(fitted.variant.base, draw);
    DrawnThresholds drawn{draw, loss_of(variant, constants), {}};
    for (const CaseAppraisal& c : judged_at(variant, constants, plan)) {
      if (c.the_case.disturbance != 0 && c.the_case.claim.threshold) {
        drawn.thresholds.push_back(c.score.threshold);
      }
    }
    draws.push_back(std::move(drawn));
    progress.advance(1);
  }
  return draws;
}

SameConstants three_ways(const JudgedVariant& fitted, const VariantResults& results) {
  const VariantConstants constants = variant_constants(fitted.best());
  const auto by = [&](const char* name) {
    return judged_at(results.variant(name).variant, constants, results.plan);
  };
  return {fitted.variant.name, constants.own.at(0), by("ode45-default"), by("ode45-tight"),
          judged([&](const Case& a_case) { return exact_walls(a_case, constants); },
                 results.plan.brief_step)};
}

}  // namespace

VariantPlan full_variant_plan(const Solver& global, const Solver& local) {
  return {{global, {}, local, 2000}, 60, {1, 2}, 0.02, 0.1, {1, 2, 3, 4, 5, 6, 7, 8}};
}

VariantPlan quick_variant_plan(const Solver& global, const Solver& local) {
  return {{global, {}, local, 12}, 3, {1, 2}, 0.3, 1.5, {1, 2}};
}

const Fit& JudgedVariant::best() const {
  return *std::ranges::min_element(fits, {}, &Fit::loss);
}

double JudgedVariant::worst() const {
  return std::ranges::max_element(fits, {}, &Fit::loss)->loss;
}

std::vector<Case> disturbed_cases() {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return c.disturbance == 0 || !c.claim.threshold; });
  return cases;
}

const JudgedVariant& VariantResults::variant(const std::string& name) const {
  for (const JudgedVariant& each : variants) {
    if (each.variant.name == name) return each;
  }
  throw std::out_of_range(name);
}

const JudgedVariant& VariantResults::baseline_of(const JudgedVariant& variant) const {
  return *std::ranges::find_if(baselines, [&](const JudgedVariant& each) {
    return each.variant.base == variant.variant.base && each.variant.brief == variant.variant.brief;
  });
}

bool VariantResults::is_nearer(const JudgedVariant& variant) const {
  return variant.worst() < baseline_of(variant).best().loss;
}

VariantResults try_variants(const VariantPlan& plan, FitStore& store) {
  VariantResults results;
  results.plan = plan;
  std::vector<ModelVariant> all = baselines();
  const auto baseline_count = static_cast<std::ptrdiff_t>(all.size());
  std::ranges::move(all_variants(), std::back_inserter(all));
  std::vector<JudgedVariant> found = fitted(all, plan, store);
  judge_all(found, plan);
  results.baselines.assign(found.begin(), found.begin() + baseline_count);
  results.variants.assign(found.begin() + baseline_count, found.end());

  const JudgedVariant& one = results.variant("random-disturbance");
  const JudgedVariant& other = results.variant("random-disturbance-plain");
  const JudgedVariant& drawn = other.best().loss < one.best().loss ? other : one;
  results.drawn = drawn.variant.name;
  results.draws = draws_of(drawn, plan);

  Progress progress("integrating three ways", 2);
  for (const char* name : {"ode45-default", "ode45-tight"}) {
    results.integrations.push_back(three_ways(results.variant(name), results));
    progress.advance(1);
  }
  std::ranges::stable_sort(results.variants, {},
                           [](const JudgedVariant& each) { return each.best().loss; });
  return results;
}

}  // namespace ricochet::studies::calibration
