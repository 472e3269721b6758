#pragma once

#include <string>
#include <vector>

/// A machine file as the live page takes it: read by the program's own reader, so that both say the
/// same of a file that is wrong.
namespace ricochet::live {

struct MachineFile {
  std::vector<double> numbers;     ///< see numbers_of()
  std::vector<std::string> notes;  ///< what of the file the numbers leave out, a sentence each
};

/// Errors name the file `origin`. Throws InputError as parse_scene_file() does, and for a speed
/// profile, which the page cannot show.
MachineFile machine_file(const std::string& text, const std::string& origin);

}  // namespace ricochet::live
