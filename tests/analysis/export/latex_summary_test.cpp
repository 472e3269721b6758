#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/analysis/export/rated.h"

namespace ricochet::exports {
namespace {

using comparison::RatedFamily;
using testing::HasSubstr;
using testing::Not;

using LatexSummary = ExportedStore;

int rows_in(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  return static_cast<int>(std::ranges::count_if(
             lines, [](const std::string& line) { return line.ends_with(" \\\\"); })) -
         1;  // the header
}

TEST_F(LatexSummary, HasTheRankedEntriesOfEachFamily) {
  write_latex_summary({rated("top_speed", 2)}, out);
  const std::string text = text_of(out / "summary.tex");
  EXPECT_THAT(text, HasSubstr("\ntop\\_speed & 2 & 100 & solver\\_0, original & 100 & 1.2 & 0.75 "
                              "\\\\\n &  &  & solver\\_1, original & 50 & 2.2 & 0.12 \\\\\n"));
  EXPECT_THAT(text, Not(HasSubstr("solver\\_2"))) << "it is not ranked";
}

TEST_F(LatexSummary, HasNoFirstEntryThatSolvedNoRun) {
  RatedFamily some = rated("some", 2);
  some.ratings[0].returned = 0;
  RatedFamily none = rated("none", 2);
  for (comparison::Rating& rating : none.ratings) rating.returned = 0;
  write_latex_summary({some, none}, out);
  const std::string text = text_of(out / "summary.tex");
  EXPECT_THAT(text, HasSubstr("\nsome & 2 & 100 & solver\\_1, original & 50 & 2.2 & 0.12 \\\\\n"
                              "none & 2 & 100 & no run is solved &  &  &  \\\\\n"));
}

TEST_F(LatexSummary, HasAsManyRowsAsAPageHolds) {
  for (const int families : {1, 4, 13}) {
    const auto folder = made(out / std::to_string(families));
    write_latex_summary(std::vector<RatedFamily>(families, rated("count", 60)), folder);
    EXPECT_EQ(rows_in(text_of(folder / "summary.tex")), 45 / families * families);
  }
}

/// Names too long for the page, and as many rows as it may have.
TEST_F(LatexSummary, FitsAPage) {
  if (std::system("pdflatex --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "needs pdflatex";
  RatedFamily family = rated("a family & its long name", 50);
  family.ratings[0].solver =
      "python3 an/own/solver/of/a/very/long_name.py --with=options,-of-its-own";
  family.ratings[0].formulation = "penalised-surrogate";
  write_latex_summary({family}, out);
  std::ofstream(out / "page.tex")
      << "\\documentclass[a4paper]{article}\n\\usepackage{booktabs}\n\\usepackage{graphicx}\n"
         "\\usepackage{textcomp}\n\\usepackage[T1]{fontenc}\n\\begin{document}\n"
         "\\input{summary.tex}\n\\end{document}\n";
  const int status =
      std::system(fmt::format("cd '{}' && pdflatex -interaction=batchmode page.tex >/dev/null 2>&1",
                              out.string())
                      .c_str());
  const std::string log = text_of(out / "page.log");
  EXPECT_EQ(status, 0) << log;
  EXPECT_THAT(log, HasSubstr("page.pdf (1 page"));
  EXPECT_THAT(log, Not(HasSubstr("Overfull")));
  EXPECT_THAT(log, Not(HasSubstr("Float too large")));
}

}  // namespace
}  // namespace ricochet::exports
