#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/file_set.h"
#include "src/report/table.h"

namespace ricochet::report {

struct Figure {
  Chart chart;
  std::string caption;
  /// What the reader chooses it by: of a section's choices one is seen at a time on a screen, the
  /// first of them at the beginning, and all on paper. Empty: it is always seen.
  std::string choice = {};
  /// Of the frames of a choice one is seen at a time, the last at the beginning, and on paper; a
  /// slider, which needs a script, goes through them, and says this. Empty: it is no frame.
  std::string frame = {};
  /// What it is folded under, until the reader opens that. Empty: it is not.
  std::string fold = {};
};

/// Something that the reader may set, to one of several values.
struct Setting {
  std::string label;                ///< with its unit
  std::vector<std::string> values;  ///< by rising value
  std::size_t own;                  ///< the one that is set at the beginning
};

/// An answer for each combination of settings, of which a script shows one. What matters must be
/// told by tables and figures, too.
struct Explorer {
  std::string caption;
  std::vector<Setting> settings;
  std::vector<std::string> answers;  ///< the last setting changes first
};

/// A heading and what it heads, in this order, an explorer before the tables. Text is plain;
/// https:// addresses become links.
struct Section {
  std::string id;  ///< the address of the section within the page; unique, without spaces
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<Table> tables = {};
  std::vector<Figure> figures = {};  ///< narrow ones stand side by side
  std::optional<Explorer> explorer = {};
};

struct Page {
  std::string title;
  std::vector<std::string> intro;  ///< paragraphs
  std::vector<Section> sections;
  // The summary links these, as the navigation of the site does for the page:
  std::string above = {};                 ///< what the page in the folder above is called, if any
  std::vector<std::string> further = {};  ///< folders of further pages
};

/// Writes index.html, which needs no other file and no network, summary.md and one SVG a chart into
/// the folder, which is made if missing, and the files that `beside` names. Replaces those of an
/// earlier report, its other charts included, and leaves every other file alone. Throws InputError,
/// with nothing changed, where the folder cannot be written; std::invalid_argument where ids or
/// charts' names repeat or a chart or table is wrong; std::runtime_error where charts cannot be
/// drawn.
void write_page(const Page& page, const std::filesystem::path& folder, FileSet beside = {});

}  // namespace ricochet::report
