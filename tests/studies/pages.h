#pragma once

#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/support/test.h"

namespace ricochet::studies {

/// The row of a table whose column is this text.
inline Row row_of(const Table& table, const char* column, const std::string& text) {
  const auto row = table.find([&](const Row& each) { return each.text(column) == text; });
  if (!row) throw std::out_of_range(text);
  return *row;
}

struct StudyPage {
  std::map<std::string, std::string> files;
  std::string terminal;  ///< what ends the command
};

/// The page of a study, of results to which every study adds how they were made. Expects every
/// chart to be drawn.
inline StudyPage study_page(const std::string& name, report::Results results) {
  for (const char* what : {"version", "compiler", "threads", "seconds", "date"})
    results.set(std::string("made.") + what, 2.0);
  for (const report::Chart& chart : results.charts) EXPECT_NO_THROW(check(chart)) << chart.name;
  const report::PageSource source = report::page_source(report::page_template(name));
  const auto [files, failures] = page_files(source, results);
  EXPECT_THAT(failures, IsEmpty());
  return {{files.begin(), files.end()}, terminal_text(source, results)};
}

}  // namespace ricochet::studies
