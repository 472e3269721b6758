#pragma once

#include <string>

namespace ricochet::site {

/// The page of a live machine, whose parts are in src/live/page: the simulator as a WebAssembly
/// module with sliders and charts, in one file that asks for no other. `navigation`: the links to
/// all reports, as HTML.
std::string live_page(const std::string& navigation);

}  // namespace ricochet::site
