#include "src/studies/trials/all_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/core/random.h"
#include "src/studies/trials/find_peaks.h"
#include "src/studies/trials/height_count.h"
#include "src/studies/trials/sampled_path.h"
#include "src/studies/trials/speed_restitution.h"
#include "src/studies/trials/stepped_walls.h"
#include "src/studies/trials/what_if_motion.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

namespace {

/// The limits of equation (33) [m], and the lower one of the sentence below it.
constexpr double high_limit = 3e-3, low_limit = 1e-3, lower_limit = 1e-4;

/// A body that rebounds slower [m/s] may rest in a path that is sampled: its hops are far below
/// what a plot shows.
constexpr double sampled_resting = 1e-5;

/// So many random numbers; the longest window at the shortest interval has less.
constexpr Eigen::Index draws = 131072;

struct ImpactsHeard : WhatIfObserver {
  static constexpr bool hears_impacts_alone = true;

  double slowest;
  int most;
  int count = 0;

  ImpactsHeard(double the_slowest, int the_most) : slowest(the_slowest), most(the_most) {}
  void impact(double /*time*/, Wall /*wall*/, double speed) {
    if (is_counted(speed, slowest) && ++count > most) throw Enough();
  }
};

double resting_of(const Scene& scene, const Patience& patience) {
  return patience.resting_share > 0 ? patience.resting_share * scene.slowest
                                    : resting_speed_of(scene);
}

/// What a simulation that is given up counts for.
int louder(const Patience& patience) {
  return std::min(patience.most, MostImpacts::most) + 1;
}

int impacts_of(const Scene& scene, const WhatIf& what_if, const Patience& patience) {
  ImpactsHeard heard(scene.slowest, patience.most);
  try {
    WhatIfMotion(scene, what_if, resting_of(scene, patience)).run(heard);
  } catch (const Enough&) {
    // Louder than anything in the paper.
  } catch (const std::runtime_error&) {  // more impacts than any window holds
    return louder(patience);
  }
  return heard.count;
}

/// The readings that are changed: that with friction on the walls' own force, and that without.
Reading with_contact_friction() {
  return find_reading("projected-constant-revolutions-contact-friction");
}

Reading plain() {
  return find_reading("projected-constant-revolutions");
}

std::vector<Open> without(std::vector<Open> open, Open constant) {
  std::erase(open, constant);
  return open;
}

/// A trial whose impacts count as ever, of a motion that `change` makes of a case's scene.
template <class Change>
Trial changed_motion(const std::string& name, const std::string& description, const Reading& base,
                     std::vector<Open> freed, std::vector<OpenConstant> own, Change change) {
  Trial trial{name + (base == plain() ? "-plain" : ""), description, base, std::move(freed),
              std::move(own)};
  trial.counts = [base, change](const Case& a_case, const TrialConstants& constants,
                                const Patience& patience) -> CountAt {
    Scene scene = scene_of(a_case, base, constants.base);
    WhatIf what_if = change(scene, constants.own);
    return [scene, what_if, patience](double omega) {
      return impacts_of(at_speed(scene, omega), what_if, patience);
    };
  };
  return trial;
}

Trial nothing_changed(const Reading& base) {
  return changed_motion("nothing", "Nothing is changed: what the others are measured by.", base,
                        open_of(base), {},
                        [](const Scene&, const std::vector<double>&) { return WhatIf{}; });
}

OpenConstant inner_wall() {
  return {"inner_wall",
          "m",
          -4e-3,
          4e-3,
          false,
          0.0,
          "where x counts from is not given; both limits of (33) lie within"};
}

Trial heights(const std::string& name, double low) {
  Trial trial;
  trial.name = name;
  trial.description = fmt::format(
      "Hits on the outer wall and maxima count from 3 mm on, hits on the inner wall and minima up "
      "to {:g} mm, with the inner wall somewhere.",
      1e3 * low);
  trial.base = with_contact_friction();
  trial.freed = open_of(trial.base);
  trial.own = {inner_wall()};
  trial.counts = [base = trial.base, low](const Case& a_case, const TrialConstants& constants,
                                          const Patience& patience) -> CountAt {
    return [scene = scene_of(a_case, base, constants.base), wall = constants.own.at(0), low,
            patience](double omega) {
      const Scene at = at_speed(scene, omega);
      HeightCount heard(at, {wall, high_limit, low}, patience.most);
      const WhatIf nothing;
      try {
        WhatIfMotion(at, nothing, resting_of(at, patience)).run(heard);
      } catch (const Enough&) {
        return louder(patience);
      }
      return heard.count();
    };
  };
  return trial;
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
Trial sampled(const std::string& name, const std::string& what_counts, bool limited) {
  Trial trial;
  trial.name = name;
  trial.description =
      "The path is recorded at fixed steps, and findpeaks finds its maxima, some way apart: " +
      what_counts;
  trial.base = with_contact_friction();
  trial.freed = without(open_of(trial.base), Open::slowest);
  trial.own = {
      {"sample_step", "s", 1e-3, 0.3, true, 0.01,
       "from what a plot resolves to what misses most of it"},
      {"peak_distance", "s", 1e-3, 3, true, 1e-3, "from none, the usual, to the longest flights"}};
  if (limited) trial.own.push_back(inner_wall());
  trial.counts = [base = trial.base, limited](const Case& a_case, const TrialConstants& constants,
                                              const Patience& patience) -> CountAt {
    return [scene = scene_of(a_case, base, constants.base), own = constants.own, limited,
            patience](double omega) {
      const Scene at = at_speed(scene, omega);
      SampledPath path(own.at(0));
      const WhatIf nothing;
      try {
        WhatIfMotion(at, nothing, sampled_resting).run(path);
      } catch (const Enough&) {
        return louder(patience);
      }
      const HeightCount::Limits limits{limited ? own.at(2) : 0.0, high_limit, low_limit};
      const int count = peaks_of(path.samples(), own[1] / own[0], limited ? &limits : nullptr);
      return std::min(count, louder(patience));
    };
  };
  return trial;
}

Trial press_of_y(const Reading& base) {
  return changed_motion(
      "press-of-y",
      "Friction multiplies a share of the force along y, equation (22), in place of a constant.",
      base, without(open_of(base), Open::normal_force),
      {{"press_share", "", 0.01, 100, true, 1.0, "all of it is natural"},
       {"pull_across", "N", 0.01, 40, true, 0.01, "T_1 sin phi, as T_1 cos phi"}},
      [](const Scene&, const std::vector<double>& own) {
        WhatIf what_if;
        what_if.press = Press{own.at(0), own.at(1)};
        return what_if;
      });
}

Trial restitution_by_speed(const Reading& base) {
  return changed_motion(
      "restitution-by-speed",
      "Restitution falls with the fifth root of the approach speed, and is the paper's at one.",
      base, open_of(base),
      {{"reference_speed", "m/s", 1e-3, 10, true, 0.1, "as fast as impacts are, and beyond"}},
      [](const Scene&, const std::vector<double>& own) {
        WhatIf what_if;
        what_if.restitution = [reference = own.at(0)](double speed, double restitution) {
          return speed_restitution(restitution, speed, reference);
        };
        return what_if;
      });
}

Scene compliant_scene(const Case& a_case, const TrialConstants& constants) {
  Scene scene = scene_of(a_case, default_reading().reading, constants.base);
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = constants.own.at(0);
  return scene;
}

}  // namespace

Trial random_disturbance(const Reading& base, std::uint64_t draw) {
  Random random(draw);
  const auto numbers = std::make_shared<const Vector>(normal(draws, random));
  return changed_motion(
      "random-disturbance",
      "The disturbance is a normal random number with the paper's amplitude as its deviation, "
      "drawn "
      "once and held for some time, instead of a cosine.",
      base, open_of(base),
      {{"hold", "s", 0.02, 10, true, 0.1, "the interval of a random-number block is 0.1 s"}},
      [numbers](Scene& scene, const std::vector<double>& own) {
        WhatIf what_if;
        if (scene.disturbance == 0) return what_if;
        what_if.further_force =
            HeldForce{own.at(0), [numbers, deviation = scene.disturbance](std::size_t k) {
                        return deviation * (*numbers)[static_cast<Eigen::Index>(k) % draws];
                      }};
        scene.disturbance = 0;
        return what_if;
      });
}

Trial stepped_walls(const std::string& name, const OdeTolerances& tolerances) {
  Trial trial;
  trial.name = name;
  trial.description = fmt::format(
      "Hunt-Crossley walls, integrated straight through by the Dormand-Prince pair as ode45 does, "
      "at "
      "relative {:g} and absolute {:g}.",
      tolerances.relative, tolerances.absolute);
  trial.base = default_reading().reading;
  trial.freed = default_reading().freed;
  trial.own = {{"stiffness", "N/m^1.5", 1e7, 1e12, true, 1e10,
                "pressed in by the weight from 0.1 mm to 0.05 micrometres"}};
  trial.brief = true;
  trial.counts = [tolerances](const Case& a_case, const TrialConstants& constants,
                              const Patience& patience) -> CountAt {
    return [scene = compliant_scene(a_case, constants), tolerances, most = louder(patience) - 1](
               double omega) { return stepped_count(at_speed(scene, omega), tolerances, most); };
  };
  return trial;
}

CountAt exact_walls(const Case& a_case, const TrialConstants& constants) {
  return
      [scene = compliant_scene(a_case, constants)](double omega) { return count_at(scene, omega); };
}

std::vector<Trial> baselines() {
  const Reading own = with_contact_friction();
  Trial brief = nothing_changed(default_reading().reading);
  brief.name += "-brief";
  brief.freed = default_reading().freed;
  brief.brief = true;
  return {nothing_changed(own), nothing_changed(plain()), std::move(brief)};
}

std::vector<Trial> all_trials() {
  const Reading own = with_contact_friction();
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

}  // namespace ricochet::studies::trials
