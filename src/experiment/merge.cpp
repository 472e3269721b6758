#include "src/experiment/merge.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/experiment/draft_store.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/stored_fields.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

/// The description of all parts.
CampaignDescription joined(const fs::path& first, const CampaignDescription& ours,
                           const fs::path& part, const CampaignDescription& theirs,
                           const United& united) {
  const std::string differs = difference(parts_of(ours), parts_of(theirs));
  if (differs.empty()) return ours;
  try {
    if (united) return united(ours, theirs);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: cannot be joined with {}: {}", part.string(), first.string(),
                                 error.what()));
  }
  throw InputError(fmt::format("{}: is of another campaign than {}, from which it differs in {}",
                               part.string(), first.string(), differs));
}

void add(RunRows& rows, const StoredRun& run, const fs::path& part) {
  const auto there = rows.find(run.key);
  if (!there) return rows.add(run.key, run.record);
  const std::string differs = difference(parts_of(there->record), parts_of(run.record));
  if (differs.empty()) return;
  throw InputError(fmt::format("{}: {} differs in {} from what a file before it has", part.string(),
                               name_of(run.key), differs));
}

}  // namespace

void merge(const std::vector<fs::path>& parts, const fs::path& out, const United& united,
           const std::map<std::string, std::string>& made) {
  if (parts.empty()) throw InputError(fmt::format("{}: there is nothing to merge", out.string()));
  // One at a time: there may be more parts than files may be open.
  CampaignDescription description = Store::open(parts[0], Store::For::reading).description();
  for (const fs::path& part : parts) {
    const Store store = Store::open(part, Store::For::reading);
    description = joined(parts[0], description, part, store.description(), united);
  }
  for (const auto& [name, value] : made) description.made[name] = value;
  DraftStore draft(out, description);
  try {
    SQLite::Transaction all(draft.database());
    RunRows rows(draft.database());
    for (const fs::path& part : parts) {
      Store::open(part, Store::For::reading).each([&](const StoredRun& run) {
        try {
          add(rows, run, part);
        } catch (const SQLite::Exception& error) {  // an error of the draft, not of the part
          throw OutputError(fmt::format("{}: cannot be written: {}", out.string(), error.what()));
        }
      });
    }
    all.commit();
  } catch (const SQLite::Exception& error) {
    throw OutputError(fmt::format("{}: cannot be written: {}", out.string(), error.what()));
  }
  draft.place();
}

namespace {

/// Serialises values so that different lists never give the same bytes.
class Bytes {
 public:
  Bytes& operator<<(std::uint64_t number) {
    const auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
    text_.append(bytes.data(), bytes.size());
    return *this;
  }
  Bytes& operator<<(std::int64_t number) { return *this << static_cast<std::uint64_t>(number); }
  Bytes& operator<<(int number) { return *this << std::int64_t{number}; }
  Bytes& operator<<(double number) { return *this << std::bit_cast<std::uint64_t>(number); }
  Bytes& operator<<(std::string_view text) {
    *this << std::uint64_t{text.size()};
    text_ += text;
    return *this;
  }
  Bytes& operator<<(const Vector& x) {
    *this << std::int64_t{x.size()};
    for (const double coordinate : x) *this << coordinate;
    return *this;
  }
  Bytes& operator<<(const std::map<std::string, double>& numbers) {
    *this << std::uint64_t{numbers.size()};
    for (const auto& [name, value] : numbers) *this << name << value;
    return *this;
  }
  template <HasFields T>
  Bytes& operator<<(const T& value) {
    visit_fields([&](const Field& /*field*/, const auto& x) { *this << x; }, value);
    return *this;
  }

  std::string taken() { return std::exchange(text_, {}); }

 private:
  std::string text_;
};

/// Of what has only fields that are the same on every machine and at every time.
template <HasFields T>
std::string bytes_of(const T& value) {
  return (Bytes() << value).taken();
}

std::string bytes_of(const std::vector<Improvement>& trace) {
  Bytes bytes;
  bytes << std::uint64_t{trace.size()};
  for (const Improvement& step : trace) bytes << step.evaluations << step.true_values;
  if (!trace.empty()) bytes << trace.back().x;
  return bytes.taken();
}

std::string bytes_of(const std::vector<RepeatedTermination>& terminations) {
  Bytes bytes;
  for (const RepeatedTermination& exit : terminations) bytes << exit.reason << exit.starts;
  return bytes.taken();
}

/// The data that may change on another machine or at another time.
std::string times_of(const RunRecord& record) {
  Bytes bytes;
  bytes << record.ledger.seconds;
  for (const Improvement& step : record.trace) bytes << step.seconds;
  return bytes.taken();
}

std::vector<StoredPart> parts_of(const RunRecord& record,
                                 const std::vector<RepeatedTermination>& terminations) {
  const Ledger& ledger = record.ledger;
  Bytes bytes;
  std::vector<StoredPart> parts;
  const auto close = [&](const char* name) { parts.push_back({name, bytes.taken()}); };
  bytes << record.problem << record.solver << record.instance << record.run;
  close("names");
  bytes << record.seed;
  close("seed");
  bytes << record.budget.evaluations << record.budget.seconds;
  close("budget");
  bytes << ledger.values << ledger.derivatives << ledger.hessians << ledger.charged
        << ledger.refused;
  close("ledger");
  bytes << static_cast<int>(record.termination_reason) << record.failure;
  close("end");
  parts.push_back({"terminations", bytes_of(terminations)});
  parts.push_back({"trace", bytes_of(record.trace)});
  if (record.returned) bytes << record.returned->x << record.returned->true_values;
  close("point returned");
  return parts;
}

void add_parts(FnvHash& hash, const std::vector<StoredPart>& parts) {
  for (const StoredPart& part : parts) {
    Bytes bytes;
    hash.add((bytes << part.name << part.bytes).taken());
  }
}

}  // namespace

std::vector<StoredPart> parts_of(const CampaignDescription& description) {
  std::vector<StoredPart> parts = {{"plan", description.plan}};
  for (const StoredProblem& problem : description.problems) {
    parts.push_back({"problem " + problem.name, bytes_of(problem)});
  }
  for (const StoredSolver& solver : description.solvers) {
    parts.push_back(
        {fmt::format("solver {} of version {}", solver.name, solver.version), solver.content});
  }
  for (const auto& [name, value] : description.program) {
    parts.push_back({fmt::format("program's {}, {}", name, value), ""});
  }
  return parts;
}

std::vector<StoredPart> parts_of(const RunRecord& record) {
  return parts_of(record, repeated(record.terminations));
}

std::string difference(const std::vector<StoredPart>& ours, const std::vector<StoredPart>& theirs) {
  const auto [our, their] = std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                          [](const StoredPart& a, const StoredPart& b) {
                                            return a.name == b.name && a.bytes == b.bytes;
                                          });
  if (our != ours.end()) return our->name;
  return their != theirs.end() ? their->name : "";
}

std::uint64_t checksum(const CampaignDescription& description) {
  FnvHash hash;
  add_parts(hash, parts_of(description));
  Bytes made;
  for (const auto& [name, value] : description.made) made << name << value;
  hash.add(made.taken());
  return hash.value();
}

std::uint64_t checksum(const RunKey& key, const RunRecord& record,
                       const std::vector<RepeatedTermination>& terminations) {
  FnvHash hash;
  hash.add(bytes_of(key));
  add_parts(hash, parts_of(record, terminations));
  hash.add(times_of(record));
  return hash.value();
}

Digest::Digest(const CampaignDescription& description) {
  add_parts(hash_, parts_of(description));
}

void Digest::add(const RunKey& key, const RunRecord& record) {
  hash_.add(bytes_of(key));
  add_parts(hash_, parts_of(record));
}

std::string Digest::text() const {
  return fmt::format("{:016x}", hash_.value());
}

namespace {

std::string impossible_count(const char* name, std::int64_t count, std::int64_t most = INT64_MAX,
                             const char* which = "") {
  if (count >= 0 && count <= most) return "";
  if (most == INT64_MAX) return fmt::format("{} is {}: must be >= 0", name, count);
  return fmt::format("{} is {}: must be from 0 to {}{}", name, count, most, which);
}

std::string impossible_time(const char* name, double seconds) {
  if (std::isfinite(seconds) && seconds >= 0) return "";
  return fmt::format("{} is {}: must be a time >= 0 s", name, seconds);
}

/// Whether the second of two steps of a trace improves the first, up to the rounding of an archive.
bool improves(const TrueValues& first, const TrueValues& second) {
  if (second.violation != first.violation) return second.violation < first.violation;
  constexpr double rounding = 1.2e-7;  // of a float
  return second.objective <= first.objective ||
         second.objective <= first.objective + std::abs(first.objective) * rounding;
}

std::string impossible_step(const RunRecord& record, std::size_t k) {
  const Improvement& step = record.trace[k];
  const TrueValues& reached = step.true_values;
  if (auto wrong = impossible_count("evaluations", step.evaluations, record.ledger.charged,
                                    ", those charged");
      !wrong.empty()) {
    return wrong;
  }
  if (auto wrong = impossible_time("seconds", step.seconds); !wrong.empty()) return wrong;
  if (std::isnan(reached.objective)) return "objective is not a number";
  if (!(reached.violation >= 0)) {
    return fmt::format("violation is {}: must be >= 0", reached.violation);
  }
  if (k == 0) return "";
  const Improvement& before = record.trace[k - 1];
  if (step.evaluations < before.evaluations) {
    return fmt::format("evaluations are {}, fewer than before", step.evaluations);
  }
  if (step.seconds > 0 && step.seconds < before.seconds) return "seconds are fewer than before";
  if (!improves(before.true_values, reached)) return "it is no improvement";
  return "";
}

}  // namespace

std::string impossibility(const RunRecord& record) {
  const Ledger& ledger = record.ledger;
  const std::int64_t allowed = record.budget.evaluations;
  for (const std::string& wrong :
       {impossible_count("instance", record.instance), impossible_count("run", record.run),
        impossible_count("evaluations_allowed", allowed),
        impossible_count("charged", ledger.charged, std::max<std::int64_t>(allowed, 0),
                         ", the evaluations allowed"),
        impossible_count("values_asked", ledger.values),
        impossible_count("derivatives_asked", ledger.derivatives),
        impossible_count("hessians_asked", ledger.hessians),
        impossible_count("refused", ledger.refused), impossible_time("seconds", ledger.seconds),
        impossible_count("termination_reason", static_cast<int>(record.termination_reason),
                         static_cast<int>(TerminationReason::paused)),
        impossible_count("the number of starts",
                         static_cast<std::int64_t>(record.terminations.size()), most_starts)}) {
    if (!wrong.empty()) return wrong;
  }
  if (!(record.budget.seconds >= 0)) {
    return fmt::format("seconds_allowed is {}: must be >= 0", record.budget.seconds);
  }
  for (std::size_t k = 0; k < record.trace.size(); ++k) {
    if (const auto wrong = impossible_step(record, k); !wrong.empty()) {
      return fmt::format("improvement {}: {}", k, wrong);
    }
  }
  if (record.returned && record.returned->true_values.violation < 0) {
    return fmt::format("returned_violation is {}: must be >= 0",
                       record.returned->true_values.violation);
  }
  return "";
}

}  // namespace ricochet
