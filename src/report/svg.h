#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

/// Makes gnuplot's SVG fit for a page: every id starts with `name`, so that several share one page;
/// title and description are for screen readers; fonts are the reader's own; what draws nothing is
/// dropped. The result has no XML declaration and starts with <svg class="ricochet-chart".
/// Throws std::runtime_error if it is not XML.
std::string finish_svg(const std::string& svg, const std::string& name, const std::string& title,
                       const std::string& description);

/// Finished pictures of charts with names of their own, one under the other, as one picture.
std::string stacked(const std::vector<std::string>& svgs);

}  // namespace ricochet::report
