#include "src/cli/reproduce.h"
namespace ricochet::cli {
int reproduce(const ReproduceOptions&) {
  return 1;
}
}  // namespace ricochet::cli
