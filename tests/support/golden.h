#pragma once

#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet {

/// Expects a text to be that of tests/golden/`name`. With RICOCHET_WRITE_GOLDEN set the file is
/// written instead: `tests/golden/write` does that for all of them, and its diff is reviewed.
inline void expect_golden(const std::string& text, const std::string& name) {
  const auto file = fs::path(RICOCHET_SOURCE) / "tests" / "golden" / name;
  if (std::getenv("RICOCHET_WRITE_GOLDEN")) {
    write_file(file, text);
  } else {
    EXPECT_EQ(text, text_of(file)) << "to accept it: tests/golden/write";
  }
}

}  // namespace ricochet
