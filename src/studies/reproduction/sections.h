#pragma once

#include <vector>

#include "src/report/results.h"
#include "src/studies/reproduction/study.h"

/// The sections of the report: each adds its values, tables and charts. Speeds are in rad/s, errors
/// and shares are fractions.
namespace ricochet::studies::reproduction {

/// How far the thresholds agree with the paper's, by the paper's rule and in the long run.
void add_thresholds(const Findings& findings, report::Results& results);

/// What moves the fastest quiet speed: exponents, and curves over constants.
void add_levers(const Findings& findings, report::Results& results);

/// Whether the count makes a step at the threshold, by the paper's claims and by its staircase.
void add_steps(const std::vector<CaseStudy>& cases, report::Results& results);

/// The paper's conclusions on the grid.
void add_conclusions(const CountGrid& grid, const std::vector<Trend>& trends,
                     report::Results& results);

/// How much of the thresholds, the paper's and the computed ones, simple formulas explain.
void add_theory(const std::vector<CaseStudy>& cases, report::Results& results);

/// How close any model can come to the paper's thresholds, whatever its equations: lower bounds, in
/// closed form, on the error of ln(threshold) if thresholds are ordered as the paper concludes, if
/// they fall in proportion to the disturbance, and if they do not depend on it.
void add_bounds(report::Results& results);

/// The best solvers of each family, and the paper's.
void add_solvers(const std::optional<StoredCampaign>& comparison, report::Results& results);

/// A part for each case: its counts over the speed, and x(t) at the speeds of the paper's figures.
void add_pictures(const Findings& findings, report::Results& results);

/// The interpretation's parameters.
void add_interpretation(const carrier_track::FittedInterpretation& interpretation,
                        report::Results& results);

/// The fastest quiet speeds of the cases in the long run.
std::vector<QuietCase> quiet_cases(const std::vector<CaseStudy>& cases);

/// See Findings::maps.
std::vector<report::Chart> restitution_maps(const std::vector<CaseStudy>& cases);

}  // namespace ricochet::studies::reproduction
