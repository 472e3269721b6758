#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "ricochet/error.h"
#include "src/studies/calibration/fit.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::filesystem::path fresh_file() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      (std::string("fits_") + std::to_string(getpid()) + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / "fits.toml";
}

/// Its loss is that of some_fit().
AskedFit some_asked() {
  return {
      "fit by one, seed 1", some_parameterisation(), {"C2"}, "30 evaluations", [](const Fit& fit) {
        return fit.constants[0] + 1.0 / 3;
      }};
}

Fit some_fit() {
  Fit fit{some_parameterisation().interpretation,
          some_parameterisation().free,
          some_parameterisation().held,
          0,
          {"C2"}};
  fit.constants[0] = 1.0 / 7;
  fit.loss = 1.0 / 7 + 1.0 / 3;
  return fit;
}

std::filesystem::path file_with_a_fit() {
  auto file = fresh_file();
  FitStore(file).add({some_asked()}, {some_fit()});
  return file;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What is said of the file once this pattern has another text in it.
std::string termination_reason_with(const std::string& pattern, const std::string& instead) {
  const auto file = file_with_a_fit();
  const std::string changed = std::regex_replace(text_of(file), std::regex(pattern), instead,
                                                 std::regex_constants::format_first_only);
  EXPECT_NE(changed, text_of(file)) << pattern;
  std::ofstream(file) << changed;
  std::string said;
  try {
    FitStore(file).find(some_asked());
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_EQ(text_of(file), changed);
  return said;
}

TEST(FitStore, FindsWhatItWasGivenBitForBitAlsoAfterwards) {
  const auto file = fresh_file();
  {
    FitStore store(file);
    EXPECT_FALSE(store.find(some_asked()));
    store.add({some_asked()}, {some_fit()});
  }
  const auto found = FitStore(file).find(some_asked());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->constants, some_fit().constants);
  EXPECT_EQ(found->loss, some_fit().loss);
  EXPECT_EQ(found->free, some_fit().free);
  EXPECT_EQ(found->interpretation, some_fit().interpretation);
  EXPECT_EQ(found->left_out, CaseIds{"C2"});
}

TEST(FitStore, RefusesAFileOfSomethingElse) {
  for (const char* text : {"not toml at all [", "[scene]\nmass = 1\n", "[[trial]]\nkey = 'a'\n"}) {
    const auto file = fresh_file();
    std::ofstream(file) << text;
    EXPECT_THROW(FitStore{file}, InputError) << text;
  }
}

TEST(FitStore, RefusesFitsOfAnotherVersion) {
  EXPECT_THAT(
      termination_reason_with("version = 3", "version = 4"),
      AllOf(HasSubstr("fits.toml"), HasSubstr("version 4 of the suite, this is version 3")));
  EXPECT_THAT(termination_reason_with("version = 3", ""), HasSubstr("of version 1 of the suite"));
}

TEST(FitStore, RefusesFitsToOtherData) {
  EXPECT_THAT(termination_reason_with("data = \".", "data = \"x"),
              AllOf(HasSubstr("fits.toml"), HasSubstr("other cases, claims or bounds")));
}

TEST(FitStore, RefusesALossThatIsNotThatOfItsConstants) {
  EXPECT_THAT(termination_reason_with("loss = [0-9.]+", "loss = 0.125"),
              AllOf(HasSubstr("fits.toml"), HasSubstr(some_asked().name()),
                    HasSubstr("has loss 0.125, but its constants have 0.476")));
  EXPECT_THAT(termination_reason_with("constants = \\[0.14", "constants = [0.24"),
              HasSubstr("has loss 0.476"));
}

TEST(FitStore, RefusesAFileThatIsCutShort) {
  const auto file = file_with_a_fit();
  FitStore(file).add({some_asked()}, {some_fit()});
  AskedFit another = some_asked();
  another.left_out = {"C3"};
  FitStore(file).add({another}, {some_fit()});
  const std::string whole = text_of(file);
  ASSERT_NO_THROW(FitStore{file});
  const std::size_t last = whole.find_last_not_of('\n') + 1;
  for (std::size_t size = 0; size < last; ++size) {
    std::ofstream(file) << whole.substr(0, size);
    try {
      FitStore store(file);
      // A number that has lost its last digits is another number.
      EXPECT_THROW(store.find(another), InputError) << whole.substr(0, size);
    } catch (const InputError&) {
    }
  }
}

TEST(FitStore, SaysOnceThatAFitIsThereByOtherOptionsAndKeepsBoth) {
  const auto file = file_with_a_fit();
  AskedFit longer = some_asked();
  longer.options = "60 evaluations";
  FitStore store(file);
  testing::internal::CaptureStderr();
  EXPECT_FALSE(store.find(longer));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("fits.toml"), HasSubstr(longer.name()),
                    HasSubstr("30 evaluations in place of 60 evaluations"),
                    testing::MatchesRegex("[^\n]*\n")));
  testing::internal::CaptureStderr();
  EXPECT_FALSE(store.find(longer));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
  store.add({longer}, {some_fit()});
  EXPECT_TRUE(FitStore(file).find(longer));
  EXPECT_TRUE(FitStore(file).find(some_asked()));
}

TEST(FitStore, SaysNothingOfWhatItsOwnRunHasMade) {
  FitStore store(fresh_file());
  store.add({some_asked()}, {some_fit()});
  AskedFit longer = some_asked();
  longer.options = "60 evaluations";
  testing::internal::CaptureStderr();
  EXPECT_FALSE(store.find(longer));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST(FitStore, HasANameForEverythingThatDecidesButTheOptions) {
  const std::string name = some_asked().name();
  EXPECT_EQ(some_asked().name(), name);
  AskedFit asked = some_asked();
  asked.kind = "pin by one, seed 1";
  EXPECT_NE(asked.name(), name);
  asked = some_asked();
  asked.left_out = {};
  EXPECT_NE(asked.name(), name);
  asked = some_asked();
  asked.parameterisation.held[0] *= 1 + 1e-15;
  EXPECT_NE(asked.name(), name);
  asked = some_asked();
  asked.parameterisation.free.pop_back();
  EXPECT_NE(asked.name(), name);
  asked = some_asked();
  asked.parameterisation.interpretation.tension = Tension::rotating;
  EXPECT_NE(asked.name(), name);
}

TEST(OptionsOf, TellTheSolversTheirVersionsAndTheEvaluations) {
  Search search{{}, {}, {}, 30};
  search.global.name = "one";
  search.global.version = "library 1.2";
  EXPECT_EQ(options_of(search), "30 evaluations, one (library 1.2)");
}

TEST(DataHash, IsAnotherForOtherClaimsAndOtherBounds) {
  const std::string own = data_hash(all_cases(), unknown_parameters());
  EXPECT_EQ(data_hash(all_cases(), unknown_parameters()), own);
  std::vector<Case> cases = all_cases();
  cases[2].claim.threshold = *cases[2].claim.threshold + 1e-9;
  EXPECT_NE(data_hash(cases, unknown_parameters()), own);
  cases = all_cases();
  cases[2].claim.quiet_count = *cases[2].claim.quiet_count + 1;
  EXPECT_NE(data_hash(cases, unknown_parameters()), own);
  cases = all_cases();
  cases[11].disturbance *= 2;
  EXPECT_NE(data_hash(cases, unknown_parameters()), own);
  std::vector<UnknownParameter> parameters = unknown_parameters();
  parameters[3].upper *= 2;
  EXPECT_NE(data_hash(all_cases(), parameters), own);
}

}  // namespace
}  // namespace ricochet::studies::calibration
