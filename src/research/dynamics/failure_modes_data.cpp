#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/research/dynamics/failure_modes.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;

/// A magnitude, and whether it is readable without a power of ten.
Json size_of(double value) {
  const double size = std::abs(value);
  return {{"size", size}, {"plain", size == 0 || (size >= 0.01 && size < 1000)}};
}

Json data_of(const Zeno& zeno) {
  const double late = zeno.rest_late;
  const bool rests = zeno.finished && zeno.rest;
  return {{"finished", zeno.finished},
          {"rests", rests},
          {"seconds_late", late},
          {"off", rests && std::abs(late) >= 1e-5 ? size_of(late) : Json()},
          {"early", late <= 0},
          {"good", rests && std::abs(late) < std::max(1e-5, 1e-3 * zeno.end_of_impacts)}};
}

/// The least overshoot from which on all shares are one; nothing if there is none.
std::optional<double> all_right_from(const std::vector<double>& overshoots,
                                     const std::vector<double>& shares) {
  std::optional<double> least;
  for (std::size_t k = 0; k < shares.size() && shares[k] == 1; ++k) least = overshoots[k];
  return least;
}

Json grazes_of(const MethodFailures& method, const std::vector<double>& overshoots) {
  const auto seen = all_right_from(overshoots, method.touched);
  const auto spared = all_right_from(overshoots, method.missed);
  const bool sees_all = seen == overshoots.back();
  const bool invents_none = spared == overshoots.back();
  return {{"seen_from", seen},
          {"sees_all", sees_all},
          {"spared_from", spared},
          {"invents_none", invents_none},
          {"good", sees_all && invents_none}};
}

Json data_of(const Sticking& sticking, int decades) {
  const bool in_time = sticking.noticed && *sticking.noticed < 1.5 * std::pow(10.0, -decades);
  return {{"gave_up", sticking.gave_up},
          {"creep", sticking.creep > 0 ? size_of(sticking.creep) : Json()},
          {"noticed", sticking.noticed},
          {"in_time", in_time},
          {"too_early", sticking.breaks_loose_early},
          {"good",
           !sticking.gave_up && in_time && sticking.creep == 0 && !sticking.breaks_loose_early}};
}

Json elastic_data(const Elastic& elastic) {
  const double ratio = elastic.energy_ratio;
  const double drift = ratio - 1;
  const bool lost = ratio<0.01, multiplied = ratio> 2, kept = std::abs(drift) < 1e-8;
  return {{"strikes", elastic.seen > 0},
          {"seen", elastic.seen},
          {"impacts", elastic.impacts},
          {"sees_all", elastic.seen == elastic.impacts},
          {"energy_ratio", ratio},
          {"lost", lost},
          {"multiplied", multiplied},
          {"kept", kept},
          {"percent", lost || multiplied || kept ? Json() : size_of(100 * drift)},
          {"gains", drift > 0},
          {"good", elastic.seen == elastic.impacts && std::abs(drift) < 1e-3}};
}

Json data_of(const ChaoticRate& rate) {
  return {{"finished", rate.finished},
          {"error", rate.error},
          {"good", rate.finished && std::abs(rate.error) <= rate.uncertainty}};
}

Json data_of(const FailureModeStudy& study, const MethodFailures& method) {
  return {{"method", method.method},
          {"zeno", data_of(method.zeno)},
          {"grazes", grazes_of(method, study.overshoots)},
          {"sticking", data_of(method.sticking, study.plan.decades)},
          {"elastic", report::list_of(method.elastic, elastic_data)},
          {"rate", data_of(method.rate)}};
}

/// By how much a wall is missed (-) or overshot (+), in swings, in the order of rights_of.
Json touches_of(const std::vector<double>& overshoots) {
  Json touches = Json::array();
  for (const double by : overshoots) {
    touches.push_back(fmt::format("-1e{:.0f}", std::log10(by)));
  }
  for (auto by = overshoots.rbegin(); by != overshoots.rend(); ++by) {
    touches.push_back(fmt::format("+1e{:.0f}", std::log10(*by)));
  }
  return touches;
}

/// Share of correct decisions of a method, in whole per cent.
Json rights_of(const MethodFailures& method) {
  Json rights = Json::array();
  for (const double share : method.missed) rights.push_back(std::round(100 * share));
  for (auto share = method.touched.rbegin(); share != method.touched.rend(); ++share) {
    rights.push_back(std::round(100 * *share));
  }
  return {{"method", method.method}, {"right", std::move(rights)}};
}

/// Number of failure modes in which a method of control_data fails.
int failures(const Json& method) {
  int failed = 0;
  for (const char* mode : {"zeno", "grazes", "sticking", "rate"}) {
    failed += method[mode]["good"] == false;
  }
  for (const Json& elastic : method["elastic"]) failed += elastic["good"] == false;
  return failed;
}

/// Number of methods that fail in a failure mode.
int failing(const Json& methods, const char* mode) {
  return static_cast<int>(std::count_if(methods.begin(), methods.end(), [&](const Json& method) {
    return method[mode]["good"] == false;
  }));
}

Json control_data(const FailureModeStudy& study, const std::vector<MethodFailures>& methods,
                  const std::string& control) {
  const auto failures_of = [&](const MethodFailures& method) { return data_of(study, method); };
  Json rows = report::list_of(methods, failures_of);
  const int grazes = failing(rows, "grazes");
  return {{"control", control},
          {"tight", control == "tight"},
          {"failing", {{"of", methods.size()}, {"grazes", grazes}}},
          {"methods", std::move(rows)},
          {"rights", report::list_of(methods, rights_of)}};
}

}  // namespace

Json data_of(const FailureModeStudy& study) {
  const FailureModePlan& plan = study.plan;
  const Json loose = control_data(study, study.loose, "loose");
  const Json tight = control_data(study, study.tight, "tight");
  const Json& methods = tight["methods"];
  Json flawless = Json::array();
  int most = -1;
  std::string worst;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::string& name = study.tight[m].method;
    const int failed = failures(methods[m]);
    if (failed + failures(loose["methods"][m]) == 0) flawless.push_back(name);
    if (failed > most) worst = name;
    most = std::max(most, failed);
  }
  return {{"losses", study.losses},
          {"touches", touches_of(study.overshoots)},
          {"end_of_impacts", study.tight.front().zeno.end_of_impacts},
          {"least_excess", std::pow(10.0, -plan.decades)},
          {"impacts", plan.impacts},
          {"starts", plan.starts},
          {"seconds", plan.seconds},
          {"uncertainty", study.tight.front().rate.uncertainty},
          {"modes", 4 + study.losses.size()},
          {"flawless", std::move(flawless)},
          {"worst", {{"method", worst}, {"failed", most}}},
          {"failing",
           {{"of", methods.size()},
            {"grazes", failing(methods, "grazes")},
            {"sticking", failing(methods, "sticking")},
            {"zeno", failing(methods, "zeno")},
            {"rate", failing(methods, "rate")}}},
          {"controls", Json::array({loose, tight})}};
}

}  // namespace ricochet::studies::dynamics
