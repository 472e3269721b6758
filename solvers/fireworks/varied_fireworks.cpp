#include "solvers/fireworks/varied_fireworks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "solvers/fireworks/bare_bones_fireworks.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/fireworks/loser_out_fireworks.h"
#include "src/core/error.h"
#include "src/core/near_names.h"

namespace ricochet::fireworks {
namespace {

using Given = std::map<std::string, double>;

/// A number that can be given, and where it goes.
struct Knob {
  double least, most;
  bool whole;
  std::function<void(double)> set;
};

using Knobs = std::map<std::string, Knob>;

Knob number(int& target, int least) {
  return {static_cast<double>(least), 1e6, true,
          [&target](double x) { target = static_cast<int>(x); }};
}

Knob real(double& target, double least, double most) {
  return {least, most, false, [&target](double x) { target = x; }};
}

Knob sparks_of(SparkCountOptions& counts) {
  return {1, 1e6, true, [&counts](double x) { counts.sparks = x; }};
}

void add_steps(Knobs& knobs, AmplitudeSteps& steps) {
  knobs["growth"] = real(steps.growth, 1, 1e3);
  knobs["decline"] = real(steps.decline, 1e-3, 1);
}

/// Throws InputError for one that is none, or out of its range.
void set(const Knobs& knobs, const Given& given, const std::string& of) {
  std::vector<std::string> names;
  for (const auto& [name, knob] : knobs) names.push_back(name);
  for (const auto& [name, value] : given) {
    const auto found = knobs.find(name);
    if (found == knobs.end()) {
      throw InputError(
          fmt::format("{}: {} has no such option; {}", name, of, what_instead(name, names)));
    }
    const Knob& knob = found->second;
    const bool fits =
        value >= knob.least && value <= knob.most && (!knob.whole || value == std::floor(value));
    if (!fits) {
      throw InputError(fmt::format("{} = {}: must be a {}number from {} to {}", name, value,
                                   knob.whole ? "whole " : "", knob.least, knob.most));
    }
    knob.set(value);
  }
}

FireworksOptions own_options(const std::string& of) {
  if (of == "fireworks-authors") return authors_options();
  if (of == "fireworks-corrected") return corrected_options();
  if (of == "efwa") return enhanced_options();
  return paper_options();
}

Solver made(const std::string& of, const std::string& name, const Given& given) {
  Knobs knobs;
  if (of == "bbfwa") {
    BareBonesFireworksOptions options;
    knobs["sparks"] = number(options.sparks, 1);
    add_steps(knobs, options.steps);
    set(knobs, given, of);
    return bare_bones_fireworks(name, options);
  }
  if (of == "dynfwa") {
    DynamicFireworksOptions options;
    knobs = {{"fireworks", number(options.fireworks, 1)},
             {"sparks", sparks_of(options.counts)},
             {"amplitude", real(options.amplitude, 0, 1e9)}};
    add_steps(knobs, options.steps);
    set(knobs, given, of);
    return dynamic_fireworks(name, options);
  }
  if (of == "lotfwa") {
    LoserOutFireworksOptions options;
    knobs = {{"fireworks", number(options.fireworks, 1)},
             {"sparks", number(options.sparks, 1)},
             {"guiding_share", real(options.guiding_share, 1e-3, 1)}};
    add_steps(knobs, options.steps);
    set(knobs, given, of);
    return loser_out_fireworks(name, options);
  }
  FireworksOptions options = own_options(of);
  knobs = {{"fireworks", number(options.fireworks, 1)},
           {"sparks", sparks_of(options.counts)},
           {"gaussian_sparks", number(options.gaussian_sparks, 0)},
           {"amplitude", real(options.amplitude, 0, 1e9)}};
  set(knobs, given, of);
  return fireworks(name, options);
}

}  // namespace

Solver varied(const std::string& of, const std::string& name, const Given& options) {
  static const std::vector<std::string> members = {
      "fireworks", "fireworks-authors", "fireworks-corrected", "efwa", "dynfwa", "bbfwa", "lotfwa"};
  if (std::find(members.begin(), members.end(), of) == members.end()) {
    throw InputError(
        fmt::format("{}: no such solver has options; {}", of, what_instead(of, members)));
  }
  try {
    Solver solver = made(of, name, options);
    solver.version += ", " + of;
    for (const auto& [option, value] : options) {
      solver.version += fmt::format(" {} {}", option, value);
    }
    return solver;
  } catch (const std::invalid_argument& error) {  // numbers that do not fit together
    throw InputError(error.what());
  }
}

}  // namespace ricochet::fireworks
