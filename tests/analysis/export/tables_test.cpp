#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

using comparison::RatedFamily;
using testing::SizeIs;

/// For each line that is a row, how often `bar` separates its cells: it may be escaped.
std::vector<std::size_t> separators_in(const std::string& text, char bar,
                                       bool (*is_row)(const std::string& line)) {
  std::vector<std::size_t> numbers;
  for (const std::string& line : lines_of(text)) {
    if (!is_row(line)) continue;
    numbers.push_back(0);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == bar && (i == 0 || line[i - 1] != '\\')) ++numbers.back();
    }
  }
  return numbers;
}

bool is_latex_row(const std::string& line) {
  return line.ends_with(" \\\\");
}

using Tables = ExportedStore;

TEST_F(Tables, HaveARowForEveryCell) {
  add_worked_cell("*[a*");
  write_latex(store, {}, out);
  const std::string latex = text_of(out / "table.tex");
  constexpr std::size_t cells = 4 * 3 * 2 * 2 + 1;
  EXPECT_THAT(separators_in(latex, '&', is_latex_row), AllOf(SizeIs(cells + 2), Each(11)))
      << "and the header, for the first page and the others";
  EXPECT_THAT(latex, HasSubstr("a\\textbar{}b\\_c\\%d\\{e\\}\\textbackslash{}f\\#g\\$h\\&i"
                               "\\textasciitilde{}j\\textasciicircum{}k-{}-l & original"));
  EXPECT_THAT(
      lines_of(latex),
      Contains(AllOf(StartsWith("profile/5 & nlopt-cobyla & {*}{[}a{*} & plain & n & 7 & 4 & "
                                "50 & 15 to 85 & 14 & "),
                     EndsWith(" & 1 \\\\"))));
  write_markdown(store, {}, out);
  const std::string markdown = text_of(out / "table.md");
  const auto is_row = [](const std::string& line) { return line.starts_with("| "); };
  EXPECT_THAT(separators_in(markdown, '|', is_row), AllOf(SizeIs(cells + 1), Each(13)))
      << "and the header";
  EXPECT_THAT(lines_of(markdown),
              Contains(AllOf(StartsWith("| profile/5 | nlopt-cobyla | \\*[a\\* | plain | n | 7 | 4 "
                                        "| 50 | 15 to 85 | 14 | "),
                             EndsWith(" | 1 |"))));
}

/// A family of two problems with so many ranked entries, and one that is not ranked.
RatedFamily rated(const std::string& family, int entries) {
  RatedFamily made{family, 2, 100, {}, {}};
  for (int k = 0; k <= entries; ++k) {
    comparison::Rating& rating = made.ratings.emplace_back();
    rating.solver = "solver_" + std::to_string(k);
    rating.formulation = "original";
    rating.problems = k < entries ? 2 : 0;
    rating.returned = 1.0 / (k + 1);
    rating.found = 1;
    rating.progress = {{1, 0.25, {0.1, 0.5}}, {100, 0.5, {0.2, 0.8}}};
    if (k == entries) continue;
    rating.rank = k + 1.25;
    rating.probability_of_being_best = k == 0 ? 0.75 : 0.125;
  }
  made.targets["hs-1"] = std::make_shared<const comparison::Targets>(comparison::Targets{0.5, 1.5});
  return made;
}

using RatingsCsv = ExportedStore;

TEST_F(RatingsCsv, HaveARowForEveryFamilyAndEntry) {
  write_ratings({rated("count", 1), rated("nan", 2)}, out);
  EXPECT_THAT(lines_of(text_of(out / "ratings.csv")),
              ElementsAre("family,problems,budget_per_variable,solver,formulation,problems_taken,"
                          "problems_never_solved,solved_share,returned_solved_share,mean_rank,"
                          "probability_of_being_best",
                          "count,2,100,solver_0,original,2,0,1,1,1.25,0.75",
                          "count,2,100,solver_1,original,0,0,1,0.5,,",
                          "missing-value,2,100,solver_0,original,2,0,1,1,1.25,0.75",
                          "missing-value,2,100,solver_1,original,2,0,1,0.5,2.25,0.125",
                          "missing-value,2,100,solver_2,original,0,0,1,0.3333333333333333,,"));
  EXPECT_THAT(lines_of(text_of(out / "ecdf.csv")),
              AllOf(SizeIs(1 + 2 * (2 + 3)), Contains("count,solver_0,original,100,0.5,0.2,0.8")));
  EXPECT_THAT(lines_of(text_of(out / "targets.csv")),
              ElementsAre("family,problem,target", "count,hs-1,0.5", "count,hs-1,1.5",
                          "missing-value,hs-1,0.5", "missing-value,hs-1,1.5"));
}

using LatexSummary = ExportedStore;

TEST_F(LatexSummary, HasTheRankedEntriesOfEachFamilyThatSolvedARun) {
  RatedFamily some = rated("some", 2), none = rated("none", 2);
  some.ratings[0].returned = 0;
  for (comparison::Rating& rating : none.ratings) rating.returned = 0;
  write_latex_summary({rated("top_speed", 2), some, none}, out);
  const std::string text = text_of(out / "summary.tex");
  EXPECT_THAT(text, HasSubstr("\ntop\\_speed & 2 & 100 & solver\\_0, original & 100 & 1.2 & 0.75 "
                              "\\\\\n &  &  & solver\\_1, original & 50 & 2.2 & 0.12 \\\\\n"
                              "some & 2 & 100 & solver\\_1, original & 50 & 2.2 & 0.12 \\\\\n"
                              "none & 2 & 100 & no run is solved &  &  &  \\\\\n"));
  EXPECT_THAT(text, Not(HasSubstr("solver\\_2"))) << "it is not ranked";
}

TEST_F(LatexSummary, HasAsManyRowsAsAPageHolds) {
  for (const int families : {1, 4, 13}) {
    const auto folder = made(out / std::to_string(families));
    write_latex_summary(std::vector<RatedFamily>(families, rated("count", 60)), folder);
    EXPECT_THAT(separators_in(text_of(folder / "summary.tex"), '&', is_latex_row),
                SizeIs(1 + 45 / families * families))
        << "and the header";
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
  ricochet::write_file(
      out / "page.tex",
      "\\documentclass[a4paper]{article}\n\\usepackage{booktabs}\n\\usepackage{graphicx}\n"
      "\\usepackage{textcomp}\n\\usepackage[T1]{fontenc}\n\\begin{document}\n"
      "\\input{summary.tex}\n\\end{document}\n");
  const int status = std::system(
      ("cd '" + out.string() + "' && pdflatex -interaction=batchmode page.tex >/dev/null 2>&1")
          .c_str());
  const std::string log = text_of(out / "page.log");
  EXPECT_EQ(status, 0) << log;
  EXPECT_THAT(log, AllOf(HasSubstr("page.pdf (1 page"), Not(HasSubstr("Overfull")),
                         Not(HasSubstr("Float too large"))));
}

}  // namespace
}  // namespace ricochet::exports
