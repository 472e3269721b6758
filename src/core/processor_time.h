#pragma once

namespace ricochet {

/// Processor time of this thread [s]: other threads and waiting do not count.
double processor_seconds();

}  // namespace ricochet
