#pragma once

#include <string>

#include "src/report/picture.h"

namespace ricochet::report {

/// A picture as SVG, in few characters: what one brush paints is one path, texts of one style are
/// one group, neighbouring cells of one colour are one, places are rounded to what a screen shows.
/// Ids start with the name, which must be unlike others on a page; title and description are for
/// screen readers, and fonts are the reader's own. Starts with <svg class="ricochet-chart".
std::string short_svg(const Picture& picture, const std::string& name, const std::string& title,
                      const std::string& description);

}  // namespace ricochet::report
