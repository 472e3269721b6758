#include "src/research/fireworks/errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "src/core/progress.h"

namespace ricochet::studies::fireworks {
namespace {

constexpr double negligible = 1e-8;

/// Quantile of Student's t for a two-sided 95 % interval of the mean of `degrees + 1` values, in
/// standard errors.
double student_t(double degrees) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.975);
}

}  // namespace

std::vector<std::vector<double>> errors_of(const std::vector<Entry>& entries,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress) {
  std::vector<std::vector<double>> errors(entries.size(),
                                          std::vector<double>(static_cast<std::size_t>(runs)));
  Progress shown(progress, static_cast<double>(entries.size()) * runs);
  tbb::parallel_for(
      std::size_t{0}, entries.size() * static_cast<std::size_t>(runs), [&](std::size_t k) {
        const std::size_t number = k / entries.size();
        const std::size_t which = k % entries.size();
        const Entry& entry = entries[which];
        const RunRecord record =
            run(entry.problem(), entry.solver, {evaluations}, static_cast<int>(number) + 1);
        if (!record.failure.empty()) throw std::runtime_error(record.failure);
        errors[which][number] = record.trace.back().true_values.objective;
        shown.advance(1);
      });
  return errors;
}

Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / (count - 1);
  const double deviation = std::sqrt(variance);
  const double reach = student_t(count - 1) * deviation / std::sqrt(count);
  return {mean, deviation, values.size(), mean - reach, mean + reach};
}

bool agrees(const Moments& moments, const OtherMean& other) {
  const auto runs = static_cast<double>(moments.runs);
  const double other_deviation = other.deviation.value_or(moments.deviation);
  const double error =
      std::hypot(moments.deviation / std::sqrt(runs), other_deviation / std::sqrt(other.runs));
  const double apart = std::abs(moments.mean - other.mean);
  return apart <= std::max(student_t(runs - 1) * error, negligible);
}

}  // namespace ricochet::studies::fireworks
