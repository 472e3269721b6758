#include "src/cli/site.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "ricochet/error.h"
#include "src/core/one_line.h"
#include "src/report/site/publication.h"

namespace ricochet::cli {

int write_site(const std::string& from, const std::string& out) {
  const site::Publication written = site::publish_site(from, out);
  const auto page = (std::filesystem::absolute(out) / "index.html").lexically_normal();
  fmt::print("The site: {}\n{} pages, {:.1f} MB\n", one_line(page.string()), written.pages,
             static_cast<double>(written.bytes) / 1e6);
  if (!written.failures.empty()) {
    throw InputError(fmt::format("{}", fmt::join(written.failures, "; ")));
  }
  return 0;
}

}  // namespace ricochet::cli
