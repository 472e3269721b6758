#include "src/cli/outside_run.h"

#include <limits>
#include <utility>

namespace ricochet::cli {
namespace {

using report::Json;

/// Row by row.
Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(Vector(matrix.row(i)));
  return rows;
}

void append(const auto& values, std::vector<double>& numbers) {
  const auto flat = values.reshaped();
  numbers.insert(numbers.end(), flat.begin(), flat.end());
}

}  // namespace

std::vector<double> Answer::numbers() const {
  std::vector<double> all = {told.values.objective, true_values.objective, true_values.violation};
  append(told.values.constraints, all);
  append(told.gradient, all);
  append(told.jacobian, all);
  append(residuals.values, all);
  append(residuals.jacobian, all);
  return all;
}

Json json_of(const Answer& answer, outside::Wanted wanted) {
  Json json = {{"objective", answer.told.values.objective},
               {"constraints", answer.told.values.constraints}};
  if (wanted.derivatives) {
    json["gradient"] = answer.told.gradient;
    json["jacobian"] = rows_of(answer.told.jacobian);
  }
  if (wanted.residuals) json["residuals"] = answer.residuals.values;
  if (wanted.residuals && wanted.derivatives) {
    json["residual_jacobian"] = rows_of(answer.residuals.jacobian);
  }
  json["true_values"] = {{"objective", answer.true_values.objective},
                         {"violation", answer.true_values.violation}};
  return json;
}

OutsideRun::OutsideRun(Problem problem) : problem_(std::move(problem)) {
  evaluator_.emplace(problem_, Budget{std::numeric_limits<std::int64_t>::max()});
}

Answer OutsideRun::answer(const Vector& x, outside::Wanted wanted) {
  Answer answer;
  if (wanted.derivatives) {
    if (auto told = evaluator_->derivatives(x)) answer.told = std::move(*told);
  } else {
    if (auto told = evaluator_->values(x)) answer.told.values = std::move(*told);
  }
  if (wanted.residuals && wanted.derivatives) {
    if (auto told = evaluator_->residuals(x)) answer.residuals = std::move(*told);
  } else if (wanted.residuals) {
    if (auto told = evaluator_->residual_values(x)) answer.residuals.values = *told;
  }
  if (const std::exception_ptr failure = evaluator_->failure()) {
    before_ = evaluations();
    evaluator_.emplace(problem_, Budget{std::numeric_limits<std::int64_t>::max()});
    std::rethrow_exception(failure);
  }
  const Vector inside = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  answer.true_values = problem_.true_values
                           ? problem_.true_values(inside)
                           : true_values_of(answer.told.values, problem_.equalities);
  return answer;
}

}  // namespace ricochet::cli
