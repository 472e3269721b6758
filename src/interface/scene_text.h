#pragma once

#include <string>

namespace ricochet::interface {

/// The text of a machine file, "-" for standard input. Throws InputError if it cannot be read.
std::string scene_text(const std::string& file);

}  // namespace ricochet::interface
