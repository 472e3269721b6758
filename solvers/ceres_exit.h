#pragma once

#include <ceres/types.h>
#include <glog/logging.h>

#include <string>

/// Only for the adapters of Ceres.
namespace ricochet {

/// Silences the warnings that Ceres writes to standard error where a function is flat, whatever its
/// options are. The run's record holds what the suite needs.
inline void silence_ceres() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

/// Ceres's termination type as text.
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
