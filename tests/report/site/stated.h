#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/report/report.h"
#include "src/report/results.h"
#include "src/report/text.h"

/// What README and the documents state, and the committed reports that it must be found in.
namespace ricochet::site {

inline std::string repository_text(const std::string& file) {
  std::ifstream stream(std::filesystem::path(RICOCHET_SOURCE) / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A committed report. Throws std::logic_error for what it does not have.
class Committed {
 public:
  explicit Committed(const std::string& folder)
      : results_(report::results_of(
            report::data_in(repository_text("reports/reference/" + folder + "/data.json")))) {}

  double value(const char* name) const {
    const Value* found = results_.value(name);
    if (found == nullptr || !number_in(*found)) throw std::logic_error(name);
    return *number_in(*found);
  }
  std::string text(const char* name) const { return ricochet::text_of(*results_.value(name)); }
  const ricochet::Table& table(const char* name) const {
    if (const ricochet::Table* found = results_.table(name)) return *found;
    throw std::logic_error(name);
  }
  Row row(const char* name, const std::function<bool(const Row&)>& is_it) const {
    if (const auto found = table(name).find(is_it)) return *found;
    throw std::logic_error(name);
  }
  /// The row whose first column is this.
  Row row(const char* name, const std::string& first) const {
    const std::string& column = table(name).columns.front().name;
    return row(name, [&](const Row& row) { return row.text(column) == first; });
  }
  /// A point of a curve.
  double at(const char* chart, const std::string& curve, double position) const {
    for (const report::Series& series : results_.chart(chart)->series) {
      if (!series.label.starts_with(curve)) continue;
      for (const report::Sample& sample : series.samples)
        if (std::abs(sample.position - position) < 1e-9) return *sample.value;
    }
    throw std::logic_error(curve);
  }

 private:
  report::Results results_;
};

/// A text. What is found in it is taken out, so that numbers are left over which nothing states.
class Prose {
 public:
  explicit Prose(const std::string& text) {
    static const std::regex code("```[^]*?```|<!--[^]*?-->"), space("\\s+");
    text_ = std::regex_replace(std::regex_replace(text, code, ""), space, " ");
  }

  /// Expects it in the text.
  void states(const std::string& sentence) {
    const std::size_t found = text_.find(sentence);
    EXPECT_NE(found, std::string::npos) << "not stated: " << sentence;
    if (found != std::string::npos) text_.erase(found, sentence.size());
  }

  /// Numbers that are left, but for those of cases and in code and links.
  std::string numbers_left() const { return left("[0-9]+(\\.[0-9]+)?"); }

  /// Numbers that look like results: shares, decimals, "3 of 4", but for 95 %, and powers of ten.
  std::string figures_left() const {
    return left("[0-9]+(\\.[0-9]+)? %|[0-9]+ of (the )?[0-9]+|[0-9]+\\.[0-9]+");
  }

 private:
  std::string left(const char* pattern) const {
    static const std::regex named(
        "`[^`]*`|\\]\\([^)]*\\)|C[0-9]+|[0-9.]+e-?[0-9]+|[0-9]+\\.[0-9]+\\.[0-9]+");
    const std::string rest =
        std::regex_replace(std::regex_replace(text_, named, ""), std::regex("95 %"), "");
    std::string all;
    const std::regex number(pattern);
    for (std::sregex_iterator it(rest.begin(), rest.end(), number), end; it != end; ++it)
      all += it->str() + " ";
    return all;
  }

  std::string text_;
};

/// A part of a file, from one text to another.
inline Prose part_of(const std::string& file, const std::string& from, const std::string& to) {
  const std::string all = repository_text(file);
  const std::size_t start = all.find(from), end = all.find(to, start);
  if (start == std::string::npos || end == std::string::npos) throw std::logic_error(from);
  return Prose(all.substr(start, end - start));
}

/// The error of the fit with its interval: "6 % (95 % interval 3 to 8 %)".
inline std::string error_of_the_fit() {
  const Committed calibration("calibration");
  const Row fit = calibration.row("left-out", "in the fit");
  return fmt::format("{:.0f} % (95 % interval {:.0f} to {:.0f} %)", 100 * fit.number("error"),
                     100 * fit.number("lower"), 100 * fit.number("upper"));
}

}  // namespace ricochet::site
