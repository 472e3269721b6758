#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/research/dynamics/work.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;

constexpr std::size_t named_every = 6;  ///< dots with their tolerance or step beside them

/// Limits of the error: in a chaotic scene of the rate, else of impact times [s].
std::vector<double> limits_of(const SceneWork& work) {
  if (work.benchmark.chaotic) return {work.rate_spread};
  return {1e-6, 1e-9};
}

/// Time of the loosest trial within a limit relative to the reference.
std::optional<double> slowdown(const SceneWork& work, const MethodWork& method, double limit) {
  const auto trial = loosest_within(method, limit);
  if (!trial) return std::nullopt;
  return trial->seconds / work.methods.front().trials.front().seconds;
}

/// The same for the evaluations of the forces.
std::optional<double> evaluations_ratio(const SceneWork& work, const MethodWork& method,
                                        double limit) {
  const auto trial = loosest_within(method, limit);
  const auto own = work.methods.front().trials.front().force_evaluations;
  if (!trial || own == 0) return std::nullopt;
  return static_cast<double>(trial->force_evaluations) / static_cast<double>(own);
}

/// A small ratio is shown with one decimal.
Json data_of(const std::optional<double>& ratio) {
  return {{"ratio", ratio}, {"small", ratio && *ratio < 10}};
}

bool fails(const Trial& trial, bool chaotic) {
  return !trial.finished || (!chaotic && trial.accuracy.missed + trial.accuracy.spurious > 0);
}

/// Smallest error that is drawn: the rounding of a time, or half an impact in the rate.
double smallest_error(const SceneWork& work) {
  return work.benchmark.chaotic ? 0.5 / work.impacts : 1e-16;
}

double cost_of(const SceneWork& work, const Trial& trial) {
  return trial.seconds / work.impacts;
}

struct Errors {
  double lower, upper;
};

/// From the decade below the smallest error to the decade above the largest, where failures are
/// drawn.
Errors errors_of(const SceneWork& work) {
  Errors range{1e-3, 1e-3};
  for (const MethodWork& method : work.methods) {
    for (const Trial& trial : method.trials) {
      if (!trial.error || method.control == "none") continue;
      const double error = std::max(*trial.error, smallest_error(work));
      range = {std::min(range.lower, error), std::max(range.upper, error)};
    }
  }
  return {std::pow(10, std::floor(std::log10(range.lower))),
          std::pow(10, std::ceil(std::log10(range.upper)) + 1)};
}

/// A tolerance or step as text: "1e-4", "2e-3 s".
std::string control_text(const MethodWork& method, const Trial& trial) {
  const double exponent = std::floor(std::log10(trial.control) + 1e-9);
  return fmt::format("{:.0f}e{:.0f}{}", trial.control / std::pow(10, exponent), exponent,
                     method.control == "step [s]" ? " s" : "");
}

/// Adds the error of every trial over its processor time per impact [s]; for a method without
/// control only the time.
void add_trials(const SceneWork& work, Json& data) {
  const Errors errors = errors_of(work);
  const double spread = work.rate_spread;
  data["bottom"] = errors.lower;
  data["failed_at"] = errors.upper;
  data["top"] = 3 * errors.upper;
  data["shown_spread"] = work.benchmark.chaotic && spread > errors.lower ? Json(spread) : Json();
  data["exact"] = data["controlled"] = Json::array();
  for (const MethodWork& method : work.methods) {
    if (method.control == "none") {
      data["exact"].push_back(
          {{"method", method.method}, {"cost", cost_of(work, method.trials.front())}});
      continue;
    }
    Json trials = Json::array();
    for (std::size_t i = 0; i < method.trials.size(); ++i) {
      const Trial& trial = method.trials[i];
      const std::string control = control_text(method, trial);
      // Names beside all dots would hide the dots.
      const bool last = i + 1 == method.trials.size();
      const bool named = i == 0 || last || (!work.benchmark.chaotic && i % named_every == 0);
      trials.push_back(
          {{"cost", cost_of(work, trial)},
           {"error", trial.error ? std::max(*trial.error, smallest_error(work)) : errors.upper},
           {"control", control},
           {"named", named ? control : ""}});
    }
    data["controlled"].push_back({{"method", method.method}, {"trials", std::move(trials)}});
  }
}

/// Lists the other methods within a limit, and the fastest of them.
Json data_of(const SceneWork& work, double limit) {
  Json best;
  int reached = 0;
  for (std::size_t m = 1; m < work.methods.size(); ++m) {
    const auto ratio = slowdown(work, work.methods[m], limit);
    if (!ratio) continue;
    ++reached;
    if (!best.is_null() && *ratio >= best["ratio"]) continue;
    best = data_of(ratio);
    best["method"] = work.methods[m].method;
  }
  return {{"seconds",
           work.benchmark.chaotic ? Json() : Json(fmt::format("1e{:.0f}", std::log10(limit)))},
          {"best", std::move(best)},
          {"reached", reached},
          {"others", work.methods.size() - 1}};
}

/// A method at its tightest control, and its cost at the limits.
Json data_of(const SceneWork& work, const MethodWork& method) {
  const Trial& tightest = method.trials.back();
  const bool chaotic = work.benchmark.chaotic;
  const auto if_known = [](bool known, int value) { return known ? Json(value) : Json(); };
  Json data = {
      {"method", method.method},
      {"tightest", method.control == "none" ? Json() : Json(tightest.control)},
      {"step", method.control == "step [s]"},
      {"finished", tightest.finished},
      {"count_difference", if_known(tightest.finished, tightest.accuracy.count_difference)},
      {"missed", if_known(tightest.finished && !chaotic, tightest.accuracy.missed)},
      {"spurious", if_known(tightest.finished && !chaotic, tightest.accuracy.spurious)},
      {"error", tightest.error},
      {"good", fails(tightest, chaotic) ? Json(false) : Json()},
      {"times", Json::array()}};
  for (const double limit : limits_of(work)) {
    data["times"].push_back(data_of(slowdown(work, method, limit)));
  }
  return data;
}

}  // namespace

Json data_of(const SceneWork& work) {
  const BenchmarkScene& benchmark = work.benchmark;
  const auto if_chaotic = [&](double value) { return benchmark.chaotic ? Json(value) : Json(); };
  Json data = {{"id", benchmark.id},
               {"name", benchmark.name},
               {"description", benchmark.description},
               {"chaotic", benchmark.chaotic},
               {"impacts", work.impacts},
               {"microseconds", 1e6 * cost_of(work, work.methods.front().trials.front())},
               {"mean_impacts", if_chaotic(work.mean_impacts)},
               {"spread_percent", if_chaotic(100 * work.rate_spread)},
               {"limits", Json::array()},
               {"failing", Json::array()},
               {"methods", Json::array()}};
  for (const double limit : limits_of(work)) data["limits"].push_back(data_of(work, limit));
  for (const MethodWork& method : work.methods) {
    data["methods"].push_back(data_of(work, method));
    if (fails(method.trials.back(), benchmark.chaotic)) data["failing"].push_back(method.method);
  }
  add_trials(work, data);
  return data;
}

Json speed_data(const std::vector<SceneWork>& works) {
  Json data = {{"scenes", Json::array()}, {"times", Json::array()}, {"evaluations", Json::array()}};
  for (const SceneWork& work : works) data["scenes"].push_back(work.benchmark.id);
  std::vector<double> compared;
  int failed = 0;
  for (std::size_t m = 1; m < works.front().methods.size(); ++m) {
    Json times = Json::array(), evaluations = Json::array();
    for (const SceneWork& work : works) {
      const double limit = limits_of(work).front();
      const auto time = slowdown(work, work.methods[m], limit);
      times.push_back(data_of(time));
      evaluations.push_back(data_of(evaluations_ratio(work, work.methods[m], limit)));
      if (work.benchmark.chaotic) continue;
      failed += time ? 0 : 1;
      if (time) compared.push_back(*time);
    }
    const std::string& method = works.front().methods[m].method;
    data["times"].push_back({{"method", method}, {"ratios", std::move(times)}});
    data["evaluations"].push_back({{"method", method}, {"ratios", std::move(evaluations)}});
  }
  std::sort(compared.begin(), compared.end());
  const bool any = !compared.empty();
  data["least"] = data_of(any ? std::optional(compared.front()) : std::nullopt);
  data["most"] = data_of(any ? std::optional(compared.back()) : std::nullopt);
  data["failed"] = failed;
  data["pairs"] = compared.size() + static_cast<std::size_t>(failed);
  return data;
}

}  // namespace ricochet::studies::dynamics
