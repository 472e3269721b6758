#include "src/cli/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "ricochet/error.h"
#include "src/core/folder_lock.h"
#include "src/core/one_line.h"
#include "src/report/json.h"
#include "src/report/report.h"
#include "src/report/site/site.h"

namespace ricochet::cli {
namespace {

/// Says what it has drawn. Returns a line, which begins with a file, for all that could not be
/// drawn.
std::vector<std::string> drawn_again(const std::string& from, const std::string& out) {
  const std::string page =
      one_line((std::filesystem::absolute(out) / "index.html").lexically_normal().string());
  if (const auto failures = site::redraw_site(from, out)) {
    fmt::print("The reports: {}\n", page);
    return *failures;
  }
  std::vector<std::string> failures = report::redraw_report(from, out).failures;
  const std::vector<std::string> above = site::write_site_above(out);
  failures.insert(failures.end(), above.begin(), above.end());
  fmt::print("The report: {}\n", page);
  return failures;
}

}  // namespace

int draw_again(const std::string& from, const std::string& out) {
  const std::string& folder = out.empty() ? from : out;
  const FolderLock alone(folder);
  std::vector<std::string> failures;
  try {
    failures = drawn_again(from, folder);
  } catch (const std::logic_error& error) {  // the data do not fit the template
    const std::string reason = error.what();
    throw InputError(reason.starts_with(from) ? reason : from + ": " + reason);
  } catch (const report::Json::exception& error) {
    throw InputError(fmt::format("{}: is no data of a report: {}", from, error.what()));
  }
  if (!failures.empty()) throw InputError(fmt::format("{}", fmt::join(failures, "; ")));
  return 0;
}

}  // namespace ricochet::cli
