#include "src/interface/scene_text.h"

#include "ricochet/error.h"
#include "src/core/toml_file.h"

namespace ricochet::interface {

std::string scene_text(const std::string& file) {
  if (file.empty()) throw InputError("the machine file has no name");
  return read_toml_text(file == "-" ? "/dev/stdin" : file);
}

}  // namespace ricochet::interface
