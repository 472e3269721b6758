#include "src/studies/paper/loss.h"

#include <ceres/jet.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/speed_problems.h"

namespace ricochet::carrier_track::inline paper {

namespace {

/// Share of the counting limit: a body that rebounds slower may rest.
constexpr double resting_share = 0.01;

void add_cells(std::vector<SpeedCell>& cells, double from, double to, double width) {
  const auto size = std::max(1L, std::lround((to - from) / width));
  const double exact = (to - from) / static_cast<double>(size);
  for (long k = 0; k < size; ++k) {
    cells.push_back({from + (static_cast<double>(k) + 0.5) * exact, exact});
  }
}

/// The distance over its tolerance; logarithmic beyond 3.
double tamed(double distance) {
  return distance < 3 ? distance : 3 + std::log(distance - 2);
}

double below_claim(double count, int quiet) {
  return std::log((count + 0.5) / (quiet + 0.5));
}

double above_claim(double count, int quiet) {
  return std::max(0.0, std::log(1.6 * quiet / (count + 0.5)));
}

struct Cell {
  double omega, width;
  int count;
};

double total_width(const std::vector<Cell>& cells) {
  double sum = 0;
  for (const Cell& c : cells) sum += c.width;
  return sum;
}

/// The count at the most speeds.
int widest_count(const std::vector<Cell>& cells) {
  std::map<int, double> widths;
  for (const Cell& c : cells) widths[c.count] += c.width;
  return std::max_element(widths.begin(), widths.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

double median_count(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end(),
            [](const Cell& a, const Cell& b) { return a.count < b.count; });
  const double half = total_width(cells) / 2;
  double passed = 0;
  for (const Cell& c : cells) {
    passed += c.width;
    if (passed >= half) return c.count;
  }
  return 0;
}

struct CoarseSplit {
  double speed, misclassified;
};

CoarseSplit coarse_split(const std::vector<Cell>& cells, double limit) {
  double wrong = 0;  // if everything were called loud
  for (const Cell& c : cells) wrong += c.count <= limit ? c.width : 0;
  CoarseSplit best{0, wrong};
  double edge = 0;
  for (const Cell& c : cells) {
    edge += c.width;
    wrong += c.count > limit ? c.width : -c.width;
    if (wrong < best.misclassified - 1e-9) best = {edge, wrong};
  }
  best.misclassified /= edge;
  best.speed =
      std::clamp(best.speed, cells.front().width / 2, fastest_speed - cells.back().width / 2);
  return best;
}

std::vector<double> speeds_of(const std::vector<SpeedCell>& cells) {
  std::vector<double> speeds;
  for (const SpeedCell& cell : cells) speeds.push_back(cell.omega);
  return speeds;
}

std::vector<Scene> scenes_of(const Parameterisation& fit, const Case& a_case,
                             const std::vector<double>& speeds) {
  const Scene scene = scene_of(a_case, fit.interpretation, fit.constants);
  std::vector<Scene> scenes;
  for (const double omega : speeds)
    scenes.push_back(scene_at(scene, fit.interpretation, fit.constants, omega));
  return scenes;
}

struct ClaimedCell {
  Case the_case;
  SpeedCell cell;
};

bool is_in(const CaseIds& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

struct Slopes {
  double count;   ///< of the surrogate
  Vector slopes;  ///< one for each free parameter
};

/// What counts of a scene's window.
struct CountedTurns {
  double first;  ///< the turn at which the count begins
  double scale;  ///< what a collision counts
};

CountedTurns counted_turns(const Parameterisation& fit, double omega) {
  const auto the = [&](Unknown open) { return fit.constants[static_cast<std::size_t>(open)]; };
  switch (fit.interpretation.counted) {
    case Counted::from_start:
      return {0, 1};
    case Counted::later:
      return {the(Unknown::first_turn), 1};
    case Counted::long_run:
      break;
  }
  const double turns = fit.interpretation.window == WindowUnit::revolutions
                           ? the(Unknown::revolutions)
                           : the(Unknown::seconds) * omega / (2 * std::numbers::pi);
  return {settled_turn, turns / (last_turn - settled_turn)};
}

/// A scene whose window ends there.
template <class Scalar>
BasicScene<Scalar> until(double turn, BasicScene<Scalar> scene) {
  scene.window = Revolutions{turn};
  return scene;
}

/// The count, or its surrogate, of a scene at a speed.
template <class Scalar>
Scalar counted_objective(const BasicScene<Scalar>& at, const CountedTurns& turns,
                         double smoothing) {
  Scalar sum = objective(at, smoothing);
  if (turns.first > 0) sum -= objective(until(turns.first, at), smoothing);
  return turns.scale == 1 ? sum : constant<Scalar>(turns.scale) * sum;
}

/// A surrogate count and its derivatives, in groups of parameters: the cost of a dual number grows
/// with its size.
Slopes slopes_of_count(const Parameterisation& fit, double smoothing, const ClaimedCell& where) {
  constexpr std::size_t room = 5;
  using Jet = ceres::Jet<double, static_cast<int>(room)>;
  const std::vector<Unknown>& free = fit.free;
  Slopes slopes{0, Vector::Zero(static_cast<Eigen::Index>(free.size()))};
  for (std::size_t first = 0; first < free.size(); first += room) {
    const std::size_t last = std::min(first + room, free.size());
    BasicConstants<Jet> dual;
    for (std::size_t i = 0; i < unknown_size; ++i) dual[i] = Jet(fit.constants[i]);
    for (std::size_t i = first; i < last; ++i) {
      dual[static_cast<std::size_t>(free[i])].v[static_cast<Eigen::Index>(i - first)] = 1;
    }
    const BasicScene<Jet> scene = scene_of(where.the_case, fit.interpretation, dual);
    const Jet count = counted_objective(at_speed(scene, Jet(where.cell.omega)),
                                        counted_turns(fit, where.cell.omega), smoothing);
    slopes.count = count.a;
    for (std::size_t i = first; i < last; ++i) {
      slopes.slopes[static_cast<Eigen::Index>(i)] = count.v[static_cast<Eigen::Index>(i - first)];
    }
  }
  return slopes;
}

}  // namespace

std::vector<SpeedCell> speed_cells(double threshold) {
  std::vector<SpeedCell> cells;
  add_cells(cells, 0, 1.3 * threshold, threshold / 16);
  add_cells(cells, 1.3 * threshold, fastest_speed, 0.6);
  return cells;
}

namespace {

/// Counts from a time on.
struct LaterCount : ImpactCount {
  double from = 0;  ///< [s]

  void impact(double time, Wall wall, double speed) {
    if (time >= from) ImpactCount::impact(time, wall, speed);
  }
};

}  // namespace

std::vector<int> counts_of(const Parameterisation& fit, const Case& a_case,
                           const std::vector<double>& speeds) {
  // With most parameters that a search tries first the carrier has thousands of impacts, which need
  // not all be simulated.
  const std::vector<Scene> scenes = scenes_of(fit, a_case, speeds);
  std::vector<int> counts;
  const auto scaled = [](int count, const CountedTurns& turns) {
    return std::min(most_counted + 1, static_cast<int>(std::lround(turns.scale * count)));
  };
  const auto most = [](const CountedTurns& turns) {
    return static_cast<int>(std::lround(most_counted / turns.scale));
  };
  if (std::all_of(scenes.begin(), scenes.end(), suits_lanes)) {
    std::vector<LaterCount> observers(scenes.size());
    const auto outcomes = run_in_lanes(
        scenes.size(),
        [&](std::size_t k) {
          observers[k].counting_limit = scenes[k].counting_limit;
          const CountedTurns turns = counted_turns(fit, speeds[k]);
          observers[k].most = most(turns);
          if (turns.first > 0) observers[k].from = duration_of(until(turns.first, scenes[k]));
          return ImpactModel<double>(scenes[k], resting_share * scenes[k].counting_limit);
        },
        [&](std::size_t k) -> LaterCount& { return observers[k]; });
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      try {
        if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
      } catch (const ImpactCount::Enough&) {
        // Louder than anything in the paper.
      }
      counts.push_back(scaled(observers[k].count, counted_turns(fit, speeds[k])));
    }
    return counts;
  }
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    struct Enough {};
    const Scene& at = scenes[k];
    const CountedTurns turns = counted_turns(fit, speeds[k]);
    const double first =
        turns.first > 0 ? duration_of(until(turns.first, at)) / duration_of(at) : 0;
    int count = 0;
    auto add = [&](double margin, double left) {
      if (1 - left >= first && step(margin, 0.0) > 0 && ++count > most(turns)) throw Enough();
    };
    Features<double, decltype(add)> features(at, add);
    try {
      simulate_at_needed_fidelity(at, features);
    } catch (const Enough&) {
      // The same.
    }
    counts.push_back(scaled(count, turns));
  }
  return counts;
}

std::vector<int> exact_counts(const Parameterisation& fit, const Case& a_case,
                              const std::vector<double>& speeds) {
  std::vector<int> counts;
  const std::vector<Scene> scenes = scenes_of(fit, a_case, speeds);
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const double count = counted_objective(scenes[k], counted_turns(fit, speeds[k]), 0.0);
    counts.push_back(static_cast<int>(std::lround(count)));
  }
  return counts;
}

double loss_of(const CoarseScore& s, const Claim& claim) {
  const double quiet = *claim.quiet_count;
  return tamed(std::abs(std::log((s.quiet_count + 0.3) / (quiet + 0.3))) / 0.15) +
         tamed(std::max(0.0, 0.9 - s.purity) / 0.15) +
         tamed(std::abs(std::log(s.threshold / *claim.threshold)) / 0.05) +
         tamed(std::max(0.0, s.misclassified - 0.02) / 0.05) +
         tamed(std::max(0.0, std::log(1.5 / std::max(s.loudness, 0.3))) / 0.2) +
         2.0 * s.wrong_examples + 3 * s.shape;
}

double quiet_share_of_c11(const Parameterisation& fit, int quiet) {
  const std::vector<SpeedCell> cells = speed_cells(fastest_speed / 1.3 / 2);
  const std::vector<int> counts = counts_of(fit, find_case("C11"), speeds_of(cells));
  double share = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (counts[k] <= quiet_limit(quiet)) share += cells[k].width / fastest_speed;
  }
  return share;
}

CoarseScore coarse_score(const Parameterisation& fit, const Case& a_case) {
  const double threshold = a_case.claim.threshold.value();
  const int claimed = a_case.claim.quiet_count.value();
  std::vector<Cell> cells, below, above;
  double below_shape = 0;
  double above_shape = 0;
  const std::vector<SpeedCell> speed_cell = speed_cells(threshold);
  std::vector<double> speeds = speeds_of(speed_cell);
  const auto& figure = a_case.claim.figure;
  if (figure) speeds.insert(speeds.end(), {figure->quiet, figure->loud});
  const std::vector<int> counts = counts_of(fit, a_case, speeds);
  for (std::size_t k = 0; k < speed_cell.size(); ++k) {
    const SpeedCell& c = speed_cell[k];
    const Cell cell{c.omega, c.width, counts[k]};
    cells.push_back(cell);
    if (c.omega < threshold) {
      below.push_back(cell);
      below_shape += c.width * std::min(1.5, std::abs(below_claim(cell.count, claimed)));
    } else {
      above.push_back(cell);
      above_shape += c.width * std::min(1.5, above_claim(cell.count, claimed));
    }
  }
  const int quiet = widest_count(below);
  const double limit = quiet_limit(quiet);
  const CoarseSplit split = coarse_split(cells, limit);
  double pure = 0;
  for (const Cell& c : below) pure += std::abs(c.count - quiet) <= 1 ? c.width : 0;
  int wrong = 0;
  if (figure) {
    wrong += counts[counts.size() - 2] > limit ? 1 : 0;
    wrong += counts.back() > limit ? 0 : 1;
  }
  return {quiet,
          pure / total_width(below),
          split.speed,
          split.misclassified,
          median_count(above) / std::max(quiet, 1),
          wrong,
          below_shape / total_width(below) + above_shape / total_width(above)};
}

double loss(const Parameterisation& fit, const CaseIds& left_out) {
  const bool has_c11 = !is_in(left_out, "C11");
  double sum = 0;
  int quiet_of_c4 = 1;
  for (const Case& a_case : all_cases()) {
    if (!a_case.claim.threshold) continue;
    const bool is_out = is_in(left_out, a_case.id);
    const bool judges_c11 = a_case.id == "C4" && has_c11;
    if (is_out && !judges_c11) continue;
    const CoarseScore s = coarse_score(fit, a_case);
    if (!is_out) sum += loss_of(s, a_case.claim);
    if (judges_c11) quiet_of_c4 = std::max(s.quiet_count, 1);
  }
  return has_c11 ? sum + 4 * quiet_share_of_c11(fit, quiet_of_c4) : sum;
}

SmoothLoss smooth_loss(const Parameterisation& fit, double smoothing, const CaseIds& left_out) {
  const bool differentiable = fit.interpretation.recovery != Recovery::contact_speed &&
                              fit.interpretation.transition == Transition::plain;
  std::vector<ClaimedCell> cells;
  std::vector<Scene> scenes;
  for (const Case& a_case : all_cases()) {
    if (!a_case.claim.threshold || is_in(left_out, a_case.id)) continue;
    const std::vector<SpeedCell> its_cells = speed_cells(*a_case.claim.threshold);
    for (const SpeedCell& cell : its_cells) cells.push_back({a_case, cell});
    std::ranges::move(scenes_of(fit, a_case, speeds_of(its_cells)), std::back_inserter(scenes));
  }
  std::vector<double> counts = objectives(scenes, smoothing);
  if (fit.interpretation.counted != Counted::from_start) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const CountedTurns turns = counted_turns(fit, cells[k].cell.omega);
      const double before =
          turns.first > 0 ? objective(until(turns.first, scenes[k]), smoothing) : 0;
      counts[k] = turns.scale * (counts[k] - before);
    }
  }
  const auto columns = static_cast<Eigen::Index>(fit.free.size());
  const auto rows = static_cast<Eigen::Index>(cells.size());
  SmoothLoss result{Vector(rows), Matrix::Zero(rows, columns)};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& [the_case, cell] = cells[k];
    const double threshold = *the_case.claim.threshold;
    const int quiet = *the_case.claim.quiet_count;
    const bool below = cell.omega < threshold;
    // Loud enough even if the dual number's value is rounded differently.
    const bool flat = !below && above_claim(counts[k] * (1 - 1e-9), quiet) == 0;
    const bool has_slopes = differentiable && columns > 0 && !flat;
    const Slopes at =
        has_slopes ? slopes_of_count(fit, smoothing, cells[k]) : Slopes{counts[k], {}};
    const double weight =
        std::sqrt(3 * cell.width / (below ? threshold : fastest_speed - threshold));
    const double distance = below ? below_claim(at.count, quiet) : -above_claim(at.count, quiet);
    const auto row = static_cast<Eigen::Index>(k);
    result.residuals[row] = weight * distance;
    if (!has_slopes || (!below && distance == 0)) continue;
    result.slopes.row(row) = weight / (at.count + 0.5) * at.slopes.transpose();
  }
  return result;
}

namespace {

const UnknownParameter& bounds_of(Unknown open) {
  return unknown_parameters()[static_cast<std::size_t>(open)];
}

/// d value / d share.
double stretch(const UnknownParameter& c, double share) {
  if (c.logarithmic) return value_at(c, share) * std::log(c.upper / c.lower);
  return c.upper - c.lower;
}

}  // namespace

Parameterisation forgotten(Parameterisation fit) {
  for (const Unknown open : fit.free) {
    const auto i = static_cast<std::size_t>(open);
    fit.constants[i] = natural_constants()[i];
  }
  return fit;
}

Parameterisation fit_at(Parameterisation fit, const Vector& x) {
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const Unknown open = fit.free[i];
    fit.constants[static_cast<std::size_t>(open)] =
        value_at(bounds_of(open), x[static_cast<Eigen::Index>(i)]);
  }
  return fit;
}

Vector point_of(const Parameterisation& fit) {
  Vector x(static_cast<Eigen::Index>(fit.free.size()));
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const Unknown open = fit.free[i];
    x[static_cast<Eigen::Index>(i)] =
        share_of(bounds_of(open), fit.constants[static_cast<std::size_t>(open)]);
  }
  return x;
}

Problem calibration_problem(const Parameterisation& start, const CaseIds& left_out) {
  const auto n = static_cast<Eigen::Index>(start.free.size());
  Problem problem;
  problem.name = fmt::format("calibration-{}", name_of(start.interpretation));
  for (const Unknown open : start.free) {
    problem.name += fmt::format("-{}", bounds_of(open).name);
    problem.variables.push_back({std::string(bounds_of(open).name), ""});
  }
  problem.source = "distance from the paper's claims, section 3.3, over the unknown parameters";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = point_of(start);
  problem.evaluate = [start, left_out](const Vector& x) {
    return Values{loss(fit_at(start, x), left_out), {}};
  };
  problem.residuals = [start, left_out](const Vector& x) {
    SmoothLoss smooth = smooth_loss(fit_at(start, x), default_smoothing, left_out);
    for (std::size_t i = 0; i < start.free.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      smooth.slopes.col(column) *= stretch(bounds_of(start.free[i]), x[column]);
    }
    return Residuals{std::move(smooth.residuals), std::move(smooth.slopes)};
  };
  return problem;
}

Problem calibration_problem(const FittedInterpretation& fitted) {
  Problem problem = calibration_problem(forgotten(fitted));
  problem.name = "calibration-default";
  if (fitted.name == default_interpretation().name) know_best(problem, default_machine_hash());
  if (!problem.best_known) {
    problem.best_point = point_of(fitted);
    problem.best_known = problem.evaluate(*problem.best_point).objective;
    problem.provenance = fitted.provenance;
  }
  problem.tolerance = 0.01;
  problem.gradient_cost = calibration_gradient_cost;
  return problem;
}

Family calibration_family() {
  return {"calibration", {calibration_problem(default_interpretation())}};
}

}  // namespace ricochet::carrier_track::inline paper
