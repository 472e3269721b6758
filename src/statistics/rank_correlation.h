#pragma once

#include <optional>
#include <vector>

namespace ricochet {

/// Spearman's rank correlation of two samples of the same length >= 2, in [-1, 1]: Pearson's of
/// their ranks, equal values sharing the mean of theirs. Nothing where a sample is the same
/// everywhere. Throws std::invalid_argument for samples that do not fit.
std::optional<double> rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ricochet
