#include "src/report/cell_links.h"

#include <stdexcept>

#include "src/report/frame.h"

namespace ricochet::report {
namespace {

std::string in_page_of(const std::string& place) {
  const std::size_t hash = place.find('#');
  if (hash == std::string::npos) throw std::invalid_argument("a cell's link has no #: " + place);
  return place.substr(0, hash) + "/index.html" + place.substr(hash);
}

}  // namespace

Json cell_links_data(const Chart& chart, const CellLinks& links) {
  if (links.rows.size() != chart.y.categories.size() ||
      links.columns.size() != chart.x.categories.size()) {
    throw std::invalid_argument("chart \"" + chart.name + "\": not a link for each row and column");
  }
  const Box box = frame_of(chart).plot;
  Json rows = Json::array(), columns = Json::array();
  for (std::size_t row = links.rows.size(); row-- > 0;) {
    rows.push_back({chart.y.categories[row], in_page_of(links.rows[row])});
  }
  for (std::size_t column = 0; column < links.columns.size(); ++column) {
    columns.push_back({chart.x.categories[column], links.columns[column]});
  }
  return {{"box", {box.left, box.right, box.top, box.bottom}},
          {"rows", std::move(rows)},
          {"columns", std::move(columns)}};
}

}  // namespace ricochet::report
