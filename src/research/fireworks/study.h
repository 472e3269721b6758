#pragma once

#include "src/studies/study.h"

namespace ricochet::studies {

/// The fireworks family beside what others have published and measured of it: ten minutes of
/// processor time.
Study fireworks_study();

}  // namespace ricochet::studies
