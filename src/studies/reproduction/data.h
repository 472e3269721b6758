#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/studies/reproduction/study.h"

/// The parts of the report's data. Speeds are in rad/s, errors and shares are fractions.
namespace ricochet::studies::reproduction {

/// The paper's claims for every case and the computed values, by the case's id.
report::Json case_data(const std::vector<CaseStudy>& cases);

/// Fastest quiet speeds in the long run of the machines, i.e. of cases that differ only in their
/// disturbance.
report::Json speed_data(const std::vector<CaseStudy>& cases);

/// The speeds of the paper's figures, those on the wrong side, a chart of the thresholds.
report::Json threshold_data(const std::vector<CaseStudy>& cases);

/// How much of the thresholds, the paper's and the computed ones, simple formulas explain.
report::Json theory_data(const std::vector<CaseStudy>& cases);

/// How close any model can come to the paper's thresholds, whatever its equations: lower bounds, in
/// closed form, on the error of ln(threshold) if thresholds are ordered as the paper concludes, if
/// they fall in proportion to the disturbance, and if they do not depend on it.
report::Json bound_data();

/// Collision count against speed, one chart for each case.
report::Json curve_data(const std::vector<CaseStudy>& cases);

/// Does the count make a step at the threshold of every case?
report::Json sharpness_data(const std::vector<CaseStudy>& cases);

/// The steps of every case's staircase, with the threshold by the paper's rule.
report::Json step_data(const std::vector<CaseStudy>& cases);

/// Conclusions A, B and C on a grid of restitution, friction and disturbance.
report::Json conclusion_data(const CountGrid& grid, const std::vector<Trend>& trends);

/// x(t) of the cases without disturbance, at several speeds, with those of the cases that differ
/// only in their disturbance; of the others as in Figures 9-14; and the times of the impacts.
report::Json path_data(const std::vector<CaseStudy>& cases);

/// Velocity and acceleration along the track, as in Figure 3.
report::Json crossing_data();

/// Collisions a turn in the long run over restitution and speed, a map for each friction, with the
/// paper's thresholds of the cases without disturbance. Null without maps.
report::Json regime_map_data(const std::vector<RestitutionMap>& maps);

/// How well each solver finds the fewest collisions and the fastest quiet speed.
report::Json comparison_data(const std::optional<StoredCampaign>& comparison);

/// The interpretation's answers to the paper's open questions, and its parameters.
report::Json interpretation_data(const carrier_track::FittedInterpretation& interpretation);

}  // namespace ricochet::studies::reproduction
