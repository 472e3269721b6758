#include "src/cli/provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <ctime>
#include <string>

#include "src/cli/cores.h"
#include "src/cli/version.h"

namespace ricochet::cli {

Provenance provenance() {
  utsname machine{};
  uname(&machine);
  return {{{"version", version()}},
          {{"machine", fmt::format("{} {}, {}", machine.sysname, machine.release, machine.machine)},
           {"cores", std::to_string(cores())},
           {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))}}};
}

}  // namespace ricochet::cli
