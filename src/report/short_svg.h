#pragma once

#include <pugixml.hpp>

namespace ricochet::report {

/// Makes gnuplot's SVG shorter, and leaves the picture as it is: coordinates have one decimal,
/// colours are #rrggbb, what every group says is said once, and a group of a text alone is a text.
void shorten(pugi::xml_document& document);

}  // namespace ricochet::report
