#include "src/cli/list.h"

#include <fmt/format.h>

#include <vector>

#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/families.h"
#include "solvers/solvers.h"
#include "src/cli/format.h"
#include "src/core/error.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

Json cases() {
  Json rows = Json::array();
  for (const Case& c : all_cases()) {
    rows.push_back({{"case", c.id},
                    {"restitution", c.restitution},
                    {"friction", c.friction},
                    {"disturbance", c.disturbance},
                    {"paper_threshold", json_of(c.claim.threshold)},
                    {"paper_quiet_count", json_of(c.claim.quiet_count)}});
  }
  return rows;
}

Json questions(const std::string& scene_file) {
  Json rows = Json::array();
  for (const Family& family : all_families(scene_file)) {
    for (const Question& q : family.questions) {
      Json forms = Json::array();
      bool derivatives = false;
      for (const Form& form : q.forms()) {
        forms.push_back(q.name_of(form));
        derivatives = derivatives || q.problem(form).differentiate;
      }
      rows.push_back({{"question", q.name()},
                      {"dimension", q.stated.dimension()},
                      {"constraints", q.stated.constraints},
                      {"equalities", q.stated.equalities},
                      {"forms", forms},
                      {"derivatives", derivatives},
                      {"best_known", json_of(q.stated.best_known)},
                      {"source", q.stated.source}});
    }
  }
  return rows;
}

Json solvers() {
  Json rows = Json::array();
  for (const Solver& s : all_solvers()) {
    rows.push_back({{"solver", s.name}, {"version", s.version}, {"stochastic", s.stochastic}});
  }
  for (const MissingSolver& missing : missing_solvers()) {
    rows.push_back({{"solver", missing.solver},
                    {"version", fmt::format("missing: built without {}", missing.library)},
                    {"stochastic", nullptr}});
  }
  return rows;
}

Json readings() {
  Json rows = Json::array();
  const auto add = [&rows](const Reading& r) {
    rows.push_back({{"reading", name_of(r)},
                    {"constants", open_of(r).size()},
                    {"default", r == default_reading().reading},
                    {"description", description_of(r)}});
  };
  for (const Reading& core : core_readings()) {
    add(core);
    for (const Reading& r : variations(core)) add(r);
  }
  return rows;
}

/// A cell as text: strings without quotes, lists without brackets, missing values as a dash.
std::string cell(const Json& value) {
  if (value.is_array())
    return fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), " "));
  if (value.is_string()) return value.get<std::string>();
  return value.is_null() ? "-" : value.dump();
}

void print_table(const Json& rows) {
  std::vector<std::string> keys;
  std::vector<std::size_t> widths;
  for (const auto& [key, value] : rows.front().items()) {
    std::size_t width = key.size();
    for (const Json& row : rows) width = std::max(width, cell(row[key]).size());
    keys.push_back(key);
    widths.push_back(width);
  }
  const auto print_line = [&](auto text) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const bool last = i + 1 == keys.size();
      fmt::print("{:<{}}{}", text(keys[i]), last ? 0 : widths[i], last ? "\n" : "  ");
    }
  };
  print_line([](const std::string& key) { return key; });
  for (const Json& row : rows) {
    print_line([&row](const std::string& key) { return cell(row[key]); });
  }
}

}  // namespace

int list(const std::string& what, const std::string& scene_file, bool json) {
  const bool asks = what == "questions" || what == "problems";
  if (!scene_file.empty() && !asks) {
    throw InputError(fmt::format("--scene: has questions alone, not {}", what));
  }
  const Json rows = what == "cases"     ? cases()
                    : asks              ? questions(scene_file)
                    : what == "solvers" ? solvers()
                                        : readings();
  if (json) {
    fmt::print("{}\n", rows.dump(2));
  } else {
    print_table(rows);
  }
  return 0;
}

}  // namespace ricochet::cli
