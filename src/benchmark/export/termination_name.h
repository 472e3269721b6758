#pragma once

#include "ricochet/evaluator.h"

namespace ricochet::exports {

/// The name of a termination reason, as in the store's table of them.
constexpr const char* name_of(TerminationReason termination_reason) {
  switch (termination_reason) {
    case TerminationReason::none:
      return "none";
    case TerminationReason::evaluations:
      return "evaluations";
    case TerminationReason::seconds:
      return "seconds";
    case TerminationReason::bad_point:
      return "bad point";
    case TerminationReason::failure:
      return "failure";
    case TerminationReason::paused:
      return "paused";
  }
  return "";
}

}  // namespace ricochet::exports
