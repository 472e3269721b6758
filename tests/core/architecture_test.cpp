#include <regex>

#include "tests/support/files.h"
#include "tests/support/test.h"

/// CONTRIBUTING.md draws which part may include which, and which files may include a library. Here
/// the drawing is held against the #include lines of all files.
namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct File {
  std::string path;
  std::vector<std::string> includes;   ///< in quotes
  std::vector<std::string> libraries;  ///< in angle brackets
  int lines = 0;
};

/// One line of the drawing: `left arrow right`.
struct Line {
  std::vector<std::string> left, right;
};

struct Drawing {
  std::vector<Line> parts;      ///< a part -> the parts below that it includes
  std::vector<Line> libraries;  ///< beginnings of headers <- the only places that include them
};

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The lines of a text from after a heading to the next; none where there is no such heading.
std::vector<std::string> section(const std::string& text, const std::string& heading) {
  const std::vector<std::string> lines = lines_of(text);
  const auto start = std::find(lines.begin(), lines.end(), heading);
  if (start == lines.end()) return {};
  const auto next = [](const std::string& line) { return line.starts_with("## "); };
  return {start + 1, std::find_if(start + 1, lines.end(), next)};
}

/// The drawing in the fenced blocks after a heading.
Drawing drawing_in(const std::string& text, const std::string& heading) {
  Drawing drawing;
  bool fenced = false;
  for (const std::string& line : section(text, heading)) {
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced || line.starts_with("```") || line.empty()) continue;
    const auto by = line.find(" <- "), at = std::min(by, line.find(" -> "));
    const std::string right = at == std::string::npos ? "" : line.substr(at + 4);
    (by == std::string::npos ? drawing.parts : drawing.libraries)
        .push_back({words(line.substr(0, at)), words(right)});
  }
  return drawing;
}

std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

std::string without_ending(const std::string& path) {
  return path.substr(0, path.rfind('.'));
}

/// What is wrong with the files, or with the drawing, as sentences.
class Audit {
 public:
  Audit(const std::vector<File>& files, const Drawing& drawing) {
    for (const File& file : files) {
      paths_.insert(file.path);
      stems_.insert(without_ending(file.path));
      for (std::string folder = folder_of(file.path); !folder.empty(); folder = folder_of(folder)) {
        folders_.insert(folder);
      }
    }
    read(drawing.parts);
    for (const File& file : files) check_includes(file);
    for (const auto& [arrow, used] : arrows_) {
      if (!used) complain(arrow.first + " -> " + arrow.second + " is used by no file");
    }
    check_libraries(files, drawing.libraries);
  }

  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  void complain(const std::string& sentence) { complaints_.push_back(sentence); }

  /// The folder, or else the file without its ending, that a name means: the whole of its path, or
  /// the end of just one.
  std::optional<std::string> place_named(const std::string& name) {
    for (const auto* places : {&folders_, &stems_}) {
      if (places->contains(name)) return name;
      std::vector<std::string> found;
      std::copy_if(places->begin(), places->end(), std::back_inserter(found),
                   [&](const std::string& place) { return place.ends_with("/" + name); });
      if (found.size() == 1) return found[0];
      if (found.size() < 2) continue;
      complain(name + " may be " + found[0] + " or " + found[1]);
      return std::nullopt;
    }
    complain(name + " is neither a folder nor a file");
    return std::nullopt;
  }

  /// The lines from the bottom up, so that every arrow leads to what is known.
  void read(const std::vector<Line>& lines) {
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
      const auto part = place_named(line->left.at(0));
      if (!part) continue;
      std::set<std::string> below;
      for (const std::string& name : line->right) {
        const auto target = place_named(name);
        if (target && !below_.contains(*target)) {
          complain(line->left[0] + " -> " + name + " does not lead to a line below");
        } else if (target) {
          arrows_[{*part, *target}] = false;
          below.insert(*target);
          below.insert(below_[*target].begin(), below_[*target].end());
        }
      }
      if (!below_.emplace(*part, below).second) complain(*part + " has two lines");
    }
  }

  /// The part that a file belongs to: itself, or the nearest folder around it that has a line.
  std::optional<std::string> part_of(const std::string& path) const {
    for (std::string part = without_ending(path); !part.empty(); part = folder_of(part)) {
      if (below_.contains(part)) return part;
    }
    return std::nullopt;
  }

  void check_includes(const File& file) {
    const auto part = part_of(file.path);
    if (!part) return complain(file.path + " is in no part of the drawing");
    for (const std::string& include : file.includes) {
      if (include.starts_with("embedded/")) continue;  // made by the build
      const std::string sentence = file.path + " includes " + include;
      const auto target = part_of(include);
      if (!paths_.contains(include)) {
        complain(sentence + ", which is not there");
      } else if (target && target != part) {
        const auto arrow = arrows_.find({*part, *target});
        if (arrow != arrows_.end()) arrow->second = true;
        if (below_[*part].contains(*target)) continue;
        complain(sentence + ": no arrow leads from " + *part + " to " + *target);
      }
    }
  }

  void check_libraries(const std::vector<File>& files, const std::vector<Line>& lines) {
    std::map<std::string, std::size_t> line_of;  // by the beginning of a header
    std::map<std::pair<std::size_t, std::string>, bool> used;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      for (const std::string& beginning : lines[k].left) line_of[beginning] = k;
      for (const std::string& name : lines[k].right) {
        if (const auto place = place_named(name)) used[{k, *place}] = false;
      }
    }
    for (const File& file : files) {
      for (const std::string& header : file.libraries) {
        // In the order of the map the last beginning is the longest.
        std::optional<std::size_t> line;
        for (const auto& [beginning, k] : line_of) {
          if (header.starts_with(beginning)) line = k;
        }
        bool allowed = !line;
        for (const std::string& place : {without_ending(file.path), folder_of(file.path)}) {
          const auto permission = line ? used.find({*line, place}) : used.end();
          if (permission != used.end()) permission->second = allowed = true;
        }
        if (!allowed) complain(file.path + " includes <" + header + ">, which others adapt");
      }
    }
    for (const auto& [permission, is_used] : used) {
      if (is_used) continue;
      complain(permission.second + " does not include " + lines[permission.first].left.at(0));
    }
  }

  std::set<std::string> paths_, folders_, stems_;
  std::map<std::string, std::set<std::string>> below_;  // of each part all that it may include
  std::map<std::pair<std::string, std::string>, bool> arrows_;  // whether a file uses it
  std::vector<std::string> complaints_;
};

/// The rows "| `room` | ceiling |" of the table after a heading: lines of C++ that a room may have.
std::map<std::string, int> ceilings_in(const std::string& text, const std::string& heading) {
  static const std::regex row(R"(\| `([\w/]+)` \| ([\d,]+) \|)");
  std::map<std::string, int> ceilings;
  for (const std::string& line : section(text, heading)) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    std::string number = match[2];
    std::erase(number, ',');
    ceilings[match[1]] = std::stoi(number);
  }
  return ceilings;
}

/// What is above its ceiling, in no room, or in a room that is not there, as sentences. A file is
/// in the nearest room around it.
std::vector<std::string> above_ceilings(const std::vector<File>& files,
                                        const std::map<std::string, int>& ceilings) {
  std::vector<std::string> sentences;
  std::map<std::string, int> lines;
  for (const File& file : files) {
    std::string room = folder_of(file.path);
    while (!room.empty() && !ceilings.contains(room)) room = folder_of(room);
    if (room.empty()) sentences.push_back(file.path + " is in no room with a ceiling");
    lines[room] += file.lines;
  }
  for (const auto& [room, ceiling] : ceilings) {
    if (lines[room] == 0) sentences.push_back(room + " has no file");
    if (lines[room] <= ceiling) continue;
    sentences.push_back(room + " has " + std::to_string(lines[room]) +
                        " lines, above its ceiling of " + std::to_string(ceiling));
  }
  return sentences;
}

std::vector<std::string> complaints(const std::vector<File>& files, const std::string& block) {
  return Audit(files, drawing_in("## Parts\n```text\n" + block + "```\n", "## Parts")).complaints();
}

File file_at(const std::filesystem::path& root, const std::filesystem::path& path) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  File file{path.lexically_relative(root).string(), {}, {}, 0};
  for (const std::string& line : lines_of(text_of(path))) {
    ++file.lines;
    std::smatch match;
    if (line.find('#') == std::string::npos || !std::regex_match(line, match, include)) continue;
    const std::string header = match[2];
    if (header.starts_with("ricochet/")) {  // public, in quotes or angle brackets
      file.includes.push_back("include/" + header);
    } else {
      (match[1] == "<" ? file.libraries : file.includes).push_back(header);
    }
  }
  return file;
}

std::vector<File> all_files(const std::vector<std::string>& folders = {
                                "bench", "include", "problems", "solvers", "src"}) {
  const std::filesystem::path root(RICOCHET_SOURCE);
  std::vector<File> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      // Drivers of other simulators are programs of their own, which use nothing of ricochet.
      if (entry.path().parent_path().filename() == "tools") continue;
      if (entry.path().string().find("node_modules") != std::string::npos) continue;
      const auto ending = entry.path().extension();
      if (ending == ".h" || ending == ".cpp") files.push_back(file_at(root, entry.path()));
    }
  }
  return files;
}

std::string contributing() {
  return text_of(RICOCHET_SOURCE "/CONTRIBUTING.md");
}

TEST(Architecture, IsAsContributingDrawsIt) {
  const std::vector<File> files = all_files();
  ASSERT_GT(files.size(), 300U);
  const Drawing drawing = drawing_in(contributing(), "## What may include what");
  ASSERT_GT(drawing.parts.size(), 15U);
  ASSERT_GT(drawing.libraries.size(), 5U);
  EXPECT_THAT(Audit(files, drawing).complaints(), IsEmpty());
}

TEST(Architecture, StaysBelowTheCeilingsOfContributing) {
  const auto ceilings = ceilings_in(contributing(), "## How large a room may be");
  ASSERT_GT(ceilings.size(), 10U);
  const auto files = all_files({"bench", "include", "problems", "solvers", "src", "tests"});
  EXPECT_THAT(above_ceilings(files, ceilings), IsEmpty());
}

TEST(Architecture, CountsARoomsLines) {
  const std::string text =
      "## Rooms\n| room | lines |\n| :--- | ---: |\n| `src/core` | 1,030 |\n| `src` | 9 |\n"
      "## Other\n| `bench` | 1 |\n";
  const auto ceilings = ceilings_in(text, "## Rooms");
  EXPECT_EQ(ceilings, (std::map<std::string, int>{{"src/core", 1030}, {"src", 9}}));
  EXPECT_THAT(ceilings_in(text, "## None"), IsEmpty());
  std::vector<File> files = {{"src/core/box.h", {}, {}, 1000},
                             {"src/core/deep/box.h", {}, {}, 30},
                             {"src/new/page.h", {}, {}, 9}};
  EXPECT_THAT(above_ceilings(files, ceilings), IsEmpty());
  files.push_back({"src/core/run.h", {}, {}, 1});
  files.push_back({"bench/run.h", {}, {}, 1});
  EXPECT_THAT(above_ceilings(files, ceilings),
              ElementsAre("bench/run.h is in no room with a ceiling",
                          "src/core has 1031 lines, above its ceiling of 1030"));
  EXPECT_THAT(above_ceilings({files[0]}, ceilings), ElementsAre("src has no file"));
}

/// The files of this repository that a page names by their path.
TEST(Architecture, IsDescribedByFilesThatAreThere) {
  static const std::regex path(R"(`((?:bench|include|problems|solvers|src)/[\w/]+\.(?:cpp|h))`)");
  const std::string text = text_of(RICOCHET_SOURCE "/docs/architecture.md");
  int named = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), path), end; match != end; ++match) {
    ++named;
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(RICOCHET_SOURCE) / match->str(1)))
        << match->str(1);
  }
  EXPECT_GT(named, 10);
}

/// A small tree that is as drawn: a study of a solver of a core, one file of which stands alone.
const std::vector<File> tree = {{"src/core/box.h", {}, {"vector"}},
                                {"src/core/run.h", {"src/core/box.h"}, {}},
                                {"solvers/climb.h", {"src/core/run.h"}, {}},
                                {"solvers/climb.cpp", {"solvers/climb.h"}, {"nlopt.h"}},
                                {"src/studies/hill/page.cpp",
                                 {"solvers/climb.h", "src/core/run.h", "embedded/page.h"},
                                 {"nlopt_names.h"}}};
const std::string drawn =
    "hill    -> solvers\nsolvers -> core\ncore    -> box\nbox\n\n"
    "nlopt       <- climb\nnlopt_names <- hill\n";

TEST(Architecture, MayBeAsDrawn) {
  EXPECT_THAT(complaints(tree, drawn), IsEmpty());
}

TEST(Architecture, HasNoFileThatTheDrawingForbids) {
  const std::pair<File, std::string> further[] = {
      {{"src/new/file.h", {}, {}}, "src/new/file.h is in no part of the drawing"},
      {{"src/core/instance.h", {"src/core/sead.h"}, {}},
       "src/core/instance.h includes src/core/sead.h, which is not there"},
      {{"src/core/instance.h", {"solvers/climb.h"}, {}},
       "src/core/instance.h includes solvers/climb.h: no arrow leads from src/core to solvers"},
      {{"src/core/box.cpp", {"src/core/run.h"}, {}},
       "src/core/box.cpp includes src/core/run.h: no arrow leads from src/core/box to src/core"},
      {{"solvers/walk.cpp", {}, {"nlopt.h"}},
       "solvers/walk.cpp includes <nlopt.h>, which others adapt"}};
  for (const auto& [file, complaint] : further) {
    std::vector<File> files = tree;
    files.push_back(file);
    EXPECT_THAT(complaints(files, drawn), ElementsAre(complaint));
  }
  std::vector<File> files = tree;
  files.push_back({"problems/hill/box.h", {}, {}});
  EXPECT_THAT(complaints(files, drawn),
              testing::Contains("hill may be problems/hill or src/studies/hill"));
}

TEST(Architecture, IsNotDrawnAsItIsNot) {
  using Complaints = std::vector<std::string>;
  struct Drawn {
    std::string from, to;
    Complaints complaints;
  };
  for (const auto& [from, to, said] : std::vector<Drawn>{
           {"core    ->",
            "coer    ->",
            {"coer is neither a folder nor a file", "solvers -> core does not lead to a line below",
             "src/core/run.h is in no part of the drawing"}},
           {"core    -> box",
            "core    -> solvers box",
            {"core -> solvers does not lead to a line below"}},
           {"-> solvers",
            "-> solvers box",
            {"src/studies/hill -> src/core/box is used by no file"}},
           {"<- climb", "<- climb run", {"src/core/run does not include nlopt"}},
           {"\nbox\n", "\nbox\nbox\n", {"src/core/box has two lines"}}}) {
    std::string text = drawn;
    EXPECT_EQ(complaints(tree, text.replace(text.find(from), from.size(), to)), said) << to;
  }
}

}  // namespace
}  // namespace ricochet
