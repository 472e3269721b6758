#include "src/benchmark/experiment/store/xz.h"

#include <fmt/format.h>
#include <lzma.h>

#include <array>
#include <cstdint>
#include <new>

#include "ricochet/error.h"

namespace ricochet {
namespace {

constexpr std::string_view magic = std::string_view(
    "\xFD"
    "7zXZ\0",
    6);

const std::uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

/// A decoder of liblzma, freed at the end.
class Decoder {
 public:
  Decoder() {
    constexpr std::uint64_t most_memory = 100'000'000;  // our own files need 65 MB
    if (lzma_stream_decoder(&stream_, most_memory, 0) != LZMA_OK) throw std::bad_alloc();
  }
  ~Decoder() { lzma_end(&stream_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  lzma_stream& stream() { return stream_; }

 private:
  lzma_stream stream_ = LZMA_STREAM_INIT;
};

}  // namespace

bool is_xz(std::string_view bytes) {
  return bytes.starts_with(magic);
}

std::string xz_compressed(std::string_view bytes) {
  std::string file(lzma_stream_buffer_bound(bytes.size()), '\0');
  std::size_t size = 0;
  const lzma_ret result = lzma_easy_buffer_encode(
      9 | LZMA_PRESET_EXTREME, LZMA_CHECK_CRC64, nullptr, bytes_of(bytes), bytes.size(),
      reinterpret_cast<std::uint8_t*>(file.data()), &size, file.size());
  if (result != LZMA_OK) throw std::bad_alloc();
  file.resize(size);
  return file;
}

std::string xz_decompressed(std::string_view file, std::size_t most) {
  Decoder decoder;
  lzma_stream& stream = decoder.stream();
  stream.next_in = bytes_of(file);
  stream.avail_in = file.size();
  std::string bytes;
  std::array<std::uint8_t, 1 << 16> some{};
  for (;;) {
    stream.next_out = some.data();
    stream.avail_out = some.size();
    const lzma_ret result = lzma_code(&stream, LZMA_FINISH);
    bytes.append(reinterpret_cast<const char*>(some.data()), some.size() - stream.avail_out);
    if (bytes.size() > most) throw InputError(fmt::format("holds more than {} bytes", most));
    if (result == LZMA_STREAM_END) {
      if (stream.avail_in == 0) return bytes;
      throw InputError(fmt::format("has {} bytes behind its end", stream.avail_in));
    }
    if (result == LZMA_MEM_ERROR) throw std::bad_alloc();
    if (result == LZMA_MEMLIMIT_ERROR) throw InputError("needs more memory than our archives do");
    if (result != LZMA_OK) throw InputError("is damaged or cut off: it cannot be decompressed");
  }
}

}  // namespace ricochet
