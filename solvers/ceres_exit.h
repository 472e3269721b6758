#pragma once

#include <ceres/types.h>
#include <glog/logging.h>

#include <string>

/// For the adapters of Ceres alone.
namespace ricochet {

/// Ceres warns, on standard error, where a function is flat, whatever its options say. What the
/// suite has to say of a run is in its record.
inline void silence_ceres() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

/// What Ceres says of its own end.
inline std::string in_words(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE:
      return "converged";
    case ceres::NO_CONVERGENCE:
      return "iterations spent";
    default:
      return "failure";
  }
}

}  // namespace ricochet
