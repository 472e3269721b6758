#pragma once

#include <vector>

namespace ricochet {

/// Numbers of questions, by how A fared against B.
struct CostComparison {
  int better = 0, close = 0, worse = 0;
  int neither = 0;  ///< that no one solved
};

/// Compares two solvers question by question: close where the larger cost is at most 10 % above the
/// smaller (the tolerance of PAVER 2.0, doi:10.1007/s10898-013-0131-5). A cost is > 0, and infinite
/// for a failure. Throws std::invalid_argument for other costs or samples of different length.
CostComparison compare_costs(const std::vector<double>& costs_of_a,
                             const std::vector<double>& costs_of_b);

}  // namespace ricochet
