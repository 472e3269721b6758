#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/paper/sustained_bouncing.h"
#include "src/studies/reproduction/sections.h"
#include "src/studies/reproduction/theory.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Alignment;
using report::Cell;
using report::Mark;

using Points = std::vector<ThresholdPoint>;
using SceneSpeed = std::optional<double> (*)(const Scene&);

/// The thresholds of one origin, and what the report calls them.
struct Thresholds {
  std::string name;
  Points points;
};

/// The paper's, and those computed for the same cases.
std::vector<Thresholds> thresholds_of(const std::vector<CaseStudy>& cases) {
  Thresholds paper{"paper", {}};
  Thresholds computed{"computed", {}};
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    if (!it.claim.threshold) continue;
    ThresholdPoint point{it.id, it.restitution, it.friction, it.disturbance, *it.claim.threshold};
    paper.points.push_back(point);
    if (!c.score.threshold) continue;
    point.threshold = *c.score.threshold;
    computed.points.push_back(point);
  }
  return {paper, computed};
}

const CaseStudy& study_of(const ThresholdPoint& point, const std::vector<CaseStudy>& cases) {
  return *std::find_if(cases.begin(), cases.end(),
                       [&](const CaseStudy& c) { return c.the_case.id == point.id; });
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// With one digit, and no minus sign before a zero.
std::string fine_percent(double share) {
  return fmt::format("{:.1f} %", std::round(1000 * share) / 10 + 0.0);
}

/// A mean error of ln w as a share of w.
std::string error_text(double logarithm) {
  return percent(std::expm1(logarithm));
}

std::vector<Cell> error_cells(const PredictionErrors& errors,
                              const std::optional<double>& left_out) {
  return {{errors.explained ? fine_percent(*errors.explained) : "–"},
          {error_text(errors.rms)},
          {left_out ? error_text(*left_out) : "–"},
          {fmt::format("{:+.0f} % ({})", 100 * std::expm1(errors.worst), errors.worst_id)}};
}

std::vector<Cell> row_of(const Formula& formula, const Thresholds& thresholds) {
  std::vector<Cell> row = {
      {formula.words}, {thresholds.name}, {fmt::format("{}", formula.constants.size())}};
  const auto fit = fitted(formula, thresholds.points);
  if (!fit) {
    row.insert(row.end(), 5, Cell{"–"});
    return row;
  }
  std::string constants;
  for (std::size_t k = 0; k < formula.constants.size(); ++k) {
    constants += fmt::format("{}{}\u00a0=\u00a0{:.3g}", k > 0 ? ", " : "", formula.constants[k],
                             fit->constants[k]);
  }
  row.push_back({constants});
  for (Cell& cell : error_cells(fit->errors, fit->left_out)) row.push_back(std::move(cell));
  return row;
}

/// A speed that theory gives for the scene of every case, without a constant to fit.
std::vector<Cell> row_of(const std::string& words, SceneSpeed speed,
                         const std::vector<CaseStudy>& cases, const Thresholds& thresholds) {
  Points points;
  std::vector<double> predicted;
  for (const ThresholdPoint& point : thresholds.points) {
    const auto value = speed(study_of(point, cases).scene);
    if (!value) continue;
    points.push_back(point);
    predicted.push_back(*value);
  }
  const std::size_t all = thresholds.points.size();
  std::vector<Cell> row = {
      {points.size() == all ? words
                            : fmt::format("{} ({} of {} cases)", words, points.size(), all)},
      {thresholds.name},
      {"0"},
      {"–"}};
  if (points.empty()) {
    row.insert(row.end(), 4, Cell{"–"});
    return row;
  }
  for (Cell& cell : error_cells(errors_of(points, predicted), std::nullopt)) {
    row.push_back(std::move(cell));
  }
  return row;
}

report::Table table_of(const std::vector<CaseStudy>& cases, const std::vector<Thresholds>& both) {
  report::Table table{
      "Formulas for the threshold w, with R = (1 - e) / (1 + e), restitution e, friction mu and "
      "disturbance D [N]. S(F / P) is B w^2 / P at the limit of sustained bouncing with pull P and "
      "friction F in flight; without friction it is pi R. Constants are fitted by least squares of "
      "ln w. Variance explained: of ln w; w = c explains none of it, a formula without error all, "
      "and one that is worse than w = c a negative share. Error: root mean square of ln(formula / "
      "threshold), as a share. Left out: the same for cases that the fit has not seen, each left "
      "out in turn. The last two have no constant to fit: they are the speeds of sustained "
      "bouncing and of lift-off that follow from the constants of the model.",
      {{"formula", Alignment::left},
       {"thresholds", Alignment::left},
       {"fitted"},
       {"constants", Alignment::left},
       {"variance explained"},
       {"error"},
       {"left out"},
       {"worst case"}},
      {}};
  for (const Formula& formula : all_formulas()) {
    for (const Thresholds& one : both) table.rows.push_back(row_of(formula, one));
  }
  for (const Thresholds& one : both) {
    table.rows.push_back(row_of("sustained bouncing", sustained_bouncing_speed, cases, one));
  }
  for (const Thresholds& one : both) {
    table.rows.push_back(row_of("lift-off", lift_off_speed, cases, one));
  }
  return table;
}

double root_of_loss(double restitution) {
  return std::sqrt((1 - restitution) / (1 + restitution));
}

report::Figure chart_of(const std::vector<Thresholds>& both) {
  report::Chart chart;
  chart.name = "theory";
  chart.title = "Threshold and restitution";
  chart.x = {"sqrt((1 - e) / (1 + e))", report::Scale::logarithmic, report::Range{0.2, 1.0}};
  chart.y = {"threshold [rad/s]", report::Scale::logarithmic};
  for (const Thresholds& one : both) {
    std::vector<double> frictions;
    for (const ThresholdPoint& point : one.points) frictions.push_back(point.friction);
    std::sort(frictions.begin(), frictions.end());
    frictions.erase(std::unique(frictions.begin(), frictions.end()), frictions.end());
    for (const double friction : frictions) {
      report::Series series{fmt::format("{}, friction {}", one.name, friction), Mark::points, {}};
      for (const ThresholdPoint& point : one.points) {
        if (point.friction != friction) continue;
        series.samples.push_back({root_of_loss(point.restitution), point.threshold});
      }
      chart.series.push_back(std::move(series));
    }
  }
  for (const Thresholds& one : both) {
    const auto fit = fitted(square_root_formula(), one.points);
    if (!fit) continue;
    const double c = fit->constants[0];
    chart.series.push_back({fmt::format("{}, {:.1f} sqrt((1 - e) / (1 + e))", one.name, c),
                            Mark::line,
                            {{0.2, 0.2 * c}, {1.0, c}}});
  }
  chart.width = 780;
  chart.height = 460;
  return {chart,
          "On these axes every power law is a straight line; both lines have the slope of the "
          "formula. Left: restitution 0.9, right: 0.1; the paper has no other."};
}

/// Two cases that differ in one property only.
struct Pair {
  ThresholdPoint from, to;
  double ratio() const { return to.threshold / from.threshold; }
};

/// Pairs whose property `differs` is larger in `to` and whose other two are equal.
std::vector<Pair> pairs_of(const Points& points, double ThresholdPoint::*differs) {
  std::vector<Pair> pairs;
  for (const ThresholdPoint& from : points) {
    for (const ThresholdPoint& to : points) {
      if (!(from.*differs < to.*differs)) continue;
      ThresholdPoint same = from;
      same.*differs = to.*differs;
      if (same.restitution == to.restitution && same.friction == to.friction &&
          same.disturbance == to.disturbance) {
        pairs.push_back({from, to});
      }
    }
  }
  return pairs;
}

/// "3.65 to 4.5", or a dash.
std::string range_text(std::vector<double> values) {
  if (values.empty()) return "–";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string from = fmt::format("{:.2f}", *least);
  const std::string to = fmt::format("{:.2f}", *most);
  return from == to ? from : from + " to " + to;
}

std::string finding(const std::vector<Thresholds>& both) {
  std::string text = "Found:";
  for (const Thresholds& one : both) {
    const auto fit = fitted(square_root_formula(), one.points);
    const auto with_friction = fitted(friction_formula(), one.points);
    if (!fit || !with_friction || !fit->errors.explained) continue;
    text += fmt::format(
        " w = c sqrt((1 - e) / (1 + e)) explains {} of the variance of ln w of the {} thresholds "
        "with the single constant c, and misses them by {} (root mean square); with a factor "
        "exp(k mu) for friction it explains {} and misses them by {}.",
        percent(*fit->errors.explained), one.name == "paper" ? "paper's" : "computed",
        error_text(fit->errors.rms), percent(*with_friction->errors.explained),
        error_text(with_friction->errors.rms));
  }
  return text;
}

std::string name_in_text(const Thresholds& one) {
  return one.name == "paper" ? "paper" : "computed thresholds";
}

std::string words_on_restitution(const std::vector<Thresholds>& both) {
  std::string text;
  for (const Thresholds& one : both) {
    std::vector<double> ratios;
    double predicted = 0;
    for (const Pair& pair : pairs_of(one.points, &ThresholdPoint::restitution)) {
      ratios.push_back(1 / pair.ratio());
      predicted = root_of_loss(pair.from.restitution) / root_of_loss(pair.to.restitution);
    }
    if (ratios.empty()) continue;
    if (text.empty()) {
      text = fmt::format(
          "Restitution: between cases that differ in restitution alone the formula "
          "makes the threshold {:.2f} times as high at 0.1 as at 0.9.",
          predicted);
    }
    text += fmt::format(" In the {} it is {} times as high", name_in_text(one), range_text(ratios));
    const auto free = fitted(power_formula(), one.points);
    text += free ? fmt::format(", and the exponent, here 0.5, comes out at {:.3f} if left free.",
                               free->constants[1])
                 : std::string(".");
  }
  return text +
         " Two restitutions are all there is: they test the size of the effect, not the form of "
         "the curve between, and any formula with a free exponent passes through both.";
}

std::string words_on_friction(const std::vector<CaseStudy>& cases,
                              const std::vector<Thresholds>& both) {
  const auto factors = [](const Points& points, double restitution) {
    std::vector<double> values;
    for (const Pair& pair : pairs_of(points, &ThresholdPoint::friction)) {
      if (pair.from.restitution == restitution) values.push_back(pair.ratio());
    }
    return range_text(values);
  };
  Points bouncing;
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    const auto speed = sustained_bouncing_speed(c.scene);
    if (speed && it.claim.threshold) {
      bouncing.push_back({it.id, it.restitution, it.friction, it.disturbance, *speed});
    }
  }
  std::string text =
      "Friction: raised from 0.1 to 0.4 it multiplies the threshold, at restitution 0.1 and at "
      "0.9,";
  for (const Thresholds& one : both) {
    text += fmt::format(" by {} and {} ({}),", factors(one.points, 0.1), factors(one.points, 0.9),
                        one.name);
  }
  return text +
         fmt::format(
             " and the limit of sustained bouncing with the model's constants by {} and {}. In "
             "that limit friction takes from the body what impacts do not, so it weighs the more "
             "the less the impacts take.",
             factors(bouncing, 0.1), factors(bouncing, 0.9));
}

/// The ratios of thresholds to a speed of the model, of the cases of one restitution.
std::vector<double> ratios_to(SceneSpeed speed, const std::vector<CaseStudy>& cases,
                              const Points& points, double restitution) {
  std::vector<double> ratios;
  for (const ThresholdPoint& point : points) {
    if (point.restitution != restitution) continue;
    const auto value = speed(study_of(point, cases).scene);
    if (value) ratios.push_back(point.threshold / *value);
  }
  return ratios;
}

/// How the computed thresholds compare with a speed of the model, at both restitutions, and at
/// which of them they are that speed.
std::string words_on_speed(const std::string& name, SceneSpeed speed,
                           const std::vector<CaseStudy>& cases, const Points& computed) {
  const auto low = ratios_to(speed, cases, computed, 0.1);
  const auto high = ratios_to(speed, cases, computed, 0.9);
  if (low.empty() || high.empty()) return fmt::format(" the model's forces have no {}.", name);
  const auto is_it = [](const std::vector<double>& ratios) {
    return std::all_of(ratios.begin(), ratios.end(),
                       [](double ratio) { return std::abs(ratio - 1) < 0.1; });
  };
  std::string text =
      fmt::format(" they are {} times the speed of {} at restitution 0.1, and {} times it at 0.9",
                  range_text(low), name, range_text(high));
  if (is_it(low) && is_it(high)) return text + "; within a tenth the threshold is that speed.";
  if (is_it(low))
    return text + "; at 0.1 the threshold is that speed, within a tenth, at 0.9 it is not.";
  if (is_it(high))
    return text + "; at 0.9 the threshold is that speed, within a tenth, at 0.1 it is not.";
  return text + ".";
}

std::string words_on_speeds(const std::vector<CaseStudy>& cases, const Points& computed) {
  return "The computed thresholds also stand beside two speeds that follow from the model's "
         "constants alone:" +
         words_on_speed("lift-off", lift_off_speed, cases, computed) + " For the other," +
         words_on_speed("sustained bouncing", sustained_bouncing_speed, cases, computed);
}

std::string times_text(double value) {
  return value < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

/// Whether the motion behind the formula is one that the model's carrier can make.
std::string words_on_height(const std::vector<CaseStudy>& cases) {
  std::vector<double> heights;  // in clearances
  for (const CaseStudy& c : cases) {
    const auto height = sustained_bouncing_height(c.scene);
    if (height) heights.push_back(*height / (c.scene.wall_upper - c.scene.wall_lower));
  }
  if (heights.empty()) {
    return "The model's forces are not those of sustained bouncing: the formula is a scaling here, "
           "not an explanation.";
  }
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  const std::string range = fmt::format(
      "Has the carrier the room to bounce so? At the limit it would rise {} to {} times "
      "its clearance.",
      times_text(*least), times_text(*most));
  if (*most < 1) return range + " So it has, and can move as the formula assumes.";
  if (*least < 1) return range + " So it has in some cases only.";
  return range +
         " So it has not: it meets the other wall first. Where the model agrees with the formula, "
         "it is not because the carrier moves as the formula assumes.";
}

}  // namespace

report::Section theory_section(const std::vector<CaseStudy>& cases) {
  const std::vector<Thresholds> both = thresholds_of(cases);
  report::Section section{"theory", "How much a one-line formula explains"};
  section.paragraphs = {
      finding(both),
      "Where the formula comes from: a body pulled onto a wall with a force P and shaken by "
      "B w^2 cos(w t) loses speed at every impact, and the shaking has to give it back. It can "
      "bounce on, once a turn, only from B w^2 = pi P (1 - e) / (1 + e) on. So the speed grows "
      "with sqrt((1 - e) / (1 + e)), whatever P and B are: they are in c. Friction in flight "
      "raises the limit. Lift-off, B w^2 = P + friction, is where the shaking lifts a body at "
      "rest; "
      "restitution has no part in it.",
      words_on_restitution(both),
      words_on_friction(cases, both),
      words_on_speeds(cases, both[1].points),
      words_on_height(cases)};
  section.tables = {table_of(cases, both)};
  section.figures = {chart_of(both)};
  return section;
}

}  // namespace ricochet::studies::reproduction
