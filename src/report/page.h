#pragma once

#include <filesystem>
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
};

/// A heading and what it heads, in this order. Text is plain; https:// addresses become links.
struct Section {
  std::string id;  ///< the address of the section within the page; unique, without spaces
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<Table> tables = {};
  std::vector<Figure> figures = {};  ///< narrow ones stand side by side
};

struct Page {
  std::string title;
  std::vector<std::string> intro;  ///< paragraphs
  std::vector<Section> sections;
};

/// Writes index.html, which needs no other file and no network, summary.md and one SVG a chart into
/// the folder, which is made if missing, and the files that `beside` names. Replaces those of an
/// earlier report, its other charts included, and leaves every other file alone. Throws InputError,
/// with nothing changed, where the folder cannot be written; std::invalid_argument where ids or
/// charts' names repeat or a chart or table is wrong; std::runtime_error where charts cannot be
/// drawn.
void write_page(const Page& page, const std::filesystem::path& folder, FileSet beside = {});

}  // namespace ricochet::report
