#include <regex>

#include "tests/support/files.h"
#include "tests/support/test.h"

/// CONTRIBUTING.md draws which part may include which, and which files may include a library. Here
/// the drawing is held against the #include lines of all files.
namespace ricochet {
namespace {

using Words = std::vector<std::string>;

const fs::path root = RICOCHET_SOURCE;

struct File {
  std::string path;
  Words includes;   ///< in quotes
  Words libraries;  ///< in angle brackets
  int lines = 0;
};

/// One line of the drawing: `left arrow right`.
struct Line {
  Words left, right;
};

struct Drawing {
  std::vector<Line> parts;      ///< a part -> the parts below that it includes
  std::vector<Line> libraries;  ///< beginnings of headers <- the only places that include them
};

Words words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The lines of a text from after a heading to the next; none where there is no such heading.
Words section(const std::string& text, const std::string& heading) {
  const Words lines = lines_of(text);
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
  return fs::path(path).parent_path().string();
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
    // From the bottom up, so that every arrow leads to what is known.
    for (auto line = drawing.parts.rbegin(); line != drawing.parts.rend(); ++line) read_part(*line);
    for (const Line& line : drawing.libraries) read_library(line);
    for (const File& file : files) {
      check_includes(file);
      check_libraries(file);
    }
    for (const auto& [arrow, used] : arrows_) {
      if (!used) complain(arrow.first + " -> " + arrow.second + " is used by no file");
    }
  }

  const Words& complaints() const { return complaints_; }

 private:
  void complain(const std::string& sentence) { complaints_.push_back(sentence); }

  /// The folder, or else the file without its ending, that a name means: the whole of its path, or
  /// the end of just one. Empty where there is none.
  std::string place_named(const std::string& name) {
    for (const auto* places : {&folders_, &stems_}) {
      if (places->contains(name)) return name;
      Words found;
      std::ranges::copy_if(*places, std::back_inserter(found),
                           [&](const std::string& place) { return place.ends_with("/" + name); });
      if (found.size() == 1) return found[0];
      if (found.empty()) continue;
      complain(name + " may be " + found[0] + " or " + found[1]);
      return "";
    }
    complain(name + " is neither a folder nor a file");
    return "";
  }

  void read_part(const Line& line) {
    const std::string part = place_named(line.left.at(0));
    if (part.empty()) return;
    std::set<std::string> below;
    for (const std::string& name : line.right) {
      const std::string target = place_named(name);
      if (target.empty()) continue;
      if (!below_.contains(target)) {
        complain(line.left[0] + " -> " + name + " does not lead to a line below");
        continue;
      }
      arrows_[{part, target}] = false;
      below.insert(target);
      below.insert(below_[target].begin(), below_[target].end());
    }
    if (!below_.emplace(part, below).second) complain(part + " has two lines");
  }

  void read_library(const Line& line) {
    for (const std::string& beginning : line.left) library_of_[beginning] = line.left[0];
    for (const std::string& name : line.right) {
      const std::string place = place_named(name);
      if (!place.empty()) arrows_[{place, line.left.at(0)}] = false;
    }
  }

  /// Whether the drawing has this arrow, which a file uses.
  bool use(const std::string& from, const std::string& to) {
    const auto arrow = arrows_.find({from, to});
    if (arrow == arrows_.end()) return false;
    return arrow->second = true;
  }

  /// The part that a file belongs to: itself, or the nearest folder around it that has a line.
  std::string part_of(const std::string& path) const {
    std::string part = without_ending(path);
    while (!part.empty() && !below_.contains(part)) part = folder_of(part);
    return part;
  }

  void check_includes(const File& file) {
    const std::string part = part_of(file.path);
    if (part.empty()) return complain(file.path + " is in no part of the drawing");
    for (const std::string& include : file.includes) {
      if (include.starts_with("embedded/")) continue;  // made by the build
      const std::string sentence = file.path + " includes " + include, target = part_of(include);
      if (!paths_.contains(include)) {
        complain(sentence + ", which is not there");
      } else if (!target.empty() && target != part && !use(part, target) &&
                 !below_[part].contains(target)) {
        complain(sentence + ": no arrow leads from " + part + " to " + target);
      }
    }
  }

  void check_libraries(const File& file) {
    for (const std::string& header : file.libraries) {
      std::string library;  // that of the longest beginning, which is the last of the map
      for (const auto& [beginning, its_library] : library_of_) {
        if (header.starts_with(beginning)) library = its_library;
      }
      const bool by_file = use(without_ending(file.path), library);
      const bool by_folder = use(folder_of(file.path), library);
      if (library.empty() || by_file || by_folder) continue;
      complain(file.path + " includes <" + header + ">, which others adapt");
    }
  }

  std::set<std::string> paths_, folders_, stems_;
  std::map<std::string, std::set<std::string>> below_;  // of each part all that it may include
  std::map<std::string, std::string> library_of_;       // of the beginning of a header
  std::map<std::pair<std::string, std::string>, bool> arrows_;  // whether a file uses it
  Words complaints_;
};

/// What has more lines than a row "| `room` | ceiling |" allows, is in no room, or is a room that
/// is not there, as sentences. A file is in the nearest room around it.
Words above_ceilings(const std::vector<File>& files, const Words& rows) {
  static const std::regex row(R"(\| `([\w/]+)` \| (?:(\d+),)?(\d+) \|)");
  std::map<std::string, int> room_left;  // [lines]
  std::set<std::string> empty;
  for (const std::string& line : rows) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    room_left[match[1]] = std::stoi(match.str(2) + match.str(3));
    empty.insert(match[1]);
  }
  Words sentences;
  for (const File& file : files) {
    std::string room = folder_of(file.path);
    while (!room.empty() && !room_left.contains(room)) room = folder_of(room);
    if (room.empty()) sentences.push_back(file.path + " is in no room with a ceiling");
    if (!room.empty()) room_left[room] -= file.lines;
    empty.erase(room);
  }
  for (const std::string& room : empty) sentences.push_back(room + " has no file");
  for (const auto& [room, left] : room_left) {
    if (left < 0) sentences.push_back(fmt::format("{} is {} above its ceiling", room, -left));
  }
  return sentences;
}

std::vector<File> all_files(const Words& folders) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<File> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      // Drivers of other simulators are programs of their own, which use nothing of ricochet.
      if (path.parent_path().filename() == "tools") continue;
      if (path.string().find("node_modules") != std::string::npos) continue;
      if (path.extension() != ".h" && path.extension() != ".cpp") continue;
      File& file = files.emplace_back();
      file.path = path.lexically_relative(root).string();
      for (const std::string& line : lines_of(text_of(path))) {
        ++file.lines;
        std::smatch match;
        if (line.find('#') == line.npos || !std::regex_match(line, match, include)) continue;
        const std::string header = match[2];
        if (header.starts_with("ricochet/")) {  // public, in quotes or angle brackets
          file.includes.push_back("include/" + header);
        } else {
          (match[1] == "<" ? file.libraries : file.includes).push_back(header);
        }
      }
    }
  }
  return files;
}

TEST(Architecture, IsAsContributingDrawsIt) {
  const auto files = all_files({"bench", "include", "problems", "solvers", "src"});
  ASSERT_GT(files.size(), 300U);
  const Drawing drawing = drawing_in(text_of(root / "CONTRIBUTING.md"), "## What may include what");
  ASSERT_GT(drawing.parts.size(), 15U);
  ASSERT_GT(drawing.libraries.size(), 5U);
  EXPECT_THAT(Audit(files, drawing).complaints(), IsEmpty());
}

TEST(Architecture, StaysBelowTheCeilingsOfContributing) {
  const std::string text = text_of(root / "CONTRIBUTING.md");
  const auto files = all_files({"bench", "include", "problems", "solvers", "src", "tests"});
  EXPECT_THAT(above_ceilings(files, section(text, "## How large a room may be")), IsEmpty());
}

TEST(Architecture, CountsARoomsLines) {
  const Words rooms = section(
      "## Rooms\n| room | lines |\n| :--- | ---: |\n| `src/core` | 1,030 |\n| `src` | 9 |\n"
      "## Other\n| `bench` | 1 |\n",
      "## Rooms");
  std::vector<File> files = {{"src/core/box.h", {}, {}, 1000},
                             {"src/core/deep/box.h", {}, {}, 30},
                             {"src/new/page.h", {}, {}, 9}};
  EXPECT_THAT(above_ceilings(files, rooms), IsEmpty());
  EXPECT_THAT(above_ceilings({files[0]}, rooms), ElementsAre("src has no file"));
  files.push_back({"src/core/run.h", {}, {}, 1});
  files.push_back({"bench/run.h", {}, {}, 1});
  EXPECT_THAT(above_ceilings(files, rooms), ElementsAre("bench/run.h is in no room with a ceiling",
                                                        "src/core is 1 above its ceiling"));
}

/// The files of this repository that a page names by their path.
TEST(Architecture, IsDescribedByFilesThatAreThere) {
  static const std::regex path(R"(`((?:bench|include|problems|solvers|src)/[\w/]+\.(?:cpp|h))`)");
  const std::string text = text_of(root / "docs/architecture.md");
  int named = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), path), end; match != end; ++match) {
    ++named;
    EXPECT_TRUE(fs::exists(root / match->str(1))) << match->str(1);
  }
  EXPECT_GT(named, 10);
}

/// A small tree that is as drawn: a study of a solver of a core, one file of which stands alone.
TEST(Architecture, HasNoFileThatTheDrawingForbidsAndIsNotDrawnAsItIsNot) {
  const std::vector<File> tree = {{"src/core/box.h", {}, {"vector"}},
                                  {"src/core/run.h", {"src/core/box.h"}, {}},
                                  {"solvers/climb.h", {"src/core/run.h"}, {}},
                                  {"solvers/climb.cpp", {"solvers/climb.h"}, {"nlopt.h"}},
                                  {"src/studies/hill/page.cpp",
                                   {"solvers/climb.h", "src/core/run.h", "embedded/page.h"},
                                   {"nlopt_names.h"}}};
  const std::string drawn =
      "## Parts\n```text\nhill    -> solvers\nsolvers -> core\ncore    -> box\nbox\n\n"
      "nlopt       <- climb\nnlopt_names <- hill\n```\n";
  const auto complaints = [&](const File& further, const std::string& from, const std::string& to) {
    std::vector<File> files = tree;
    files.push_back(further);
    std::string text = drawn;
    text.replace(text.find(from), from.size(), to);
    return Audit(files, drawing_in(text, "## Parts")).complaints();
  };
  const std::pair<File, Words> of_files[] = {
      {{"src/core/run.cpp", {}, {}}, {}},
      {{"src/new/file.h", {}, {}}, {"src/new/file.h is in no part of the drawing"}},
      {{"src/core/instance.h", {"src/core/sead.h"}, {}},
       {"src/core/instance.h includes src/core/sead.h, which is not there"}},
      {{"src/core/instance.h", {"solvers/climb.h"}, {}},
       {"src/core/instance.h includes solvers/climb.h: no arrow leads from src/core to solvers"}},
      {{"src/core/box.cpp", {"src/core/run.h"}, {}},
       {"src/core/box.cpp includes src/core/run.h: no arrow leads from src/core/box to src/core"}},
      {{"solvers/walk.cpp", {}, {"nlopt.h"}},
       {"solvers/walk.cpp includes <nlopt.h>, which others adapt"}},
      {{"src/core/climb.h", {}, {}},
       {"climb may be solvers/climb or src/core/climb",
        "solvers/climb.cpp includes <nlopt.h>, which others adapt"}}};
  for (const auto& [further, expected] : of_files) EXPECT_EQ(complaints(further, "", ""), expected);
  const auto drawn_otherwise = [&](const std::string& from, const std::string& to) {
    return complaints({"src/core/run.cpp", {}, {}}, from, to);
  };
  EXPECT_THAT(drawn_otherwise("core    ->", "coer    ->"),
              ElementsAre("coer is neither a folder nor a file",
                          "solvers -> core does not lead to a line below",
                          "src/core/run.h is in no part of the drawing",
                          "src/core/run.cpp is in no part of the drawing"));
  EXPECT_THAT(drawn_otherwise("core    -> box", "core    -> solvers box"),
              ElementsAre("core -> solvers does not lead to a line below"));
  EXPECT_THAT(drawn_otherwise("-> solvers", "-> solvers box"),
              ElementsAre("src/studies/hill -> src/core/box is used by no file"));
  EXPECT_THAT(drawn_otherwise("<- climb", "<- climb run"),
              ElementsAre("src/core/run -> nlopt is used by no file"));
  EXPECT_THAT(drawn_otherwise("\nbox\n", "\nbox\nbox\n"),
              ElementsAre("src/core/box has two lines"));
}

}  // namespace
}  // namespace ricochet
