#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

constexpr double rpm = 30 / std::numbers::pi;  // of 1 rad/s

/// The smallest and the largest of some speeds.
struct Span {
  double least, most;
  bool one;  ///< whether they are the same
};
RICOCHET_WRITTEN_AS_JSON(Span, least, most, one);

/// Cases that differ only in their disturbance.
struct Machine {
  std::string cases;
  double restitution, friction;
  std::optional<Span> silent, speed;  ///< [rad/s], in the long run
  std::optional<Span> published;      ///< [rad/s], the paper's thresholds
};
RICOCHET_WRITTEN_AS_JSON(Machine, cases, restitution, friction, silent, speed, published);

struct ExampleSpeed {
  std::string case_;
  double speed, rpm;
};
RICOCHET_WRITTEN_AS_JSON(ExampleSpeed, case_, speed, rpm);

struct Speeds {
  std::optional<double> least, most, least_rpm, most_rpm;
  std::vector<Machine> machines;
  std::optional<ExampleSpeed> example;
};
RICOCHET_WRITTEN_AS_JSON(Speeds, least, most, least_rpm, most_rpm, machines, example);

std::optional<Span> span_of(const std::vector<double>& speeds) {
  if (speeds.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(speeds);
  return Span{least, most, least == most};
}

}  // namespace

report::Json speed_data(const std::vector<CaseStudy>& cases) {
  struct SameMachine {
    std::string cases;
    std::vector<double> silent, quiet, published;
  };
  std::map<std::pair<double, double>, SameMachine> groups;
  std::vector<double> all;
  Speeds speeds;
  for (const CaseStudy& c : cases) {
    SameMachine& group = groups[{c.the_case.restitution, c.the_case.friction}];
    group.cases += (group.cases.empty() ? "" : ", ") + c.the_case.id;
    if (c.the_case.claim.threshold) group.published.push_back(*c.the_case.claim.threshold);
    if (c.borders.silent) group.silent.push_back(*c.borders.silent);
    if (!c.borders.quiet) continue;
    group.quiet.push_back(*c.borders.quiet);
    all.push_back(*c.borders.quiet);
    if (c.the_case.id == "C3") speeds.example = {"C3", all.back(), rpm * all.back()};
  }
  if (const auto span = span_of(all)) {
    speeds.least = span->least;
    speeds.most = span->most;
    speeds.least_rpm = rpm * span->least;
    speeds.most_rpm = rpm * span->most;
  }
  for (const auto& [constants, group] : groups) {
    speeds.machines.push_back({group.cases, constants.first, constants.second,
                               span_of(group.silent), span_of(group.quiet),
                               span_of(group.published)});
  }
  return speeds;
}

}  // namespace ricochet::studies::reproduction
