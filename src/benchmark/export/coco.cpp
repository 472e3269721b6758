#include "src/benchmark/export/coco.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/export/best_so_far.h"
#include "src/benchmark/export/numbering.h"
#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/running_times.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;

constexpr const char* coco_readme =
    R"(A campaign of ricochet for the post-processing of COCO, https://github.com/numbbo/coco:
python -m cocopp FOLDER FOLDER ...

Every folder is one algorithm: a solver-formulation pair with its perturbation, price of a gradient,
and budget in evaluations per variable. Every problem is one function with its own number of
variables; running_times.csv lists them.

The files use the format of COCO's suite bbob-mixint, of which cocopp opens only 5 and 6 variables
and functions 1 to 24. Problems of 5 and 6 variables have the first numbers. All others are here,
too, for a cocopp that knows them. The function names in cocopp's pages are not ricochet's.

Values are optimality gaps: the true objective minus the best known value (fopt), of feasible points
only; 1e30 until there is one. Evaluations are as charged, gradients at their price; evaluations of
constraints are included and not counted again. Coordinates are those of the best point, else nan.
cocopp's targets do not know the problems' tolerances. See running_times.csv for solved runs and
expected running times: unsolved runs count with all their evaluations, identical runs count once,
intervals are 95 %. Runs on the same instance have different seeds. A run that ended before its
first evaluation is listed with one evaluation.
)";

/// The next count at which every run has a row in .tdat: 1, 2, 5, 10, 20, ...
std::int64_t after(std::int64_t count) {
  std::int64_t power = 1;
  while (count / power >= 10) power *= 10;
  const std::int64_t digit = count / power;
  return power * (digit == 1 ? 2 : digit == 2 ? 5 : 10);
}

/// Files of one algorithm on one problem.
class Case {
 public:
  Case(const comparison::JudgedRun& first, const Completeness& completeness, Numbering& numbering,
       const fs::path& folder)
      : comment_(completeness.is_in_doubt() ? "of a campaign of ricochet: " + in_words(completeness)
                                            : "of ricochet"),
        root_(folder / numbering.algorithm(first.stored.key.cell)),
        id_(numbering.function_id(first.problem.name)),
        variables_(first.problem.variables),
        algorithm_(numbering.algorithm(first.stored.key.cell)),
        stem_(fmt::format("data_f{0}/bbobexp_f{0}_DIM{1}", id_, variables_)),
        improvements_(made(root_ / (stem_ + ".dat"))),
        counts_(root_ / (stem_ + ".tdat")) {}

  void add(const comparison::JudgedRun& run) {
    const double fopt = run.problem.best_known;
    const std::string header = header_of(fopt);
    improvements_.write(header);
    counts_.write(header);
    const auto steps = best_so_far(run.outcome);
    const auto& trace = run.stored.record.trace;
    std::int64_t count = 1;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const bool is_best = steps[k].optimality_gap == steps.back().optimality_gap &&
                           !trace.empty() && trace.back().true_values.violation <= 0;
      const std::string values =
          values_of(steps[k].optimality_gap, fopt, is_best ? &trace.back().x : nullptr);
      improvements_.write(fmt::format("{} {}", steps[k].evaluations, values));
      const bool last = k + 1 == steps.size();
      for (; !last && count < steps[k + 1].evaluations; count = after(count)) {
        counts_.write(fmt::format("{} {}", count, values));
      }
      if (last) counts_.write(fmt::format("{} {}", steps[k].evaluations, values));
    }
    summary_ += fmt::format(", {}:{}|{:.1e}", run.stored.key.instance, steps.back().evaluations,
                            steps.back().optimality_gap);
  }

  void close() {
    improvements_.close();
    counts_.close();
    write_file(root_ / fmt::format("bbobexp_f{}.info", id_),
               fmt::format("suite = 'bbob-mixint', funcId = {}, DIM = {}, Precision = 1.000e-08, "
                           "algId = '{}', coco_version = '2.8.0', logger = 'bbob', "
                           "data_format = 'bbob-new2'\n% {}\n{}.dat{}\n",
                           id_, variables_, algorithm_, comment_, stem_, summary_));
  }

 private:
  static fs::path made(const fs::path& file) {
    fs::create_directories(file.parent_path());
    return file;
  }

  std::string header_of(double fopt) const {
    std::string header = fmt::format(
        "% f evaluations | g evaluations | best noise-free fitness - Fopt ({:.12e}) + sum g_i+ | "
        "measured fitness | best measured fitness or single-digit g-values",
        fopt);
    for (std::int64_t k = 1; k <= variables_; ++k) header += fmt::format(" | x{}", k);
    return header + "\n";
  }

  /// The values of a row, without its evaluations. Readers drop rows that lack a coordinate.
  std::string values_of(double optimality_gap, double fopt, const Vector* x) const {
    const double fitness =
        optimality_gap == nothing_feasible ? optimality_gap : fopt + optimality_gap;
    std::string values = fmt::format("0 {0:+} {1:+} {1:+}", optimality_gap, fitness);
    for (std::int64_t k = 0; k < variables_; ++k) {
      values += x != nullptr && k < x->size() ? fmt::format(" {:+}", (*x)[k]) : " nan";
    }
    return values + "\n";
  }

  std::string comment_;
  fs::path root_;
  int id_;
  std::int64_t variables_;
  std::string algorithm_, stem_;
  OutputFile improvements_, counts_;
  std::string summary_;  ///< of the runs
};

}  // namespace

void write_coco(const Store& store, const Completeness& completeness, const fs::path& folder) {
  Numbering numbering(store.description());
  RunningTimes times(folder / "running_times.csv");
  std::optional<Case> now;
  comparison::each_judged(
      store,
      [&](const comparison::JudgedRun& run) {
        if (!now) now.emplace(run, completeness, numbering, folder);
        now->add(run);
      },
      [&](const comparison::JudgedCell& cell) {
        now->close();
        now.reset();
        times.add(cell, numbering);
      });
  times.close();
  write_file(folder / "README.txt", coco_readme + ("\n" + as_sentence(completeness)) + "\n");
}

}  // namespace ricochet::exports
