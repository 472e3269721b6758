#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/report/report.h"
#include "src/report/text.h"

/// Every number of every committed page stands in the data beside it, or in the template's own
/// words.
namespace ricochet::site {
namespace {

namespace fs = std::filesystem;
using report::Json;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The numbers of a text, as they are written. A hyphen between words is no minus.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number("[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) {
    found.push_back(it->str());
  }
  return found;
}

/// What may be written.
class Known {
 public:
  explicit Known(const Json& data) { add(data); }

  void add(const std::string& text) {
    for (std::string& number : numbers_in(text)) written_.insert(std::move(number));
  }

  /// To be called once all is added.
  void sort() { std::sort(sizes_.begin(), sizes_.end()); }

  /// Whether the number is one of them, rounded to its last digit; signs are left out.
  bool has(const std::string& number) const {
    if (written_.contains(number)) return true;
    const auto exponent_at = number.find('e');
    const int exponent =
        exponent_at == std::string::npos ? 0 : std::stoi(number.substr(exponent_at + 1));
    const std::string mantissa = number.substr(0, exponent_at);
    const auto point = mantissa.find('.');
    const auto decimals =
        point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    const double value = std::stod(number);
    const double off = 0.5000001 * std::pow(10.0, exponent - decimals);
    const auto next = std::lower_bound(sizes_.begin(), sizes_.end(), value - off);
    return next != sizes_.end() && *next <= value + off;
  }

 private:
  void add(const Json& data) {
    if (data.is_string()) add(data.get_ref<const std::string&>());
    if (data.is_number()) {
      const double size = std::abs(data.get<double>());
      sizes_.insert(sizes_.end(), {size, 100 * size});  // shares are shown as hundredths
    }
    if (data.is_array()) sizes_.push_back(static_cast<double>(data.size()));
    if (!data.is_structured()) return;
    for (const auto& [key, value] : data.items()) {
      add(key);
      add(value);
    }
  }

  std::set<std::string> written_;
  std::vector<double> sizes_;
};

std::vector<std::string> unknown_numbers(const std::string& page, const Json& data,
                                         const std::string& page_template) {
  Known known(data);
  known.add(page_template);
  known.sort();
  std::vector<std::string> unknown;
  // The escapes and links of Markdown are no numbers that are shown.
  static const std::regex link("\\]\\([^)]*\\)|&#[0-9]+;");
  for (const std::string& number : numbers_in(std::regex_replace(page, link, "]"))) {
    if (!known.has(number)) unknown.push_back(number);
  }
  return unknown;
}

std::vector<fs::path> reports() {
  std::vector<fs::path> folders;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(RICOCHET_SOURCE) / "reports/reference")) {
    if (entry.path().filename() == "data.json") folders.push_back(entry.path().parent_path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

TEST(Numbers, OfEveryPageStandInTheDataBesideIt) {
  int pages = 0;
  for (const fs::path& folder : reports()) {
    const Json data = report::data_in(read(folder / "data.json"));
    const std::string kind = data.at("report");
    if (kind == "site") continue;  // its data are of the other reports
    Json known = data;  // and how it was made, which the report above a further page says
    const std::string above = read(folder.parent_path() / "data.json");
    if (!above.empty()) known["above"] = report::data_in(above).value("made", Json());
    const auto unknown =
        unknown_numbers(read(folder / "summary.md"), known, report::page_template(kind));
    std::string all;
    for (const std::string& number : unknown) all += number + " ";
    EXPECT_EQ(all, "") << folder;
    ++pages;
  }
  EXPECT_GT(pages, 15);
}

/// The text with one blank for each run of blanks and ends of lines.
std::string on_one_line(const std::string& text) {
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

/// Occurrences of a percentage without what has to follow it.
int bare(const std::string& text, const std::string& percentage, const std::string& follows) {
  int count = 0;
  for (auto at = text.find(percentage); at != std::string::npos;
       at = text.find(percentage, at + 1)) {
    const bool is_end_of_another =
        at > 0 &&
        (std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '.');
    const bool has = text.compare(at + percentage.size(), follows.size(), follows) == 0;
    count += is_end_of_another || has ? 0 : 1;
  }
  return count;
}

TEST(Numbers, OfTheFitHaveTheirIntervalWhereverTheyStand) {
  const fs::path source = RICOCHET_SOURCE;
  const report::Results results =
      report::results_of(report::data_in(read(source / "reports/reference/calibration/data.json")));
  const Table& table = *results.table("left-out");
  const Row fit =
      table.find([](const Row& row) { return row.text("fit") == "in the fit"; }).value();
  const auto percent = [&](const char* column) { return 100 * fit.number(column); };
  const std::string error = fmt::format("{:.0f} %", percent("error"));
  const std::string interval =
      fmt::format(" (95 % interval {:.0f} to {:.0f} %)", percent("lower"), percent("upper"));
  for (const char* file :
       {"README.md", "docs/paper.md", "docs/tutorial.md", "reports/reference/summary.md",
        "reports/reference/reproduction/summary.md"}) {
    std::string text = on_one_line(read(source / file));
    // The error of the formula of one line, not that of the fit.
    text = std::regex_replace(text, std::regex("misses them by [0-9]+ %"), "");
    EXPECT_NE(text.find(error + interval), std::string::npos) << file;
    EXPECT_EQ(bare(text, error, interval), 0) << file << ": " << error << " without its interval";
  }
  EXPECT_EQ(bare("16 % 0.6 % 6 % (a) 6 % b", "6 %", " (a)"), 1);
}

TEST(Numbers, ThatAreNotInTheDataAreFound) {
  const Json data = {{"speed", 8.2749}, {"share", 0.0625}, {"name", "C12"}, {"cost", -12345.0}};
  const auto unknown = [&](const char* page) { return unknown_numbers(page, data, "step 0.001"); };
  EXPECT_TRUE(unknown("8.27 rad/s, 8.275, 6.25 %, 6 %, C12, -1.23e+04, steps of 0.001").empty());
  EXPECT_EQ(unknown("8.28 rad/s"), std::vector<std::string>{"8.28"});
  EXPECT_EQ(unknown("7 %, C13"), (std::vector<std::string>{"7", "13"}));
  EXPECT_EQ(unknown("1.24e+04"), std::vector<std::string>{"1.24e+04"});
}

}  // namespace
}  // namespace ricochet::site
