#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"
#include "src/report/svg.h"

namespace ricochet::report {

/// How outlines are painted. An empty field means SVG's default, except that an empty `fill` means
/// none.
struct Brush {
  std::string stroke = {}, width = {}, dash = {}, cap = {};
  std::string fill = {}, opacity = {};
  std::string clip = {};  ///< id of a clipping region, see Drawing::clip
  bool crisp = false;     ///< edges on whole pixels of the screen, so that neighbours leave no gap
};

/// Style of a text, and its anchor: start, middle or end.
struct Lettering {
  std::string colour = "black";
  std::string anchor = "start";
  int size = 12;  ///< pixels
  bool bold = false;
  double turned = 0;  ///< degrees, clockwise
};

struct Writing {
  Pixel place;  ///< on the base line
  std::string text;
};

/// An SVG picture that is drawn part by part; texts lie above all other parts. All outlines with
/// one brush form one path. Ids start with the name, which must be unique on a page; title and
/// description are for screen readers, and fonts are the reader's.
class Drawing {
 public:
  Drawing(std::string name, const std::string& title, const std::string& description, int width,
          int height);

  void paint(const Brush& brush, const std::vector<Outline>& outlines);
  void write(const Lettering& lettering, const std::vector<Writing>& writings);

  /// Adds a gradient of colours from bottom to top (one for each picture), and a fill of slanted
  /// lines.
  std::string gradient(const std::vector<std::string>& colours);
  std::string hatching();

  /// Adds a clipping region for a box (one for each picture), extended by the width of lines along
  /// its edge.
  std::string clip(const Box& box);

  /// Starts with <svg class="ricochet-chart".
  std::string text() const;

 private:
  std::string name_;
  pugi::xml_document document_;
  pugi::xml_node root_, paths_, crisp_;
};

/// Joins pictures of drawings with different names into one picture, one below the other.
std::string stacked(const std::vector<std::string>& svgs);

/// A chart for a page: a picture, or the reason why it could not be drawn.
struct DrawnChart {
  std::string name, title;
  std::string svg;
  std::string failure = {};  ///< empty if it is drawn

  bool is_drawn() const { return failure.empty(); }
};

/// Draws a chart. Throws only std::bad_alloc: other errors are returned as the failure of this
/// chart.
DrawnChart draw(const Chart& chart);

/// What reports/templates/chart_links.js needs for the links of a heat map: `box`, the pixels of
/// the cells in the picture (left, right, top, bottom), and for each of the `rows`, from the top,
/// and `columns` its name and its part of the address. Throws std::invalid_argument unless there is
/// a link for each row and column.
Json cell_links_data(const Chart& chart);

/// Returns the SVG with the chart's numbers, for the buttons of reports/templates/chart_data.js,
/// and the links of its cells, or a paragraph with the reason for the failure.
std::string html_of(const Chart& chart, const DrawnChart& drawn);

/// Returns a reference to the picture's file, or the same reason.
std::string markdown_of(const DrawnChart& chart);

/// "chart NAME could not be drawn: REASON", for the end of a command.
std::string failure_of(const DrawnChart& chart);

/// Charts with different names, one below the other: a picture for a separate file.
struct Plot {
  std::string svg = {};  ///< of those that could be drawn; empty if there is none
  std::vector<std::string> failures = {};
};
Plot plot_of(const std::vector<Chart>& charts);

/// Throws std::runtime_error with these lines if there are any. To be called after all other
/// output.
void require_none(const std::vector<std::string>& failures);

/// Returns the same JSON for a script of a page: "</script>" cannot occur in it.
std::string json_in_script(const std::string& json);

/// Returns a script element of this class that holds the data.
std::string data_script(const char* name, const Json& data);

}  // namespace ricochet::report
