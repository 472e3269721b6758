#pragma once

namespace ricochet {

/// Limits this process, a child: `megabytes` of memory besides what it has now, and no core file.
/// With sanitizers memory is not limited, since their own needs the whole address space.
void limit_resources(double megabytes);

}  // namespace ricochet
