#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// In small letters, with one blank wherever there are blanks and line ends.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isspace(byte) == 0) {
      result += static_cast<char>(std::tolower(byte));
    } else if (!result.ends_with(' ')) {
      result += ' ';
    }
  }
  return result;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The terms of docs/glossary.md, in their order: `- **term** ...`.
std::vector<std::string> terms() {
  static const std::regex line(R"(\n- \*\*([^*]+)\*\*)");
  const std::string text = text_of(fs::path(RICOCHET_SOURCE) / "docs/glossary.md");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it) {
    found.push_back(plain(it->str(1)));
  }
  return found;
}

/// What a term may be used in: README, the other documents, and the pages with what fills them.
std::vector<std::string> texts_with_terms() {
  const fs::path source = RICOCHET_SOURCE;
  std::vector<std::string> texts = {plain(text_of(source / "README.md"))};
  const auto add = [&](const char* folder, const auto& has_prose) {
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
      if (has_prose(entry.path())) texts.push_back(plain(text_of(entry.path())));
    }
  };
  add("docs", [](const fs::path& file) {
    return file.extension() == ".md" && file.filename() != "glossary.md";
  });
  add("reports/templates", [](const fs::path& file) { return file.has_extension(); });
  add("reports/reference", [](const fs::path& file) { return file.filename() == "summary.md"; });
  add("src/studies", [](const fs::path& file) { return file.extension() == ".md"; });
  return texts;
}

/// Whether the term stands in the text as words of their own, perhaps in the plural.
bool has_term(const std::string& text, const std::string& term) {
  const auto letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(term); at != std::string::npos; at = text.find(term, at + 1)) {
    const std::size_t end = at + term.size();
    if (at > 0 && letter(at - 1)) continue;
    if (!letter(end) || (text[end] == 's' && !letter(end + 1))) return true;
  }
  return false;
}

TEST(Glossary, HasEachTermOnceInTheOrderOfTheAlphabet) {
  const std::vector<std::string> all = terms();
  EXPECT_GT(all.size(), 50U);
  // strictly: a term that stands twice is not less than itself
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1], all[i]);
}

TEST(Glossary, HasOnlyTermsThatAPageOrAnotherDocumentUses) {
  const std::vector<std::string> texts = texts_with_terms();
  EXPECT_GT(texts.size(), 50U);
  for (const std::string& term : terms()) {
    EXPECT_TRUE(std::ranges::any_of(texts, [&](const std::string& text) {
      return has_term(text, term);
    })) << term;
  }
}

TEST(Glossary, SaysOfEachTermWhereMoreIsSaid) {
  static const std::regex entry(
      R"(- \*\*[^*]+\*\*( \[[^\]]+\])?: .+\. \[[^\]]+\]\(([^)#]+)(#[^)]*)?\))");
  const fs::path docs = fs::path(RICOCHET_SOURCE) / "docs";
  std::ifstream stream(docs / "glossary.md");
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("- ")) continue;
    std::smatch match;
    ASSERT_TRUE(std::regex_match(line, match, entry)) << line;
    EXPECT_TRUE(fs::exists(docs / match.str(2))) << line;
  }
}

}  // namespace
}  // namespace ricochet::site
