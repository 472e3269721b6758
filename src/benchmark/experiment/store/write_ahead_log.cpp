#include "src/benchmark/experiment/store/write_ahead_log.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "src/benchmark/experiment/store/sqlite_values.h"

namespace ricochet {
namespace {

constexpr std::size_t header_size = 32;
constexpr std::size_t frame_header_size = 24;
constexpr std::uint32_t log_magic = 0x377f0682;  // its last bit: checksums are of big-endian words

std::uint32_t word_at(std::span<const char> bytes, std::size_t place, bool big_endian = true) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t byte = big_endian ? k : 3 - k;
    word = word << 8U | static_cast<unsigned char>(bytes[place + byte]);
  }
  return word;
}

struct Checksum {
  bool big_endian;
  std::array<std::uint32_t, 2> sums = {};

  void add(std::span<const char> bytes) {
    for (std::size_t place = 0; place + 8 <= bytes.size(); place += 8) {
      sums[0] += word_at(bytes, place, big_endian) + sums[1];
      sums[1] += word_at(bytes, place + 4, big_endian) + sums[0];
    }
  }
  bool is_at(std::span<const char> bytes, std::size_t place) const {
    return sums[0] == word_at(bytes, place) && sums[1] == word_at(bytes, place + 4);
  }
};

[[noreturn]] void damaged(const std::filesystem::path& log) {
  throw Damage(log.filename().string() +
               " beside it is damaged; without that file its earlier runs can be read");
}

}  // namespace

void check_log(const std::filesystem::path& log) {
  std::ifstream in(log, std::ios::binary);
  std::array<char, header_size> header{};
  if (in.peek() == std::ifstream::traits_type::eof()) return;
  if (!in.read(header.data(), header.size())) return;  // torn: nothing was written after it
  if ((word_at(header, 0) & ~1U) != log_magic) damaged(log);
  Checksum sum{(word_at(header, 0) & 1U) != 0};
  const std::uint32_t page_size = word_at(header, 8);
  sum.add(std::span(header).first(24));
  constexpr std::uint32_t largest_page = 65536;
  if (!sum.is_at(header, 24) || page_size < 512 || page_size > largest_page) damaged(log);
  std::vector<char> frame(frame_header_size + page_size);
  const std::string salts(header.data() + 16, 8);
  bool is_torn = false;
  while (in.read(frame.data(), static_cast<std::streamsize>(frame.size())) &&
         std::string(frame.data() + 8, 8) == salts) {
    if (is_torn) damaged(log);
    sum.add(std::span(frame).first(8));
    sum.add(std::span(frame).subspan(frame_header_size));
    is_torn = !sum.is_at(frame, 16);
  }
}

}  // namespace ricochet
