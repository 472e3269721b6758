#pragma once

#include "src/studies/study.h"

namespace ricochet::studies {

/// Whether the surrogate, and its gradient, can be trusted: some minutes on two processors.
Study surrogate_study();

}  // namespace ricochet::studies
