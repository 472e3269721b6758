#include "src/site/site.h"

#include <fstream>
#include <system_error>

#include "src/report/file_set.h"
#include "src/report/report.h"
#include "src/site/answers.h"
#include "src/site/card.h"
#include "src/site/competitors.h"
#include "src/site/front_page.h"
#include "src/site/motion.h"
#include "src/site/navigation.h"
#include "src/site/pairs.h"
#include "src/site/questions.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

constexpr const char* data_file = "data.json";

Json collected(const std::vector<FoundReport>& reports) {
  return {{"report", "site"},
          {"speed", speed_answer(reports)},
          {"machines", machine_answers(reports)},
          {"solvers", solver_answer(reports)},
          {"contest", contest_data(reports)},
          {"motion", motion_data(reports)},
          {"pairs", pairs_data(reports)},
          {"questions", questions_data(reports)},
          {"cards", report::list_of(reports, card_of)},
          {"missing", missing_cards(reports)}};
}

/// Without the dots and the slash at its end, so that it has a name and a folder above.
fs::path plain(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

bool is_site(const fs::path& folder) {
  if (plain(folder).filename() == "reports") return true;
  std::ifstream stream(folder / data_file, std::ios::binary);
  if (!stream) return false;
  const Json data = Json::parse(stream, nullptr, false);
  return data.is_object() && data.value("report", "") == "site";
}

void write_site(const fs::path& folder) {
  const std::vector<FoundReport> reports = found_reports(folder);
  const Json data = collected(reports);
  report::FileSet files = front_page(data, navigation(reports, ""));
  files[data_file] = data.dump() + "\n";
  report::replace_files(folder, files);
  link_pages(folder, reports);
}

void write_site_above(const fs::path& report) {
  const fs::path above = plain(report).parent_path();
  if (is_site(above)) write_site(above);
}

bool redraw_site(const fs::path& from, const fs::path& folder) {
  std::error_code none;
  if (fs::exists(from / data_file, none) && !is_site(from)) return false;
  const std::vector<FoundReport> reports = found_reports(from);
  if (reports.empty()) return false;
  for (const FoundReport& report : reports) {
    report::redraw_report(from / report.folder, folder / report.folder);
  }
  write_site(folder);
  return true;
}

}  // namespace ricochet::site
