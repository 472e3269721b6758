#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

/// Makes gnuplot's SVG fit for a page, see short_svg. Throws std::runtime_error if it is not XML,
/// or has elements that are unknown.
std::string finish_svg(const std::string& svg, const std::string& name, const std::string& title,
                       const std::string& description);

/// Finished pictures of charts with names of their own, one under the other, as one picture.
std::string stacked(const std::vector<std::string>& svgs);

}  // namespace ricochet::report
