#include "src/studies/fireworks/errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "src/campaign/progress.h"

namespace ricochet::studies::fireworks {
namespace {

constexpr double negligible = 1e-8;

/// How many standard errors a mean of `degrees + 1` values may be off at 95 %.
double student_t(double degrees) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.975);
}

}  // namespace

std::vector<std::vector<double>> errors_of(const std::vector<Contestant>& contestants,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress) {
  std::vector<std::vector<double>> errors(contestants.size(),
                                          std::vector<double>(static_cast<std::size_t>(runs)));
  Progress shown(progress, static_cast<double>(contestants.size()) * runs);
  tbb::parallel_for(std::size_t{0}, contestants.size() * static_cast<std::size_t>(runs),
                    [&](std::size_t k) {
                      const std::size_t number = k / contestants.size();
                      const std::size_t which = k % contestants.size();
                      const Contestant& contestant = contestants[which];
                      const RunRecord record = run(contestant.problem(), contestant.solver,
                                                   {evaluations}, static_cast<int>(number) + 1);
                      if (!record.failure.empty()) throw std::runtime_error(record.failure);
                      errors[which][number] = record.trace.back().truth.objective;
                      shown.advance(1);
                    });
  return errors;
}

report::Json moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / (count - 1);
  const double deviation = std::sqrt(variance);
  const double reach = student_t(count - 1) * deviation / std::sqrt(count);
  return {{"mean", mean},
          {"deviation", deviation},
          {"runs", values.size()},
          {"lower", mean - reach},
          {"upper", mean + reach}};
}

bool agrees(const report::Json& moments, const OtherMean& other) {
  const double runs = moments["runs"].get<double>();
  const double deviation = moments["deviation"].get<double>();
  const double other_deviation = other.deviation.value_or(deviation);
  const double error =
      std::hypot(deviation / std::sqrt(runs), other_deviation / std::sqrt(other.runs));
  const double apart = std::abs(moments["mean"].get<double>() - other.mean);
  return apart <= std::max(student_t(runs - 1) * error, negligible);
}

}  // namespace ricochet::studies::fireworks
