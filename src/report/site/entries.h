#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::site {

using report::Json;

/// How a report was made, according to its data.json.
struct Made {
  std::optional<std::string> date;
  std::optional<double> seconds;
  std::optional<bool> quick;
};
RICOCHET_FIELDS(Made, date, seconds, quick);

/// A further page of a report.
struct FoundPage {
  std::string folder;  ///< inside the report's folder
  std::optional<report::Headline> headline;
  Json data;
  std::vector<std::string> pages = {};  ///< folders of pages inside its own
};

/// A report in a folder of a site.
struct FoundReport {
  std::string folder;  ///< its name, in the front page's folder
  report::ReportKind kind;
  Made made;
  std::optional<report::Headline> headline;  ///< nothing if its data are of another version
  Json data;                                 ///< its data.json
  std::vector<FoundPage> pages;
};

/// Returns the subfolders with a data.json that is not of a site, in the order of their names.
std::vector<std::string> folders_of_data(const std::filesystem::path& site);

/// Returns the reports in the subfolders, in the order of their kinds, then of their names. Folders
/// without the data of a known kind of report are ignored.
std::vector<FoundReport> found_reports(const std::filesystem::path& site);

/// Label in the navigation: that of its kind, with its folder if that has another name.
std::string label_of(const FoundReport& report);

/// Returns true if the headline lists these data.
bool holds(const std::optional<report::Headline>& headline, const std::string& what);

/// The smallest and the largest of some numbers.
struct Extent {
  std::int64_t least, most;
};

/// The problems of a family, or "all".
struct FamilySize {
  std::string name;
  std::size_t problems;
  Extent variables, constraints;
};

struct FamilyProblem;

/// Returns the size of a family of problems, or of all of them.
FamilySize size_of(const std::string& name, const std::vector<FamilyProblem>& problems);

/// A solver-formulation pair on a family with a budget. A missing value was not rated or not
/// measured.
struct Entry {
  std::size_t family = {};          ///< its number in the comparison
  double budget = {};               ///< evaluations per variable; 0: the largest of each family
  std::size_t place = {}, of = {};  ///< among the entries with ratings
  std::string solver = {}, formulation = {};
  bool outside = {};                ///< not one of ricochet's own
  std::optional<double> best = {};  ///< probability of being the best
  std::optional<double> targets = {}, lower = {}, upper = {};
  std::optional<double> returned = {};  ///< success rate of the returned points
  std::optional<std::int64_t> never = {};
  std::optional<double> rank = {};
  // Speed against accuracy, over the runs:
  std::optional<double> evaluations = {};  ///< for each variable
  std::optional<double> seconds = {};
  std::optional<double> solved = {}, solved_lower = {}, solved_upper = {};
  std::optional<double> error = {}, error_lower = {}, error_upper = {};  ///< the median
  bool complete = {};  ///< true if it takes all problems that any entry takes
};

/// The share of targets that an entry reaches, over the evaluations.
struct Curve {
  std::size_t family;
  double budget;
  std::string solver, formulation;
  std::vector<std::vector<double>> points;  ///< evaluations per variable, share
};

/// A comparison of solvers for the front page. For each family and budget it has the first 15
/// entries, and also those with speed against accuracy and the external ones.
struct Comparison {
  std::string folder;
  std::vector<FamilySize> families;
  std::vector<Entry> entries;  ///< by family, budget and place
  std::vector<Curve> curves;
  std::map<std::string, std::string> kinds;  ///< of the solvers, if the data have them
};

/// Solvers that charts name wherever they lie: the paper's algorithm, and random search.
inline constexpr const char* always_named[] = {"fireworks", "random-search"};

RICOCHET_FIELDS(Extent, least, most);
RICOCHET_FIELDS(FamilySize, name, problems, variables, constraints);
RICOCHET_FIELDS(Entry, family, budget, place, of, solver, formulation, outside, best, targets,
                lower, upper, returned, never, rank, evaluations, seconds, solved, solved_lower,
                solved_upper, error, error_lower, error_upper, complete);
RICOCHET_FIELDS(Curve, family, budget, solver, formulation, points);
RICOCHET_FIELDS(Comparison, folder, families, entries, curves, kinds);

/// Returns the comparison of a report that holds "entries", with its pages that hold a "family".
/// Throws Json::exception if their data are of another version.
Comparison comparison_of(const FoundReport& report);

/// Returns the report with most runs among those that hold "entries"; null if there is none.
const FoundReport* largest_comparison(const std::vector<FoundReport>& reports);

// The parts of a comparison's data.json that the front page reads.

struct NamedSolver {
  std::string name;
  bool outside;
  std::optional<std::string> needs;  ///< "nothing", or kinds of derivatives
  std::optional<std::string> kind;   ///< "fireworks", "derivatives", ...
};

struct SpeedAccuracy {
  std::string family;            ///< or "all"
  std::optional<double> budget;  ///< nothing for all families
  bool largest;
  std::string solver, formulation;
  bool complete;
  std::optional<std::int64_t> problems;
  std::optional<double> evaluations, seconds, share, share_lower, share_upper, optimality_gap,
      optimality_gap_lower, optimality_gap_upper;
};

/// The first entry of a family with a budget, of which only this is read.
struct LeadingEntry {
  std::string family;
  double budget;
  std::optional<bool> easy;      ///< true if random search is enough
  std::optional<double> random;  ///< evaluations that random search needs
};

struct ComparisonData {
  std::int64_t runs;
  std::vector<NamedSolver> solvers;
  std::vector<SpeedAccuracy> speed_accuracy;
  std::vector<LeadingEntry> leaders;
};

struct FamilyProblem {
  std::int64_t variables, constraints;
};

struct Rating {
  std::string solver, formulation;
  std::optional<std::int64_t> problems;  ///< that it takes
  std::optional<double> best;  ///< nothing for one problem, or if no run solved its problem
  double share, lower, upper, returned;
  std::int64_t never;
  std::optional<double> rank;  ///< nothing if the entry takes fewer than half of the problems
};

struct Step {
  double evaluations, share;
};

struct Progress {
  std::string solver, formulation;
  std::vector<Step> progress;
};

struct RatedBudget {
  double budget;
  std::vector<Rating> ratings;
  std::vector<Progress> first;                 ///< of the first ratings
  std::optional<std::vector<Progress>> paper;  ///< of the paper's algorithm, if it is none of them
};

struct PerturbationName {
  std::string perturbation;
};

/// An entry on the problems of a family that are run under perturbations.
struct PerturbedEntry {
  report::Json shares;  ///< success rate under each perturbation, or null
  std::string family, solver, formulation;
  std::int64_t problems, least_variables, most_variables, runs;
  double budget;  ///< evaluations for each variable
};

struct PerturbedData {
  std::vector<PerturbationName> perturbation_names;
  std::vector<PerturbedEntry> perturbation_rows;
};

struct MeasuredSimulation {
  double simulation;  ///< [s]
};

struct BreakEven {
  double budget;
  std::vector<MeasuredSimulation> here;
};

struct FamilyData {
  std::string family;
  std::vector<FamilyProblem> problems;
  std::vector<RatedBudget> budgets;
  std::vector<BreakEven> break_even_families;
};

RICOCHET_FIELDS(NamedSolver, name, outside, needs, kind);
RICOCHET_FIELDS(SpeedAccuracy, family, budget, largest, solver, formulation, complete, problems,
                evaluations, seconds, share, share_lower, share_upper, optimality_gap,
                optimality_gap_lower, optimality_gap_upper);
RICOCHET_FIELDS(LeadingEntry, family, budget, easy, random);
RICOCHET_FIELDS(ComparisonData, runs, solvers, speed_accuracy, leaders);
RICOCHET_FIELDS(FamilyProblem, variables, constraints);
RICOCHET_FIELDS(Rating, solver, formulation, problems, best, share, lower, upper, returned, never,
                rank);
RICOCHET_FIELDS(Step, evaluations, share);
RICOCHET_FIELDS(Progress, solver, formulation, progress);
RICOCHET_FIELDS(RatedBudget, budget, ratings, first, paper);
RICOCHET_FIELDS(PerturbationName, perturbation);
RICOCHET_FIELDS(PerturbedEntry, shares, family, solver, formulation, problems, least_variables,
                most_variables, runs, budget);
RICOCHET_FIELDS(PerturbedData, perturbation_names, perturbation_rows);
RICOCHET_FIELDS(MeasuredSimulation, simulation);
RICOCHET_FIELDS(BreakEven, budget, here);
RICOCHET_FIELDS(FamilyData, family, problems, budgets, break_even_families);

}  // namespace ricochet::site
