#include "tests/support/golden.h"

#include <regex>

#include "tests/app/tool.h"

/// What commands print: tests/golden/*.txt have a line "$ command" for each, indented below it what
/// it writes on standard output, after "!" what it writes on standard error, and after "=" its exit
/// code if it is not 0. The commands of a file share a folder. Lines with # are remarks.
namespace ricochet::cli {
namespace {

const fs::path golden = fs::path(RICOCHET_SOURCE) / "tests" / "golden";

/// A number with six digits or more rounded to four: last bits differ between machines.
std::string rounded(const std::string& number) {
  const auto digits = std::ranges::count_if(number.substr(0, number.find('e')),
                                            [](char c) { return '0' <= c && c <= '9'; });
  return digits < 6 ? number : fmt::format("{:.4g}", std::stod(number));
}

/// The text with placeholders for what differs between runs and machines.
std::string normal(std::string text) {
  static const std::regex number(R"([0-9]+[.][0-9]+(e[-+]?[0-9]+)?)");
  static const std::pair<std::regex, std::string> placeholders[] = {
      {std::regex(R"((about|at least) .* on [0-9]+ cores?)"), "$1 TIME on CORES"},
      {std::regex(R"([0-9.]+ (ms|µs|s) of processor time)"), "TIME of processor time"},
      {std::regex(R"(digest [0-9a-f]{16})"), "digest HASH"},
      {std::regex(R"(by .+ with ricochet .+ on 20[0-9-]+)"), "by WHOM with VERSION on DATE"},
      {std::regex(R"(It took [0-9.]+ m?s)"), "It took TIME"},
      {std::regex(R"(("seconds": ?)[-0-9.e]+)"), "$1TIME"},
      {std::regex("[^\n]+: [0-9]+ %, [^\n]+\n"), ""},  // progress, which slow machines print
      {std::regex(RICOCHET_SOURCE), "SOURCE"}};
  text = std::regex_replace(text, std::regex(here().string() + "/?"), "");
  for (const auto& [found, placeholder] : placeholders) {
    text = std::regex_replace(text, found, placeholder);
  }
  std::string result;
  auto rest = text.cbegin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    result.append(rest, (*found)[0].first).append(rounded(found->str()));
    rest = (*found)[0].second;
  }
  return result.append(rest, text.cend());
}

std::string after_each(const std::string& mark, const std::string& text) {
  std::string marked;
  for (const std::string& line : lines_of(text)) marked += (line.empty() ? "" : mark) + line + '\n';
  return marked;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, IsWhatIsPrinted) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  fs::create_symlink(RICOCHET_SOURCE "/examples", here() / "examples");
  const std::string name = GetParam() + ".txt";
  std::string printed;
  for (const std::string& line : lines_of(text_of(golden / name))) {
    if (line.starts_with("$ ") || line.starts_with("#")) printed += line + '\n';
    if (!line.starts_with("$ ")) continue;
    const Outcome outcome = call_in_shell("export LC_ALL=C\n" + line.substr(2));
    printed += after_each("  ", normal(outcome.out)) + after_each("! ", normal(outcome.err));
    if (outcome.exit_code != 0) printed += fmt::format("= {}\n", outcome.exit_code);
    if (outcome.exit_code != 2) continue;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_THAT(outcome.err, testing::MatchesRegex("ricochet: [^\n]+\n")) << line;
  }
  expect_golden(printed, name);
}

std::vector<std::string> golden_commands() {
  std::vector<std::string> names;
  for (const fs::path& file : fs::directory_iterator(golden)) {
    const bool prints = file.extension() == ".txt" && text_of(file).starts_with("$ ricochet");
    if (prints) names.push_back(file.stem());
  }
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(golden_commands()), [](const auto& file) {
  return std::regex_replace(file.param, std::regex("-"), "_");
});

}  // namespace
}  // namespace ricochet::cli
