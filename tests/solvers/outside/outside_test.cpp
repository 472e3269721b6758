#include "solvers/outside/outside.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "ricochet/error.h"
#include "tests/solvers/outside/scripts.h"

namespace ricochet::outside {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string folder = RICOCHET_FOLDER;

TEST(Outside, IsALibraryAProgramOrNothing) {
  EXPECT_EQ(outside_solver("fireworks"), std::nullopt);
  EXPECT_EQ(outside_solver("nothing.so"), std::nullopt);
  EXPECT_EQ(outside_solver(folder + "/mine.so")->name, "mine");
  EXPECT_EQ(outside_solver(folder + "/talker")->name, "talker");
  EXPECT_EQ(outside_solver(folder + "/talker 7")->name, "talker");
  EXPECT_EQ(outside_solver("sh -c 'exec " + folder + "/talker'")->name, "talker");
  EXPECT_EQ(outside_solver("sh -c 'exec " + folder + "/talker' /some.so")->name, "talker");
}

TEST(Outside, IsALibraryInAFolderWithASpace) {
  const fs::path spaced = fresh_folder() / "of mine";
  fs::create_directory(spaced);
  fs::copy_file(folder + "/mine.so", spaced / "mine.so");
  EXPECT_EQ(outside_solver((spaced / "mine.so").string())->name, "mine");
}

TEST(Outside, IsToldWhatIsWrong) {
  const auto refused = [](const std::string& text, const std::string& reason) {
    try {
      outside_solver(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(text + ": "));
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  };
  refused("./nothing", "there is no such file");
  refused("./nothing.so", "No such file");
  const fs::path file = fresh_folder() / "mine.py";
  std::ofstream(file) << "print()\n";
  refused(file.string(), "For example \"python3 " + file.string() + "\"");
  fs::current_path(file.parent_path());
  refused("mine.py", "a file is given with its folder, ./mine.py");
}

}  // namespace
}  // namespace ricochet::outside
