#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "ricochet/error.h"
#include "src/cli/commands.h"
#include "src/core/one_line.h"
#include "src/report/site/publication.h"

namespace ricochet::cli {
namespace {

struct SiteOptions {
  std::string from = "reports/reference";
  std::string out;
};

int write_site(const SiteOptions& options) {
  const site::Publication written = site::publish_site(options.from, options.out);
  const auto page = (std::filesystem::absolute(options.out) / "index.html").lexically_normal();
  fmt::print("The site: {}\n{} pages, {:.1f} MB\n", one_line(page.string()), written.pages,
             static_cast<double>(written.bytes) / 1e6);
  if (!written.failures.empty()) {
    throw InputError(fmt::format("{}", fmt::join(written.failures, "; ")));
  }
  return 0;
}

}  // namespace

void add_site(CommandLine& line) {
  CLI::App* command =
      line.add("site", "Write all reports and documents as a site for a static host",
               "  ricochet site --out pages\n"
               "  ricochet site reports --out pages");
  const auto options = std::make_shared<SiteOptions>();
  command->add_option("folder", options->from, "Folder of the reports")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_option("--out", options->out, "Folder for the site: new, empty or an earlier site")
      ->type_name("FOLDER")
      ->required();
  line.on_call(command, [options] { return write_site(*options); });
}

}  // namespace ricochet::cli
