#include "src/studies/study.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "src/core/folder_lock.h"
#include "src/report/report.h"

namespace ricochet::studies {
namespace {

#ifdef __clang__
constexpr const char* compiler = "Clang " __VERSION__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

}  // namespace

Finished run(const Study& study, bool quick, const std::filesystem::path& folder) {
  const FolderLock alone(folder);
  const auto start = std::chrono::steady_clock::now();
  report::Json results = study.compute(quick);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  report::Json data = {{"report", study.name},
                       {"made",
                        {{"version", RICOCHET_VERSION},
                         {"compiler", compiler},
                         {"threads", std::thread::hardware_concurrency()},
                         {"seconds", elapsed.count()},
                         {"quick", quick}}}};
  data.update(results);
  std::string epilogue = report::write_report(data, folder);
  if (!epilogue.empty()) epilogue += "\n";
  epilogue +=
      fmt::format("The report: {}\n",
                  (std::filesystem::absolute(folder) / "index.html").lexically_normal().string());
  return {std::move(data), std::move(epilogue)};
}

}  // namespace ricochet::studies
