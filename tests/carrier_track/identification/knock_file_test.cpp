#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/error.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

class KnockFile : public testing::Test {
 protected:
  KnockFile() { std::filesystem::create_directories(folder_); }
  ~KnockFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const auto path = folder_ / name;
    std::ofstream(path) << text;
    return path.string();
  }

  /// 30 knocks, a second apart.
  static std::string knocks(const std::string& header, const std::string& more) {
    std::string text = header + "\n";
    for (int i = 0; i < 30; ++i) text += fmt::format("{}.5{}\n", i, more);
    return text;
  }

  static std::string complaint(const KnockFiles& files) {
    try {
      read_knock_record(files);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(KnockFile, IsARecord) {
  KnockFiles files;
  files.knocks = write("knocks.csv", knocks("time,strength", ",2"));
  files.speed = write("speed.csv", "time,omega\n0,3\n40,5\n");
  const KnockRecord record = read_knock_record(files);
  EXPECT_EQ(record.knocks.size(), 30U);
  EXPECT_EQ(record.knocks[2].time, 2.5);
  EXPECT_EQ(record.knocks[2].strength, 2);
  EXPECT_EQ(record.from, 0);
  EXPECT_EQ(record.to, 40);
  EXPECT_EQ(speed_at(record.speed, 20), 4);
  EXPECT_FALSE(record.plate);
}

TEST_F(KnockFile, MayHoldTheSpeedOrNeedNone) {
  KnockFiles files;
  files.knocks = write("knocks.csv", knocks("time,omega", ",3"));
  EXPECT_EQ(speed_at(read_knock_record(files).speed, 7), 3);
  files.knocks = write("times.csv", knocks("time", ""));
  files.omega = 4;
  const KnockRecord record = read_knock_record(files);
  EXPECT_EQ(speed_at(record.speed, 7), 4);
  EXPECT_EQ(record.from, 0.5);
  EXPECT_EQ(record.to, 29.5);
}

TEST_F(KnockFile, MayComeWithMarks) {
  KnockFiles files;
  files.knocks = write("knocks.csv", knocks("time", ""));
  files.omega = 3.14159265;
  files.marks = write("marks.csv", "time\n1.5\n3.5\n5.5\n");
  const KnockRecord record = read_knock_record(files);
  ASSERT_TRUE(record.plate);
  EXPECT_NEAR(record.plate->phase, -3.14159265,
              1e-6);  // a mark passes a second, half a turn, later
}

TEST_F(KnockFile, IsRefusedWithItsPlace) {
  KnockFiles files;
  files.knocks = write("knocks.csv", knocks("time", ""));
  EXPECT_THAT(complaint(files), HasSubstr("one of --omega, --speed"));
  files.omega = 0.1;
  EXPECT_THAT(complaint(files), HasSubstr("turns"));
  files.omega = -1;
  EXPECT_THAT(complaint(files), HasSubstr("--omega -1"));
  files.omega = 4;
  files.speed = "speed.csv";
  EXPECT_THAT(complaint(files), HasSubstr("only one of"));
  files.speed = "";
  files.marks = write("marks.csv", "time\n1\n2\n");
  EXPECT_THAT(complaint(files), HasSubstr("three marks"));
  files.marks = "";
  files.knocks = write("few.csv", "time\n1\n2\n");
  EXPECT_THAT(complaint(files), HasSubstr("2 knocks: must have at least 20"));
  files.knocks = write("back.csv", "time\n2\n1\n");
  EXPECT_THAT(complaint(files), HasSubstr("back.csv:3: column time: 1: must be no earlier"));
  files.knocks = write("weak.csv", knocks("time,strength", ",0"));
  EXPECT_THAT(complaint(files), HasSubstr("weak.csv:2: column strength: 0: must be > 0"));
  files.knocks = write("slow.csv", knocks("time,omega", ",-1"));
  files.omega.reset();
  EXPECT_THAT(complaint(files), HasSubstr("slow.csv:2: column omega: -1"));
}

/// Speeds in another unit, clocks apart: doubted before anything is fitted.
TEST_F(KnockFile, IsDoubtedIfFilesContradictEachOther) {
  KnockFiles files;
  files.knocks = write("knocks.csv", knocks("time", ""));
  std::string marks = "time\n";  // at 4 rad/s
  for (int k = 1; k < 19; ++k) marks += fmt::format("{}\n", k * 1.5708);
  const auto with_speed = [&](double omega) {
    files.speed = write("speed.csv", fmt::format("time,omega\n0,{}\n30,{}\n", omega, omega));
    return complaint(files);
  };
  EXPECT_EQ(with_speed(4), "");
  EXPECT_THAT(with_speed(38.2), HasSubstr("0.17 a turn: must be at least 1"));
  EXPECT_THAT(with_speed(229), HasSubstr("a turn: must be at least 1"));
  files.marks = write("marks.csv", marks);
  EXPECT_EQ(with_speed(4), "");
  EXPECT_EQ(with_speed(4.3), "");
  EXPECT_THAT(with_speed(38.2), HasSubstr("in rpm"));
  EXPECT_THAT(with_speed(229), HasSubstr("in degrees per second"));
  EXPECT_THAT(with_speed(0.6366), HasSubstr("in turns per second"));
  EXPECT_THAT(with_speed(2), HasSubstr("two marks"));
  EXPECT_THAT(with_speed(5), HasSubstr("1.25 turns"));
  for (const double apart : {16.0, 100.0, -1e4}) {
    files.marks = "";
    files.speed = write("far.csv", fmt::format("time,omega\n{},4\n{},4\n", apart, apart + 30));
    EXPECT_THAT(complaint(files), HasSubstr("do the clocks differ?")) << apart;
    files.speed = write("speed.csv", "time,omega\n0,4\n30,4\n");
    std::string far = "time\n";
    for (int k = 0; k < 19; ++k) far += fmt::format("{}\n", apart + k * 1.5708);
    files.marks = write("marks.csv", far);
    EXPECT_THAT(complaint(files), HasSubstr("do the clocks differ?")) << apart;
  }
  files.marks = "";
  files.lag_deviation = 1;
  EXPECT_THAT(complaint(files), HasSubstr("--lag-deviation 1"));
  files.lag_deviation = 0;
  files.mark_deviation = -1;
  EXPECT_THAT(complaint(files), HasSubstr("--mark-deviation -1"));
}

TEST(KnockFiles, OfOtherMachinesSayNothing) {
  const auto complaint = [](auto change) -> std::string {
    Scene scene = knocking_machine();
    change(scene);
    try {
      check_identifiable(scene, "m.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint([](Scene&) {}), "");
  EXPECT_THAT(complaint([](Scene& s) { s.fidelity = Fidelity::compliant; }),
              HasSubstr("m.toml: model.fidelity"));
  EXPECT_THAT(complaint([](Scene& s) { s.restitution_lower = 0.4; }), HasSubstr("restitution"));
  EXPECT_THAT(complaint([](Scene& s) { s.friction = 0; }), HasSubstr("friction"));
  EXPECT_THAT(complaint([](Scene& s) { s.disturbance = 1; }), HasSubstr("disturbance"));
  EXPECT_THAT(complaint([](Scene& s) { s.centrifugal_mass_radius = 0; }), HasSubstr("centrifugal"));
  EXPECT_THAT(complaint([](Scene& s) { s.wall_upper = INFINITY; }), HasSubstr("wall_upper"));
}

}  // namespace
}  // namespace ricochet::carrier_track
