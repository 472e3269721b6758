#include <gtest/gtest.h>

#include "src/report/drawing.h"
#include "src/report/json.h"

namespace ricochet::report {
namespace {

TEST(ScriptText, HasTheSameDataAndEndsNoScript) {
  const report::Json data = {"</script><b>", "a < b"};
  const std::string text = json_in_script(data.dump());
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(report::Json::parse(text), data);
}

}  // namespace
}  // namespace ricochet::report
