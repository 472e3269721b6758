#pragma once

#include <stdexcept>

namespace ricochet {

/// Throws std::invalid_argument unless the confidence is in (0, 1).
inline void check_confidence(double confidence) {
  if (!(confidence > 0 && confidence < 1)) {
    throw std::invalid_argument("the confidence must be in (0, 1)");
  }
}

}  // namespace ricochet
