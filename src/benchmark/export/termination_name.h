#pragma once

#include "src/core/evaluator.h"

namespace ricochet::exports {

/// As it is in the store's own table of them.
constexpr const char* name_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return "none";
    case Refusal::evaluations:
      return "evaluations";
    case Refusal::seconds:
      return "seconds";
    case Refusal::bad_point:
      return "bad point";
    case Refusal::failure:
      return "failure";
    case Refusal::paused:
      return "paused";
  }
  return "";
}

}  // namespace ricochet::exports
