#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "tests/app/tool.h"

/// The script that builds and calls the program, on a checkout of nothing but itself. What it calls
/// are stand-ins that write down how they were called.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class EntryScript : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists("/var/lib/dpkg/info/libeigen3-dev.list")) GTEST_SKIP() << "no Debian";
    fs::create_directories(root_ / "tools");
    make_checkout(root_ / "checkout");
    tool("cmake",
         "echo \"cmake $* in $PWD\" >> \"$LOG\"\n"
         "[[ ${CXX:-} != broken ]] || { touch -a build/release/CMakeCache.txt; exit 1; }\n"
         "mkdir -p build/release\n"
         "echo \"CMAKE_HOME_DIRECTORY:INTERNAL=$PWD\" > build/release/CMakeCache.txt\n"
         "touch build/release/build.ninja\n");
    tool("ninja", "echo 'ninja: no work to do.'\n");
    tool("apt-get", "exit 1\n");
  }

  static void make_executable(const fs::path& file, const std::string& text) {
    write(file.parent_path(), file.filename().string(), text);
    fs::permissions(file, fs::perms::owner_all);
  }
  void tool(const std::string& name, const std::string& text) const {
    make_executable(root_ / "tools" / name, "#!/usr/bin/env bash\n" + text);
  }
  static void make_checkout(const fs::path& folder) {
    fs::create_directories(folder / "build/release/src/app");
    fs::copy_file(RICOCHET_SOURCE "/ricochet", folder / "ricochet");
    make_executable(folder / "build/release/src/app/ricochet", "#!/bin/sh\necho \"$0\"\n");
  }

  /// As another user where this one may write everywhere.
  static std::string as_another() {
    return geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  }

  /// What the call printed; "failed" is added to it if it failed.
  std::string script(const std::string& call) const {
    const int status = std::system(
        fmt::format(
            "cd {0} && PATH={0}/tools:$PATH LOG={0}/log {1} >{0}/out 2>&1 || echo failed >>{0}/out",
            root_.string(), call)
            .c_str());
    EXPECT_EQ(status, 0);
    return read(root_ / "out");
  }
  std::string log() const { return read(root_ / "log"); }

  fs::path root_ = fs::canonical(fresh_folder());
};

TEST_F(EntryScript, CallsTheProgramOfItsOwnCheckout) {
  const std::string program = (root_ / "checkout/build/release/src/app/ricochet").string() + "\n";
  EXPECT_THAT(script("checkout/ricochet list cases"), HasSubstr(program));
  fs::create_directory(root_ / "bin");
  fs::create_symlink("../checkout/ricochet", root_ / "bin" / "link");
  EXPECT_EQ(script("bin/link list cases"), program);
  EXPECT_EQ(script("CDPATH=/usr:. checkout/ricochet list cases"), program);
  fs::create_directory(root_ / "other");
  make_checkout(root_ / "other" / "checkout");
  EXPECT_EQ(script("CDPATH=other checkout/ricochet list cases"), program);
  EXPECT_EQ(log(), fmt::format("cmake --preset release --fresh in {}/checkout\n", root_.string()));
}

TEST_F(EntryScript, OfACopiedCheckoutConfiguresTheCopy) {
  script("checkout/ricochet list cases");
  fs::copy(root_ / "checkout", root_ / "copy", fs::copy_options::recursive);
  EXPECT_THAT(script("copy/ricochet list cases"),
              HasSubstr((root_ / "copy/build/release/src/app/ricochet").string()));
  EXPECT_THAT(log(), HasSubstr(fmt::format("--fresh in {}/copy\n", root_.string())));
  const std::string before = log();
  EXPECT_THAT(script("copy/ricochet list cases"), Not(HasSubstr("configuring")));
  EXPECT_EQ(log(), before);
}

TEST_F(EntryScript, ForgetsACompilerThatWasBroken) {
  EXPECT_THAT(script("CXX=broken checkout/ricochet list cases"), HasSubstr("failed"));
  EXPECT_THAT(script("checkout/ricochet list cases"), Not(HasSubstr("failed")));
  EXPECT_EQ(log(), fmt::format("cmake --preset release --fresh in {0}/checkout\n"
                               "cmake --preset release --fresh in {0}/checkout\n",
                               root_.string()));
}

TEST_F(EntryScript, BuildsForTheMainJobItsOwnProgramAlone) {
  const fs::path folder = root_ / "checkout/build/release/src/app";
  make_executable(folder / "ricochet-reproduce", "#!/bin/sh\necho \"$0 $*\"\n");
  fs::remove(folder / "ricochet");
  tool("ninja", "echo \"ninja $*\" >> \"$LOG\"\necho 'ninja: no work to do.'\n");
  EXPECT_THAT(script("checkout/ricochet reproduce --quick"),
              HasSubstr((folder / "ricochet-reproduce").string() + " reproduce --quick"));
  EXPECT_THAT(log(), HasSubstr("-n ricochet_reproduce\n"));
}

/// The Debian packages with solvers among all that a command installs on a system with none.
std::set<std::string> solver_packages(const std::string& asked) {
  std::set<std::string> found;
  std::istringstream words(asked);
  for (std::string word; words >> word;) {
    if (!word.ends_with("-dev") && word != "python3-scipy") continue;
    for (const char* library : {"dlib", "petsc", "nlopt", "ipopt", "pagmo", "ceres", "scipy"}) {
      if (word.find(library) != std::string::npos) found.insert(word);
    }
  }
  return found;
}

TEST_F(EntryScript, InstallsTheSameSolversForAllThatRunsThem) {
  std::string text = read(root_ / "checkout/ricochet");
  const std::string installed = "/var/lib/dpkg/info";
  for (std::size_t at = 0; (at = text.find(installed, at)) != std::string::npos;) {
    text.replace(at, installed.size(), "/nothing");
  }
  make_executable(root_ / "checkout/ricochet", text);
  const auto of = [&](const std::string& command) {
    return solver_packages(script("checkout/ricochet --no-install " + command));
  };
  EXPECT_THAT(of("test"), testing::ElementsAre("coinor-libipopt-dev", "libceres-dev", "libdlib-dev",
                                               "libnlopt-cxx-dev", "libpagmo-dev", "petsc-dev",
                                               "python3-scipy"));
  for (const char* command : {"compare", "run", "solve", "test --sanitize"}) {
    EXPECT_EQ(of(command), of("test")) << command;
  }
  // The plan of the main job has no solver of these, which take 750 MB.
  for (const char* command : {"reproduce", "threshold"}) {
    EXPECT_FALSE(of(command).contains("libdlib-dev")) << command;
    EXPECT_FALSE(of(command).contains("petsc-dev")) << command;
    EXPECT_FALSE(of(command).contains("python3-scipy")) << command;
  }
  for (const char* plan : {"reproduction", "reproduction_quick"}) {
    const std::string text_of_plan =
        read(fs::path(RICOCHET_SOURCE) / "reports/plans" / (std::string(plan) + ".toml"));
    EXPECT_THAT(text_of_plan, testing::Not(HasSubstr("dlib")));
    EXPECT_THAT(text_of_plan, testing::Not(HasSubstr("tao-")));
    EXPECT_THAT(text_of_plan, testing::Not(HasSubstr("scipy-")));
    EXPECT_THAT(text_of_plan, testing::Not(HasSubstr("\"*\"")));
  }
}

TEST_F(EntryScript, ListsTheCommandsOfTheProgramBeforeItIsBuilt) {
  fs::remove_all(root_ / "checkout/build");
  const std::string help = call("--help").out;
  const std::size_t first = help.find("\nmachine:\n");
  ASSERT_NE(first, std::string::npos);
  const std::string commands = help.substr(first, help.find("\n\nExit codes", first) - first);
  EXPECT_THAT(script("checkout/ricochet help"), HasSubstr(commands + "\n"));
  EXPECT_THAT(script("checkout/ricochet help reproduce"), HasSubstr("reproduce is not built yet"));
  EXPECT_THAT(script("checkout/ricochet --help"), HasSubstr(commands + "\n"));
  EXPECT_THAT(script("checkout/ricochet reproduce --help"),
              AllOf(HasSubstr(commands + "\n"), HasSubstr("reproduce is not built yet")));
  EXPECT_FALSE(fs::exists(root_ / "log"));
}

TEST_F(EntryScript, BuildsNothingForHelp) {
  const fs::path folder = root_ / "checkout/build/release/src/app";
  EXPECT_EQ(script("checkout/ricochet list --help"), (folder / "ricochet").string() + "\n");
  EXPECT_EQ(script("checkout/ricochet --help"), (folder / "ricochet").string() + "\n");
  EXPECT_EQ(script("checkout/ricochet help list"), (folder / "ricochet").string() + "\n");
  EXPECT_THAT(script("checkout/ricochet help test"), HasSubstr("test --sanitize"));
  EXPECT_THAT(script("checkout/ricochet surrogate -h"), HasSubstr("surrogate is not built yet"));
  make_executable(folder / "ricochet-studies", "#!/bin/sh\n");
  EXPECT_EQ(script("checkout/ricochet surrogate -h"), (folder / "ricochet").string() + "\n");
  EXPECT_FALSE(fs::exists(root_ / "log"));
}

TEST_F(EntryScript, IsCalledWhereAnotherUserBuilt) {
  script("checkout/ricochet list");
  const fs::path built = root_ / "checkout/build/release";
  for (const auto& entry : fs::recursive_directory_iterator(root_)) {
    fs::permissions(entry.path(),
                    fs::perms::all & ~(fs::perms::owner_write | fs::perms::group_write |
                                       fs::perms::others_write));
  }
  const std::string call = "env HOME=/tmp " + as_another() + "checkout/ricochet list";
  EXPECT_THAT(script(call),
              AllOf(HasSubstr("build/release/src/app/ricochet\n"), Not(HasSubstr("failed"))));
  fs::permissions(root_ / "tools",
                  fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  tool("ninja", "echo '[1/1] Linking'\n");
  fs::permissions(root_ / "tools/ninja", fs::perms::all);
  EXPECT_THAT(script(call), AllOf(HasSubstr("is out of date, and belongs to "),
                                  HasSubstr("make a clone of your own"), HasSubstr("failed")));
  fs::permissions(built, fs::perms::owner_all);
}

}  // namespace
}  // namespace ricochet::cli
