#include "src/benchmark/statistics/rank_correlation.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "src/benchmark/statistics/confidence.h"
#include "src/benchmark/statistics/ranks.h"

namespace ricochet {
namespace {

void check(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.size() < 2) {
    throw std::invalid_argument("rank correlation: samples of one length, at least 2, are needed");
  }
}

}  // namespace

std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  check(a, b);
  const std::vector<double> ranks_a = ranks_of(a);
  const std::vector<double> ranks_b = ranks_of(b);
  const double mean = (static_cast<double>(a.size()) + 1) / 2;
  double products = 0;
  double squares_a = 0;
  double squares_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    products += (ranks_a[i] - mean) * (ranks_b[i] - mean);
    squares_a += (ranks_a[i] - mean) * (ranks_a[i] - mean);
    squares_b += (ranks_b[i] - mean) * (ranks_b[i] - mean);
  }
  if (squares_a == 0 || squares_b == 0) return std::nullopt;
  return products / std::sqrt(squares_a * squares_b);
}

std::optional<double> kendall_rank_correlation(const std::vector<double>& a,
                                               const std::vector<double>& b) {
  check(a, b);
  long long concordant_less_discordant = 0;
  long long unlike_a = 0;  // pairs that are not tied
  long long unlike_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const int sign_a = (a[i] > a[k]) - (a[i] < a[k]);
      const int sign_b = (b[i] > b[k]) - (b[i] < b[k]);
      concordant_less_discordant += sign_a * sign_b;
      unlike_a += sign_a * sign_a;
      unlike_b += sign_b * sign_b;
    }
  }
  if (unlike_a == 0 || unlike_b == 0) return std::nullopt;
  return static_cast<double>(concordant_less_discordant) /
         std::sqrt(static_cast<double>(unlike_a) * static_cast<double>(unlike_b));
}

Interval kendall_interval(double correlation, std::size_t size, double confidence) {
  check_confidence(confidence);
  if (!(std::abs(correlation) <= 1) || size <= 4) {
    throw std::invalid_argument("kendall_interval: a correlation of at least 5 pairs is needed");
  }
  const boost::math::students_t student(static_cast<double>(size - 2));
  const double half =
      quantile(student, (1 + confidence) / 2) * std::sqrt(0.437 / static_cast<double>(size - 4));
  return {std::tanh(std::atanh(correlation) - half), std::tanh(std::atanh(correlation) + half)};
}

}  // namespace ricochet
