#pragma once

#include <Eigen/Core>

namespace ricochet {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

}  // namespace ricochet
