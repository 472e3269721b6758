#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/cases.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/core/progress.h"
#include "src/core/time_limit.h"
#include "src/studies/simulators/suite.h"

/// What model does a scene need? Counts and costs of hard and compliant walls, in one direction and
/// in two, in the paper's cases.
namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

constexpr double fastest = 18;  // [rad/s]

/// A model of a case's machine. With `lateral`, the yarn also pulls across the track, by that times
/// its pull along it. That direction, which is not in the paper's objective, has the clearance of
/// the first, with the carrier in its middle. It has no contact_friction; this is in the
/// restitution instead, on both sides of the comparison.
struct Model {
  std::string name;
  Fidelity fidelity;
  std::optional<double> stiffness = {};  ///< [N/m^1.5] of compliant walls, law exact-restitution
  std::optional<double> lateral = {};
};

std::vector<Model> all_models() {
  std::vector<Model> models = {{"auto: the cheapest that is certain", Fidelity::automatic}};
  for (const int power : {10, 12, 14, 16, 18})
    models.push_back({"compliant walls, by stiffness", Fidelity::compliant, std::pow(10.0, power)});
  for (const double lateral : {0.0, 0.25, 0.5, 0.75, 1.0, 1.5})
    models.push_back({"both directions", Fidelity::planar, {}, lateral});
  return models;
}

/// The case's machine by hard walls, and by the model.
std::pair<Scene, Scene> scenes_of(const Case& the_case, const Model& model) {
  Scene hard = scene_of(the_case, default_machine());
  hard.fidelity = Fidelity::impact;
  hard.contact_law = ContactLaw::exact_restitution;
  if (model.lateral) {
    hard.restitution_lower = lower_restitution(hard);
    hard.restitution_upper = upper_restitution(hard);
    hard.contact_friction = false;
  }
  Scene other = hard;
  other.fidelity = model.fidelity;
  if (model.stiffness) other.stiffness = *model.stiffness;
  if (model.lateral) {
    other.across = Across<double>{*model.lateral * other.pull,
                                  other.wall_lower,
                                  other.wall_upper,
                                  other.restitution_lower,
                                  other.restitution_upper,
                                  0.5 * (other.wall_lower + other.wall_upper),
                                  0.0};
  }
  return {hard, other};
}

/// Counts and processor times of a model and of hard walls, over all cases and speeds.
struct Comparison {
  int compared = 0;  ///< speeds at which both simulations finished
  int equal = 0;
  int distance = 0;                                             ///< sum of the differences
  double least_cost = std::numeric_limits<double>::infinity();  ///< time over that of hard walls
  double most_cost = 0;                                         ///< of a case

  std::optional<double> share() const {
    return compared > 0 ? std::optional(1.0 * equal / compared) : std::nullopt;
  }
  std::string agreement() const {
    return fmt::format("{} of {} counts ({:.0f} %)", equal, compared, 100 * share().value_or(0));
  }
};

Comparison compared(const Model& model, const std::vector<double>& speeds) {
  Comparison all;
  for (const Case& the_case : all_cases()) {
    const auto [hard, other] = scenes_of(the_case, model);
    double hard_seconds = 0, seconds = 0;
    for (const double omega : speeds) {
      try {
        const double start = processor_seconds();
        const int right = count_at(hard, omega);
        const double between = processor_seconds();
        const int count = count_at(other, omega);
        seconds += processor_seconds() - between;
        hard_seconds += between - start;
        ++all.compared;
        all.equal += count == right ? 1 : 0;
        all.distance += std::abs(count - right);
      } catch (const std::runtime_error&) {  // too many impacts or steps
      }
    }
    if (hard_seconds == 0) continue;
    all.least_cost = std::min(all.least_cost, seconds / hard_seconds);
    all.most_cost = std::max(all.most_cost, seconds / hard_seconds);
  }
  return all;
}

/// Number of counts by hard walls that are certain, over all cases.
int certain_counts(const std::vector<double>& speeds) {
  std::atomic<int> certain = 0;
  for (const Case& the_case : all_cases()) {
    const Scene scene = scene_of(the_case, default_machine());
    tbb::parallel_for(std::size_t{0}, speeds.size(), [&](std::size_t k) {
      certain += record(at_speed(scene, speeds[k]), default_smoothing, 0).certainty.certain;
    });
  }
  return certain;
}

}  // namespace

void add_models(report::Results& results, double step) {
  std::vector<double> speeds;
  for (int k = 1; k * step < fastest + step / 2; ++k) speeds.push_back(k * step);
  const int counts = static_cast<int>(all_cases().size() * speeds.size());
  const auto table = [](const char* name, Column of) {
    return Table{name,
                 {std::move(of),
                  {"compared", "counts compared"},
                  {"equal", "equal to hard walls'"},
                  {"share", "equal [%]", ".0%"},
                  {"distance", "apart on average", ".2f"},
                  {"unfinished", "not finished"},
                  {"least_cost", "time over hard walls', least", ".1f"},
                  {"most_cost", "most", ".1f"}}};
  };
  Table walls = table("walls", {"stiffness", "stiffness [N/m^1.5]"});
  Table directions = table("directions", {"lateral", "lateral pull over pull along"});
  report::Chart chart{.name = "models",
                      .x = {"processor time over that of hard walls", report::Scale::logarithmic},
                      .y = {"counts that differ from those of hard walls [%]"},
                      .series = {{"hard walls", report::Mark::points, {{1, 0}}}},
                      .width = 640,
                      .height = 360};
  std::vector<std::string> agreements;  // of compliant walls
  double most_wrong = 0;                // share, of both directions
  const std::vector<Model> models = all_models();
  Progress progress("models", static_cast<double>(models.size()));
  for (const Model& model : models) {
    const Comparison all = compared(model, speeds);
    progress.advance(1);
    const double wrong = 1 - all.share().value_or(0);
    const std::string stiffness =
        model.stiffness ? fmt::format("1e{:.0f}", std::log10(*model.stiffness)) : "";
    if (all.compared > 0) {
      if (chart.series.back().label != model.name)
        chart.series.push_back({model.name, report::Mark::points, {}});
      chart.series.back().samples.push_back(
          {std::sqrt(all.least_cost * all.most_cost), 100 * wrong, {}, stiffness});
    }
    if (model.fidelity == Fidelity::automatic) continue;
    (model.lateral ? directions : walls)
        .add(model.lateral ? value_of(model.lateral) : value_of(stiffness), all.compared, all.equal,
             all.share(), 1.0 * all.distance / std::max(all.compared, 1), counts - all.compared,
             all.least_cost, all.most_cost);
    if (model.lateral) {
      most_wrong = std::max(most_wrong, wrong);
    } else {
      agreements.push_back(stiffness + " N/m^1.5");
      agreements.push_back(all.agreement());
    }
  }
  const double softest = 100 * (1 - walls[0].number_if("share").value_or(0));
  chart.title = fmt::format(
      "Both directions differ from hard walls in {:.0f} % of the counts, the softest walls in "
      "{:.0f} %",
      100 * most_wrong, softest);
  results.set("certain", fmt::format("Hard walls give a certain count at {} of {} speeds of the "
                                     "paper's cases.",
                                     certain_counts(speeds), counts));
  results.set("walls",
              fmt::format("Compliant walls of {} agree with hard ones in {}, those of {} in "
                          "{}.",
                          agreements[0], agreements[1], agreements[agreements.size() - 2],
                          agreements.back()));
  results.set(
      "planar",
      fmt::format("The second direction, across the track, changes {} of the counts in the "
                  "paper's cases, up to a lateral yarn pull of {:.2g} times that along the "
                  "track. Both sides of this comparison have the same friction.",
                  most_wrong == 0 ? "none" : fmt::format("at most {:.2g} %", 100 * most_wrong),
                  *models.back().lateral));
  results.set("speed-step", step);
  results.add(std::move(walls));
  results.add(std::move(directions));
  results.add(std::move(chart));
}

}  // namespace ricochet::studies::simulators
