#include "src/research/calibration/variants/all_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/random.h"
#include "src/research/calibration/variants/changed_motion.h"
#include "src/research/calibration/variants/find_peaks.h"
#include "src/research/calibration/variants/height_count.h"
#include "src/research/calibration/variants/sampled_path.h"
#include "src/research/calibration/variants/speed_restitution.h"
#include "src/research/calibration/variants/stepped_walls.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::variants {

using namespace carrier_track;

namespace {

/// The limits of equation (33) [m], and the lower one in the sentence below it.
constexpr double high_limit = 3e-3, low_limit = 1e-3, lower_limit = 1e-4;

/// A body that rebounds more slowly [m/s] may rest in a sampled path: its chattering is far below
/// what a plot shows.
constexpr double sampled_resting = 1e-5;

/// Number of random numbers; the longest window at the shortest interval needs fewer.
constexpr Eigen::Index draws = 131072;

struct CountOfImpacts : ImpactCount {
  void valley(double /*time*/, double /*position*/) {}
};

double resting_of(const Scene& scene, const EarlyStopping& stopping) {
  return stopping.resting_share > 0 ? stopping.resting_share * scene.counting_limit
                                    : resting_speed_of(scene);
}

/// Count of a simulation that is given up.
int louder(const EarlyStopping& stopping) {
  return std::min(stopping.most, ImpactLimit::most) + 1;
}

int impacts_of(const Scene& scene, const MotionChange& change, const EarlyStopping& stopping) {
  CountOfImpacts heard;
  heard.counting_limit = scene.counting_limit;
  heard.most = stopping.most;
  try {
    ChangedMotion(scene, change, resting_of(scene, stopping)).run(heard);
  } catch (const StoppedEarly&) {
    // Louder than anything in the paper.
  } catch (const std::runtime_error&) {  // more impacts than any window holds
    return louder(stopping);
  }
  return heard.count;
}

/// The interpretations that are changed: with friction on the walls' normal force, and without.
Interpretation with_contact_friction() {
  return find_interpretation("projected-constant-revolutions-contact-friction");
}

Interpretation plain() {
  return find_interpretation("projected-constant-revolutions");
}

std::vector<Unknown> without(std::vector<Unknown> open, Unknown constant) {
  std::erase(open, constant);
  return open;
}

/// A variant with the usual count of impacts, with a motion that `changed` makes of a case's scene.
template <class Changed>
ModelVariant changed_motion(const std::string& name, const std::string& description,
                            const Interpretation& base, std::vector<Unknown> free,
                            std::vector<UnknownParameter> own, Changed changed) {
  ModelVariant variant{name + (base == plain() ? "-plain" : ""), description, base, std::move(free),
                       std::move(own)};
  variant.counts = [base, changed](const Case& a_case, const VariantConstants& constants,
                                   const EarlyStopping& stopping) -> CountAt {
    Scene scene = scene_of(a_case, base, constants.base);
    const MotionChange change = changed(scene, constants.own);
    return [scene, change, stopping](double omega) {
      return impacts_of(at_speed(scene, omega), change, stopping);
    };
  };
  return variant;
}

ModelVariant nothing_changed(const Interpretation& base) {
  return changed_motion("nothing", "Nothing is changed: what the others are measured by.", base,
                        unknowns_of(base), {},
                        [](const Scene&, const std::vector<double>&) { return MotionChange{}; });
}

UnknownParameter inner_wall() {
  return {"inner_wall",
          "m",
          -4e-3,
          4e-3,
          false,
          0.0,
          "where x counts from is not given; both limits of (33) lie within"};
}

ModelVariant heights(const std::string& name, double low) {
  ModelVariant variant;
  variant.name = name;
  variant.description = fmt::format(
      "Hits on the outer wall and maxima count from 3 mm on, hits on the inner wall and minima up "
      "to {:g} mm, with the inner wall somewhere.",
      1e3 * low);
  variant.base = with_contact_friction();
  variant.free = unknowns_of(variant.base);
  variant.own = {inner_wall()};
  variant.counts = [base = variant.base, low](const Case& a_case, const VariantConstants& constants,
                                              const EarlyStopping& stopping) -> CountAt {
    return [scene = scene_of(a_case, base, constants.base), wall = constants.own.at(0), low,
            stopping](double omega) {
      const Scene at = at_speed(scene, omega);
      HeightCount heard(at, {wall, high_limit, low}, stopping.most);
      const MotionChange nothing;
      try {
        ChangedMotion(at, nothing, resting_of(at, stopping)).run(heard);
      } catch (const StoppedEarly&) {
        return louder(stopping);
      }
      return heard.count();
    };
  };
  return variant;
}

int peaks_of(const std::vector<double>& samples, double distance,
             const HeightCount::Limits* limits) {
  int count = 0;
  for (const std::size_t k : find_peaks(samples, distance)) {
    const double height = limits == nullptr ? 0 : limits->inner_wall + samples[k];
    if (limits == nullptr || height >= limits->high || height <= limits->low) ++count;
  }
  return count;
}

/// `limited` by both limits of (33).
ModelVariant sampled(const std::string& name, const std::string& what_counts, bool limited) {
  ModelVariant variant;
  variant.name = name;
  variant.description =
      "The path is recorded at fixed steps, and findpeaks finds its maxima, some way apart: " +
      what_counts;
  variant.base = with_contact_friction();
  variant.free = without(unknowns_of(variant.base), Unknown::counting_limit);
  variant.own = {
      {"sample_step", "s", 1e-3, 0.3, true, 0.01,
       "from what a plot resolves to what misses most of it"},
      {"peak_distance", "s", 1e-3, 3, true, 1e-3, "from none, the usual, to the longest flights"}};
  if (limited) variant.own.push_back(inner_wall());
  variant.counts = [base = variant.base, limited](const Case& a_case,
                                                  const VariantConstants& constants,
                                                  const EarlyStopping& stopping) -> CountAt {
    return [scene = scene_of(a_case, base, constants.base), own = constants.own, limited,
            stopping](double omega) {
      const Scene at = at_speed(scene, omega);
      SampledPath path(own.at(0));
      const MotionChange nothing;
      try {
        ChangedMotion(at, nothing, sampled_resting).run(path);
      } catch (const StoppedEarly&) {
        return louder(stopping);
      }
      const HeightCount::Limits limits{limited ? own.at(2) : 0.0, high_limit, low_limit};
      const int count = peaks_of(path.samples(), own[1] / own[0], limited ? &limits : nullptr);
      return std::min(count, louder(stopping));
    };
  };
  return variant;
}

ModelVariant press_of_y(const Interpretation& base) {
  return changed_motion(
      "press-of-y",
      "Friction multiplies a share of the force along y, equation (22), in place of a constant.",
      base, without(unknowns_of(base), Unknown::normal_force),
      {{"press_share", "", 0.01, 100, true, 1.0, "all of it is natural"},
       {"pull_across", "N", 0.01, 40, true, 0.01, "T_1 sin phi, as T_1 cos phi"}},
      [](const Scene&, const std::vector<double>& own) {
        MotionChange change;
        change.press = Press{own.at(0), own.at(1)};
        return change;
      });
}

ModelVariant restitution_by_speed(const Interpretation& base) {
  return changed_motion(
      "restitution-by-speed",
      "Restitution falls with the fifth root of the approach speed, and is the paper's at one.",
      base, unknowns_of(base),
      {{"reference_speed", "m/s", 1e-3, 10, true, 0.1, "as fast as impacts are, and beyond"}},
      [](const Scene&, const std::vector<double>& own) {
        MotionChange change;
        change.restitution = [reference = own.at(0)](double speed, double restitution) {
          return speed_restitution(restitution, speed, reference);
        };
        return change;
      });
}

Scene compliant_scene(const Case& a_case, const VariantConstants& constants) {
  Scene scene = scene_of(a_case, default_interpretation().interpretation, constants.base);
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = constants.own.at(0);
  return scene;
}

}  // namespace

ModelVariant random_disturbance(const Interpretation& base, std::uint64_t draw) {
  Random random(draw);
  const auto numbers = std::make_shared<const Vector>(normal(draws, random));
  return changed_motion(
      "random-disturbance",
      "The disturbance is a normal random number with the paper's amplitude as its deviation, "
      "drawn once and held for some time, instead of a cosine.",
      base, unknowns_of(base),
      {{"hold", "s", 0.02, 10, true, 0.1, "the interval of a random-number block is 0.1 s"}},
      [numbers](Scene& scene, const std::vector<double>& own) {
        MotionChange change;
        if (scene.disturbance == 0) return change;
        change.further_force =
            HeldForce{own.at(0), [numbers, deviation = scene.disturbance](std::size_t k) {
                        return deviation * (*numbers)[static_cast<Eigen::Index>(k) % draws];
                      }};
        scene.disturbance = 0;
        return change;
      });
}

ModelVariant stepped_walls(const std::string& name, const OdeTolerances& tolerances) {
  ModelVariant variant;
  variant.name = name;
  variant.description = fmt::format(
      "Hunt-Crossley walls, integrated straight through by the Dormand-Prince pair as ode45 does, "
      "at relative {:g} and absolute {:g}.",
      tolerances.relative, tolerances.absolute);
  variant.base = default_interpretation().interpretation;
  variant.free = default_interpretation().free;
  variant.own = {{"stiffness", "N/m^1.5", 1e7, 1e12, true, 1e10,
                  "pressed in by the weight from 0.1 mm to 0.05 micrometres"}};
  variant.brief = true;
  variant.counts = [tolerances](const Case& a_case, const VariantConstants& constants,
                                const EarlyStopping& stopping) -> CountAt {
    return [scene = compliant_scene(a_case, constants), tolerances, most = louder(stopping) - 1](
               double omega) { return stepped_count(at_speed(scene, omega), tolerances, most); };
  };
  return variant;
}

CountAt exact_walls(const Case& a_case, const VariantConstants& constants) {
  return
      [scene = compliant_scene(a_case, constants)](double omega) { return count_at(scene, omega); };
}

std::vector<ModelVariant> baselines() {
  const Interpretation own = with_contact_friction();
  ModelVariant brief = nothing_changed(default_interpretation().interpretation);
  brief.name += "-brief";
  brief.free = default_interpretation().free;
  brief.brief = true;
  return {nothing_changed(own), nothing_changed(plain()), std::move(brief)};
}

std::vector<ModelVariant> all_variants() {
  const Interpretation own = with_contact_friction();
  return {heights("heights-1mm", low_limit),
          heights("heights-0.1mm", lower_limit),
          sampled("sampled-peaks", "those from 3 mm on and those up to 1 mm count.", true),
          sampled("sampled-peaks-all", "all count.", false),
          stepped_walls("ode45-default", {}),
          stepped_walls("ode45-tight", tight_tolerances),
          press_of_y(own),
          press_of_y(plain()),
          random_disturbance(own, 1),
          random_disturbance(plain(), 1),
          restitution_by_speed(own),
          restitution_by_speed(plain())};
}

}  // namespace ricochet::studies::variants
