#include <unistd.h>

#include <regex>

#include "tests/app/tool.h"
#include "tests/support/test.h"

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
    if (const auto reason = missing({"/var/lib/dpkg/info/libeigen3-dev.list"}); !reason.empty()) {
      GTEST_SKIP() << "no Debian: " << reason;
    }
    make_checkout("checkout");
    tool("cmake",
         "echo \"cmake $* in $PWD\" >> \"$LOG\"\n"
         "[[ ${CXX:-} != broken ]] || { touch -a build/release/CMakeCache.txt; exit 1; }\n"
         "mkdir -p build/release\n"
         "echo \"CMAKE_HOME_DIRECTORY:INTERNAL=$PWD\" > build/release/CMakeCache.txt\n"
         "touch build/release/build.ninja\n");
    tool("ninja", "echo 'ninja: no work to do.'\n");
    tool("apt-get", "exit 1\n");
  }

  static void make_executable(const std::string& name, const std::string& text) {
    write(name, text);
    fs::permissions(here() / name, fs::perms::owner_all);
  }
  static void tool(const std::string& name, const std::string& text) {
    make_executable("tools/" + name, "#!/usr/bin/env bash\n" + text);
  }
  static void make_checkout(const std::string& folder) {
    make_executable(folder + "/build/release/src/app/ricochet", "#!/bin/sh\necho \"$0\"\n");
    fs::copy_file(RICOCHET_SOURCE "/ricochet", here() / folder / "ricochet");
  }

  /// As another user where this one may write everywhere.
  static std::string as_another() {
    return geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  }

  /// What the call printed; "failed" is added to it if it failed.
  static std::string script(const std::string& call) {
    return call_in_shell(filled("exec 2>&1; PATH={0}/tools:$PATH LOG={0}/log {1} || echo failed",
                                root(), call))
        .out;
  }
  static std::string log() { return read("log"); }
  static fs::path root() { return fs::canonical(here()); }

  /// What the stand-in of a program of the checkout prints.
  static std::string called(const std::string& program, const std::string& checkout = "checkout") {
    return filled("{}/{}/build/release/src/app/{}", root(), checkout, program);
  }

  const std::string apps_ = "checkout/build/release/src/app/";
};

TEST_F(EntryScript, CallsTheProgramOfItsOwnCheckout) {
  const std::string program = called("ricochet") + "\n";
  EXPECT_THAT(script("checkout/ricochet list cases"), HasSubstr(program));
  fs::create_directory(here() / "bin");
  fs::create_symlink("../checkout/ricochet", here() / "bin/link");
  make_checkout("other/checkout");
  for (const char* call : {"bin/link list cases", "CDPATH=/usr:. checkout/ricochet list cases",
                           "CDPATH=other checkout/ricochet list cases"}) {
    EXPECT_EQ(script(call), program) << call;
  }
  EXPECT_EQ(log(), filled("cmake --preset release --fresh in {}/checkout\n", root()));
}

TEST_F(EntryScript, OfACopiedCheckoutConfiguresTheCopy) {
  script("checkout/ricochet list cases");
  fs::copy(here() / "checkout", here() / "copy", fs::copy_options::recursive);
  EXPECT_THAT(script("copy/ricochet list cases"), HasSubstr(called("ricochet", "copy")));
  EXPECT_THAT(log(), HasSubstr(filled("--fresh in {}/copy\n", root())));
  const std::string before = log();
  EXPECT_THAT(script("copy/ricochet list cases"), Not(HasSubstr("configuring")));
  EXPECT_EQ(log(), before);
}

TEST_F(EntryScript, ForgetsACompilerThatWasBroken) {
  EXPECT_THAT(script("CXX=broken checkout/ricochet list cases"), HasSubstr("failed"));
  EXPECT_THAT(script("checkout/ricochet list cases"), Not(HasSubstr("failed")));
  const std::string configured = filled("cmake --preset release --fresh in {}/checkout\n", root());
  EXPECT_EQ(log(), configured + configured);
}

TEST_F(EntryScript, BuildsForTheMainJobItsOwnProgramAlone) {
  make_executable(apps_ + "ricochet-reproduce", "#!/bin/sh\necho \"$0 $*\"\n");
  fs::remove(here() / apps_ / "ricochet");
  tool("ninja", "echo \"ninja $*\" >> \"$LOG\"\necho 'ninja: no work to do.'\n");
  EXPECT_THAT(script("checkout/ricochet reproduce --quick"),
              HasSubstr(called("ricochet-reproduce") + " reproduce --quick"));
  EXPECT_THAT(log(), HasSubstr("-n ricochet_reproduce\n"));
}

/// The Debian packages with solvers among all that a command installs on a system with none.
std::set<std::string> solver_packages(const std::string& asked) {
  static const std::regex package("(.*(dlib|petsc|nlopt|ipopt|pagmo|ceres).*-dev|python3-scipy)");
  std::set<std::string> found;
  std::istringstream words(asked);
  for (std::string word; words >> word;) {
    if (std::regex_match(word, package)) found.insert(word);
  }
  return found;
}

TEST_F(EntryScript, InstallsTheSameSolversForAllThatRunsThem) {
  make_executable(
      "checkout/ricochet",
      std::regex_replace(read("checkout/ricochet"), std::regex("/var/lib/dpkg/info"), "/nothing"));
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
    for (const char* package : {"libdlib-dev", "petsc-dev", "python3-scipy"}) {
      EXPECT_FALSE(of(command).contains(package)) << command << package;
    }
  }
  for (const std::string plan : {"reproduction", "reproduction_quick"}) {
    EXPECT_THAT(read(RICOCHET_SOURCE "/reports/plans/" + plan + ".toml"),
                AllOf(HasSubstr("solvers"), Not(HasSubstr("dlib")), Not(HasSubstr("tao-")),
                      Not(HasSubstr("scipy-")), Not(HasSubstr("\"*\""))));
  }
}

TEST_F(EntryScript, ListsTheCommandsOfTheProgramBeforeItIsBuilt) {
  fs::remove_all(here() / "checkout/build");
  const std::string help = out_of("--help");
  const std::size_t first = help.find("\nmachine:\n");
  ASSERT_NE(first, std::string::npos);
  const auto commands =
      HasSubstr(help.substr(first, help.find("\n\nExit codes", first) - first) + "\n");
  const auto not_built = HasSubstr("reproduce is not built yet");
  EXPECT_THAT(script("checkout/ricochet help"), commands);
  EXPECT_THAT(script("checkout/ricochet help reproduce"), not_built);
  EXPECT_THAT(script("checkout/ricochet --help"), commands);
  EXPECT_THAT(script("checkout/ricochet reproduce --help"), AllOf(commands, not_built));
  EXPECT_FALSE(exists("log"));
}

TEST_F(EntryScript, BuildsNothingForHelp) {
  const std::string program = called("ricochet") + "\n";
  for (const std::string arguments : {"list --help", "--help", "help list"}) {
    EXPECT_EQ(script("checkout/ricochet " + arguments), program) << arguments;
  }
  EXPECT_THAT(script("checkout/ricochet help test"), HasSubstr("test --sanitize"));
  EXPECT_THAT(script("checkout/ricochet surrogate -h"), HasSubstr("surrogate is not built yet"));
  make_executable(apps_ + "ricochet-studies", "#!/bin/sh\n");
  EXPECT_EQ(script("checkout/ricochet surrogate -h"), program);
  EXPECT_FALSE(exists("log"));
}

TEST_F(EntryScript, IsCalledWhereAnotherUserBuilt) {
  script("checkout/ricochet list");
  for (const auto& entry : fs::recursive_directory_iterator(here())) {
    fs::permissions(entry.path(),
                    fs::perms::all & ~(fs::perms::owner_write | fs::perms::group_write |
                                       fs::perms::others_write));
  }
  const std::string call = "env HOME=/tmp " + as_another() + "checkout/ricochet list";
  EXPECT_THAT(script(call),
              AllOf(HasSubstr("build/release/src/app/ricochet\n"), Not(HasSubstr("failed"))));
  fs::permissions(here() / "tools",
                  fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(here() / "tools/ninja", fs::perms::all);
  tool("ninja", "echo '[1/1] Linking'\n");
  fs::permissions(here() / "tools/ninja", fs::perms::all);
  EXPECT_THAT(script(call), AllOf(HasSubstr("is out of date, and belongs to "),
                                  HasSubstr("make a clone of your own"), HasSubstr("failed")));
  fs::permissions(here() / "checkout/build/release", fs::perms::owner_all);
}

}  // namespace
}  // namespace ricochet::cli
