#include "src/report/site/study.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include "src/core/files.h"
#include "src/core/names.h"
#include "src/report/report.h"
#include "src/report/site/site.h"

namespace ricochet::studies {

namespace {

#ifdef __clang__
constexpr const char* compiler = "Clang " __VERSION__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

/// Number of cores that this process may use.
int cores() {
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0
             ? CPU_COUNT(&allowed)
             : static_cast<int>(std::thread::hardware_concurrency());
}

/// What the system calls the processor; "" where it does not say.
std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("model name"))
      return line.substr(std::min(line.find(": ") + 2, line.size()));
  }
  return "";
}

}  // namespace

Finished run(const Study& study, bool quick, const std::filesystem::path& folder,
             std::chrono::steady_clock::time_point start) {
  const FolderLock alone(folder);
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  report::Json results = study.compute(quick);
  report::Json data = {{"report", study.name},
                       {"made",
                        {{"version", RICOCHET_VERSION},
                         {"compiler", compiler},
                         {"threads", cores()},
                         {"processor", processor()},
                         {"seconds", elapsed()},
                         {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))},
                         {"quick", quick}}}};
  data.update(results);
  auto [epilogue, failures] = report::write_report(data, folder);
  const std::vector<std::string> above = site::write_site_above(folder, site::reference_folder());
  failures.insert(failures.end(), above.begin(), above.end());
  if (!epilogue.empty() && !epilogue.ends_with('\n')) epilogue += "\n";
  const auto page = (std::filesystem::absolute(folder) / "index.html").lexically_normal();
  epilogue +=
      fmt::format("It took {:.1f} s.\nThe report: {}\n", elapsed(), one_line(page.string()));
  return {std::move(data), std::move(epilogue), std::move(failures)};
}

}  // namespace ricochet::studies
