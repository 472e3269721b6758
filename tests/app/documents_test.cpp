#include <regex>

#include "problems/carrier_track/scene/scene_fields.h"
#include "src/experiment/plan.h"
#include "tests/app/tool.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

/// What the documents say of machine files and plans.
namespace ricochet::cli {
namespace {

/// A row of the table of the scene's keys; its cells after the keys.
struct KeyRow {
  std::string unit, allowed, missing;
};

const std::string page_of_machines = RICOCHET_SOURCE "/docs/machine-files.md";

/// The rows by table and key, such as "scene.mass".
std::map<std::string, KeyRow> rows_of_scene_keys() {
  static const std::regex heading(R"([|] [*][*]\[([a-z]+)\].*)"), named_key("`([^`]+)`");
  static const std::regex cells(
      R"([|] (`[^|]*?) *[|] *([^|]*?) *[|] *([^|]*?) *[|] *([^|]*?) *[|])");
  std::map<std::string, KeyRow> rows;
  std::string table;
  for (const std::string& line : lines_of(read(page_of_machines))) {
    std::smatch found;
    if (line.empty()) table.clear();
    if (std::regex_match(line, found, heading)) table = found[1];
    if (table.empty() || !line.starts_with("| `")) continue;
    if (!std::regex_match(line, found, cells)) throw std::runtime_error("no four cells: " + line);
    const std::string keys = found[1];
    for (std::sregex_iterator key(keys.begin(), keys.end(), named_key), end; key != end; ++key) {
      rows[table + "." + (*key)[1].str()] = {found[2], found[3], found[4]};
    }
  }
  return rows;
}

TEST(MachineFiles, DocumentEveryUnit) {
  const std::string page = read(page_of_machines);
  for (const char* unit : {"m", "m/s", "kg", "kg m", "N", "s", "rad", "rad/s"}) {
    std::string row = fmt::format("| {} |", unit);
    for (const std::string_view name : units_for(unit)) {
      row += fmt::format("{}`{}`", row.ends_with('|') ? " " : ", ", name);
    }
    EXPECT_THAT(page, testing::HasSubstr(row + " |\n"));
  }
}

TEST(MachineFiles, DocumentEveryFieldOfAScene) {
  const std::map<std::string, KeyRow> rows = rows_of_scene_keys();
  // What the list of fields has not as keys of their own: the window, one restitution a wall, and
  // another way to give a field.
  std::set<std::string> keys = {"scene.path_radius",       "window.revolutions",
                                "window.seconds",          "scene.restitution_lower",
                                "scene.restitution_upper", "across.restitution_lower",
                                "across.restitution_upper"};
  const auto expect_row_in = [&](const std::string& table) {
    return [&rows, &keys, table](const carrier_track::SceneField& field) {
      const std::string key = fmt::format("{}.{}", table, field.key);
      keys.insert(key);
      ASSERT_TRUE(rows.contains(key)) << key;
      KeyRow row = rows.at(key);
      if (row.allowed == "as in [scene]") row = rows.at(fmt::format("scene.{}", field.key));
      const std::string unit(field.unit == "1" ? "" : field.unit);
      EXPECT_THAT(row.unit, testing::StartsWith(unit)) << key;
      EXPECT_EQ(row.unit.empty(), unit.empty()) << key;
      if (field.key != "wall_lower") {  // whose row is that of both walls
        const bool is_finite = field.range == carrier_track::ranges::finite;
        const std::string allowed(is_finite ? "finite" : field.range.brief);
        EXPECT_THAT(row.allowed, testing::HasSubstr(allowed)) << key;
      }
      EXPECT_EQ(row.missing.starts_with("must be given"), field.presence == Presence::required)
          << key;
    };
  };
  carrier_track::visit_scene_fields(expect_row_in("scene"));
  expect_row_in("scene")(carrier_track::path_radius);
  carrier_track::visit_across_fields(expect_row_in("across"));
  carrier_track::visit_count_fields(expect_row_in("count"));
  carrier_track::visit_model_fields(expect_row_in("model"));
  std::set<std::string> documented;
  for (const auto& [key, row] : rows) documented.insert(key);
  EXPECT_EQ(documented, keys);
}

/// The keys that a table may have: those that the refusal of another one lists.
std::vector<std::string> keys_beside(const std::string& unknown_key) {
  static const std::regex word("[a-z_]+");
  const std::string said = complaint_of([&] { return plan_from(unknown_key, "a plan"); });
  const std::size_t list = said.find("allowed: ");
  if (list == std::string::npos) return {};
  const std::string keys = said.substr(list + 9);
  return {std::sregex_token_iterator(keys.begin(), keys.end(), word), {}};
}

TEST(PlanFiles, HaveEveryKeyInTheirTemplate) {
  const std::string page = read(RICOCHET_SOURCE "/src/app/plan_template.toml");
  const std::string other = "qqqqqqqq = 1";
  for (const auto& [table, least] :
       {std::pair("", 6U), std::pair("[limits]\n", 2U), std::pair("[[solver]]\n", 3U),
        std::pair("[[scene]]\n", 3U), std::pair("[[part]]\n", 15U)}) {
    const std::vector<std::string> keys = keys_beside(table + other);
    EXPECT_GE(keys.size(), least) << table;
    for (const std::string& key : keys) {
      const auto has = [&](const std::string& text) {
        return page.find(text) != std::string::npos;
      };
      EXPECT_TRUE(has(" " + key + " =") || has("\n" + key + " =") || has("[" + key + "]"))
          << table << key;
    }
  }
}

}  // namespace
}  // namespace ricochet::cli
