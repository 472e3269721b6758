#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "ricochet/error.h"
#include "src/experiment/archive.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Text with repetitions, of this length.
std::string some_text(std::size_t length) {
  std::mt19937_64 random(length);
  std::string text;
  while (text.size() < length) text += std::to_string(random() % 1000) + ",";
  text.resize(length);
  return text;
}

TEST(Xz, ReturnsWhatWasCompressed) {
  for (const std::size_t length : {0UL, 1UL, 65'536UL, 500'000UL}) {
    const std::string text = some_text(length);
    const std::string file = xz_compressed(text);
    EXPECT_TRUE(is_xz(file));
    EXPECT_EQ(xz_decompressed(file, length), text) << length;
    if (length > 1000) {
      EXPECT_LT(file.size(), length / 2);
    }
  }
  EXPECT_FALSE(is_xz("SQLite format 3"));
  EXPECT_FALSE(is_xz(""));
}

TEST(Xz, RefusesWhatIsDamagedCutOffOrTooLarge) {
  const std::string file = xz_compressed(some_text(10'000));
  std::string damaged = file;
  damaged[file.size() / 2] ^= 1;
  for (const std::string& bad : {damaged, file.substr(0, file.size() / 2), std::string("text")}) {
    EXPECT_THAT([&] { xz_decompressed(bad, 10'000); },
                ThrowsMessage<InputError>(HasSubstr("damaged or cut off")));
  }
  EXPECT_THAT([&] { xz_decompressed(file, 9'999); },
              ThrowsMessage<InputError>(HasSubstr("more than 9999 bytes")));
}

}  // namespace
}  // namespace ricochet
