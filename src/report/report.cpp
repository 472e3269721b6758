#include "src/report/report.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "embedded/template_advice.h"
#include "embedded/template_calibration.h"
#include "embedded/template_contest.h"
#include "embedded/template_contest_failures.h"
#include "embedded/template_contest_family.h"
#include "embedded/template_contest_machines.h"
#include "embedded/template_dynamics.h"
#include "embedded/template_family.h"
#include "embedded/template_fireworks.h"
#include "embedded/template_limits.h"
#include "embedded/template_problems.h"
#include "embedded/template_reproduction.h"
#include "embedded/template_stress.h"
#include "embedded/template_surrogate.h"
#include "embedded/template_trials.h"
#include "embedded/template_verification.h"
#include "src/core/error.h"
#include "src/report/data_text.h"
#include "src/report/page_template.h"

namespace ricochet::report {
namespace {

constexpr std::pair<std::string_view, const char*> templates[] = {
    {"advice", embedded::template_advice},
    {"calibration", embedded::template_calibration},
    {"contest", embedded::template_contest},
    {"contest_failures", embedded::template_contest_failures},
    {"contest_family", embedded::template_contest_family},
    {"contest_machines", embedded::template_contest_machines},
    {"dynamics", embedded::template_dynamics},
    {"family", embedded::template_family},
    {"fireworks", embedded::template_fireworks},
    {"limits", embedded::template_limits},
    {"problems", embedded::template_problems},
    {"reproduction", embedded::template_reproduction},
    {"stress", embedded::template_stress},
    {"surrogate", embedded::template_surrogate},
    {"trials", embedded::template_trials},
    {"verification", embedded::template_verification},
};

constexpr const char* data_file = "data.json";

std::string write_kept(const Json& computed, const std::filesystem::path& folder) {
  const std::string sheet = page_template(computed.at("report").get<std::string>());
  const std::string text = data_text(computed, kept_digits(sheet));
  // What is drawn is what was kept: the data as they are read back, not as they were computed.
  DrawnPage drawing = drawn(sheet, data_in(text));
  FileSet files = std::move(drawing.tables);
  files[data_file] = text;
  write_page(drawing.page, folder, std::move(files));
  return drawing.epilogue;
}

}  // namespace

std::string write_report(Json data, const std::filesystem::path& folder) {
  if (data.contains("pages")) {
    for (Json& page : data["pages"]) {
      const std::string name = page.at("folder").get<std::string>();
      write_report(std::move(page.at("data")), folder / name);
      page = name;
    }
  }
  return write_kept(data, folder);
}

std::string redraw_report(const std::filesystem::path& from, const std::filesystem::path& folder) {
  const std::filesystem::path file = from / data_file;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(
        fmt::format("{}: cannot be read: must be the data of a report", file.string()));
  }
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  try {
    const Json data = data_in(text);
    for (const Json& name : data.value("pages", Json::array())) {
      redraw_report(from / name.get<std::string>(), folder / name.get<std::string>());
    }
    return write_kept(data, folder);
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: must be the data of a report: {}", file.string(), error.what()));
  }
}

std::string page_template(const std::string& name) {
  std::string known;
  for (const auto& [own, text] : templates) {
    if (own == name) return text;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", own);
  }
  throw InputError(fmt::format("report \"{}\": there is no such report; allowed: {}", name, known));
}

}  // namespace ricochet::report
