#include <unistd.h>

#include <regex>

#include "tests/app/tool.h"

/// The script that builds and calls the program, on a checkout of nothing but itself. What it calls
/// are stand-ins that write down how they were called.
namespace ricochet::cli {
namespace {

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

  static void tool(const std::string& name, const std::string& text) {
    write_program("tools/" + name, "#!/usr/bin/env bash\n" + text);
  }
  static void make_checkout(const std::string& folder) {
    write_program(folder + "/build/release/src/app/ricochet", "#!/bin/sh\necho \"$0\"\n");
    fs::copy_file(RICOCHET_SOURCE "/ricochet", here() / folder / "ricochet");
  }

  /// What the call printed; "failed" is added to it if it failed.
  static std::string script(const std::string& call) {
    return call_in_shell(filled("exec 2>&1; PATH={0}/tools:$PATH LOG={0}/log {1} || echo failed",
                                root(), call))
        .out;
  }
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
  EXPECT_EQ(read("log"), filled("cmake --preset release --fresh in {}/checkout\n", root()));
}

TEST_F(EntryScript, OfACopiedCheckoutConfiguresTheCopy) {
  script("checkout/ricochet list cases");
  fs::copy(here() / "checkout", here() / "copy", fs::copy_options::recursive);
  EXPECT_THAT(script("copy/ricochet list cases"), HasSubstr(called("ricochet", "copy")));
  EXPECT_THAT(read("log"), HasSubstr(filled("--fresh in {}/copy\n", root())));
  const std::string before = read("log");
  EXPECT_THAT(script("copy/ricochet list cases"), Not(HasSubstr("configuring")));
  EXPECT_EQ(read("log"), before);
}

TEST_F(EntryScript, ForgetsACompilerThatWasBroken) {
  EXPECT_THAT(script("CXX=broken checkout/ricochet list cases"), HasSubstr("failed"));
  EXPECT_THAT(script("checkout/ricochet list cases"), Not(HasSubstr("failed")));
  const std::string configured = filled("cmake --preset release --fresh in {}/checkout\n", root());
  EXPECT_EQ(read("log"), configured + configured);
}

TEST_F(EntryScript, BuildsForTheMainJobItsOwnProgramAlone) {
  write_program(apps_ + "ricochet-reproduce", "#!/bin/sh\necho \"$0 $*\"\n");
  fs::remove(here() / apps_ / "ricochet");
  tool("ninja", "echo \"ninja $*\" >> \"$LOG\"\necho 'ninja: no work to do.'\n");
  EXPECT_THAT(script("checkout/ricochet reproduce --quick"),
              HasSubstr(called("ricochet-reproduce") + " reproduce --quick"));
  EXPECT_THAT(read("log"), HasSubstr("-n ricochet_reproduce\n"));
}

TEST_F(EntryScript, InstallsTheSameSolversForAllThatRunsThem) {
  write_program(
      "checkout/ricochet",
      std::regex_replace(read("checkout/ricochet"), std::regex("/var/lib/dpkg/info"), "/nothing"));
  // The Debian packages with solvers among all that a command installs on a system with none.
  const auto of = [&](const std::string& command) {
    const std::string asked = script("checkout/ricochet --no-install " + command);
    static const std::regex package(
        R"(\S*(dlib|petsc|nlopt|ipopt|pagmo|ceres)\S*-dev\b|python3-scipy\b)");
    using Found = std::sregex_token_iterator;
    return std::set<std::string>(Found(asked.begin(), asked.end(), package), Found());
  };
  EXPECT_THAT(of("test"),
              ElementsAre("coinor-libipopt-dev", "libceres-dev", "libdlib-dev", "libnlopt-cxx-dev",
                          "libpagmo-dev", "petsc-dev", "python3-scipy"));
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
  EXPECT_THAT(script("checkout/ricochet --help"), commands);
  EXPECT_THAT(script("checkout/ricochet help reproduce"), not_built);
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
  write_program(apps_ + "ricochet-studies", "#!/bin/sh\n");
  EXPECT_EQ(script("checkout/ricochet surrogate -h"), program);
  EXPECT_FALSE(exists("log"));
}

TEST_F(EntryScript, IsCalledWhereAnotherUserBuilt) {
  script("checkout/ricochet list");
  call_in_shell("chmod -R 0555 .");
  // Another user's where this one may write everywhere.
  const std::string call =
      filled("env HOME=/tmp {} checkout/ricochet list",
             geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "");
  EXPECT_THAT(script(call),
              AllOf(HasSubstr("build/release/src/app/ricochet\n"), Not(HasSubstr("failed"))));
  call_in_shell("chmod u+w tools tools/ninja");
  tool("ninja", "echo '[1/1] Linking'\n");
  call_in_shell("chmod 0755 tools/ninja");
  EXPECT_THAT(script(call), AllOf(HasSubstr("is out of date, and belongs to "),
                                  HasSubstr("make a clone of your own"), HasSubstr("failed")));
  call_in_shell("chmod -R u+w .");
}

}  // namespace
}  // namespace ricochet::cli
