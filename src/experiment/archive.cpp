#include "src/experiment/archive.h"

#include <fmt/format.h>
#include <lzma.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/experiment/merge.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

constexpr const char* mark = "archive";
constexpr double much_better = 0.01;  // of the optimality gap

/// The most bytes that an archive of this size may hold: a store is some ten times larger.
constexpr std::size_t most_bytes(std::size_t size) {
  return std::min(1UL << 32U, 1'000'000 + 100 * size);
}

/// Two significant digits of a time [s] > 0.
double rounded(double seconds) {
  if (!(seconds > 0)) return seconds;
  const double unit = std::pow(10, std::floor(std::log10(seconds)) - 1);
  return std::round(seconds / unit) * unit;
}

constexpr int bits_on_the_way = 6, bits_at_the_end = 20;

/// A number above `from`, rounded up so that so many bits of its distance are kept.
double rounded_up(double number, double from, int bits) {
  const double distance = number - from;
  if (!(distance > 0) || !std::isfinite(distance)) return number;
  const double unit = std::ldexp(1.0, std::ilogb(distance) - bits);
  const double rounded = std::ceil(number / unit) * unit;
  return std::isfinite(rounded) ? rounded : number;
}

/// Keeps so many bits of a violation, and of an optimality gap that does not solve the problem.
void round_up(TrueValues& values, const StoredProblem& problem, int bits) {
  values.violation = rounded_up(values.violation, 0, bits);
  if (values.objective - problem.best_known > problem.tolerance) {
    values.objective = rounded_up(values.objective, problem.best_known, bits);
  }
}

std::vector<Improvement> thinned(std::vector<Improvement> trace, const StoredProblem& problem,
                                 const std::optional<ReturnedPoint>& returned) {
  std::vector<Improvement> kept;
  const auto gap_of = [&](const Improvement& step) {
    return step.true_values.objective - problem.best_known;
  };
  double last = std::numeric_limits<double>::infinity();
  bool feasible = false;
  bool as_good = false;
  for (std::size_t k = 0; k < trace.size(); ++k) {
    Improvement& step = trace[k];
    const bool is_feasible = step.true_values.violation <= 0;
    const double gap = gap_of(step);
    const bool first_feasible = is_feasible && !feasible;
    const bool better = is_feasible && gap <= much_better * last;
    const bool solves = is_feasible && gap <= problem.tolerance && !(last <= problem.tolerance);
    const bool returns = is_feasible && !as_good && returned &&
                         step.true_values.objective <= returned->true_values.objective;
    feasible |= is_feasible;
    as_good |= returns;
    if (!(first_feasible || better || solves || returns || k + 1 == trace.size())) continue;
    if (is_feasible) last = gap;
    step.x = Vector();
    step.seconds = solves ? rounded(step.seconds) : 0;
    const bool on_the_way = !solves && !returns && k + 1 < trace.size();
    round_up(step.true_values, problem, on_the_way ? bits_on_the_way : bits_at_the_end);
    kept.push_back(std::move(step));
  }
  return kept;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

RunRecord thinned(RunRecord record, const StoredProblem& problem) {
  record.seed = 0;
  record.ledger.seconds = rounded(record.ledger.seconds);
  record.trace = thinned(std::move(record.trace), problem, record.returned);
  if (record.returned) {
    round_up(record.returned->true_values, problem, bits_at_the_end);
    record.returned->x = Vector();
  }
  return record;
}

std::string difference_when_repeated(const CampaignDescription& description,
                                     const StoredRun& stored, const RunRecord& again) {
  const std::vector<StoredPart> parts = parts_of(stored.record);
  std::string differs = difference(parts_of(again), parts);
  if (differs.empty() || !is_archived(description)) return differs;
  const auto problem =
      std::ranges::find(description.problems, stored.key.cell.problem, &StoredProblem::name);
  return difference(parts_of(thinned(again, *problem)), parts);
}

bool is_archived(const CampaignDescription& description) {
  return description.made.contains(mark);
}

void mark_archived(CampaignDescription& description) {
  description.made[mark] = "without points and seeds, times to two digits";
}

void write_archive(const Store& store, const fs::path& out,
                   const std::function<bool(const RunKey&)>& wanted,
                   const std::map<std::string, std::string>& notes) {
  CampaignDescription description = store.description();
  for (const auto& [name, value] : notes) description.made[name] = value;
  mark_archived(description);
  std::map<std::string, const StoredProblem*> problems;
  for (const StoredProblem& problem : store.description().problems) {
    problems[problem.name] = &problem;
  }
  const ScratchFolder folder;
  const fs::path packed = folder.path() / "runs.sqlite";
  Store::write(packed, description, [&](const Store::AddRun& add) {
    store.each([&](const StoredRun& run) {
      if (!wanted(run.key)) return;
      add(run.key, thinned(run.record, *problems.at(run.key.cell.problem)));
    });
  });
  Store::pack(packed);  // a tenth less
  write_text_file(out, xz_compressed(bytes_of(packed)));
}

bool is_archive(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return false;  // to read a pipe might wait forever
  std::ifstream in(file, std::ios::binary);
  std::string first(8, '\0');
  in.read(first.data(), static_cast<std::streamsize>(first.size()));
  return is_xz(std::string_view(first).substr(0, static_cast<std::size_t>(in.gcount())));
}

void unpack_archive(const fs::path& archive, const fs::path& out) {
  std::string store;
  try {
    const std::string packed = bytes_of(archive);
    store = xz_decompressed(packed, most_bytes(packed.size()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", archive.string(), error.what()));
  }
  write_text_file(out, store);
}

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
