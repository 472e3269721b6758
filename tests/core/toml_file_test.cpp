#include <gtest/gtest.h>

#include <string>

#include "ricochet/error.h"
#include "src/core/toml.h"

namespace ricochet {
namespace {

TEST(TomlFile, SaysWhyAFileCannotBeRead) {
  const auto complaint = [](const std::string& file) -> std::string {
    try {
      parse_toml_file(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(complaint("/nothing/there.toml"), "/nothing/there.toml: there is no such file");
  EXPECT_EQ(complaint("/dev/null/there"), "/dev/null/there: cannot be read: Not a directory");
  EXPECT_EQ(complaint("/"), "/: cannot be read: Is a directory");
}

TEST(TomlFile, ReadsNoMoreOfAFileThanItMayHave) {
  EXPECT_THROW(parse_toml_file("/dev/zero"), InputError);
  EXPECT_THROW(parse_toml_file("/"), InputError);
  EXPECT_TRUE(parse_toml_file("/dev/null").empty());
}

}  // namespace
}  // namespace ricochet
