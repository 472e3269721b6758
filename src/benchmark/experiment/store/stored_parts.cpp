#include "src/benchmark/experiment/store/stored_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>

namespace ricochet {
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
  Bytes& operator<<(const TrueValues& true_values) {
    return *this << true_values.objective << true_values.violation;
  }

  std::string taken() { return std::exchange(text_, {}); }

 private:
  std::string text_;
};

std::string bytes_of(const StoredProblem& problem) {
  Bytes bytes;
  bytes << problem.name << problem.family << problem.machine << problem.variables
        << problem.constraints << problem.equalities << problem.tolerance << problem.best_known
        << problem.hash;
  for (const auto* numbers : {&problem.factors, &problem.findings}) {
    bytes << std::uint64_t{numbers->size()};
    for (const auto& [name, value] : *numbers) bytes << name << value;
  }
  return bytes.taken();
}

std::string bytes_of(const RunKey& key) {
  const Cell& cell = key.cell;
  Bytes bytes;
  bytes << cell.problem << cell.formulation << cell.perturbation << cell.solver << cell.budget
        << cell.gradient_price << key.instance << key.run;
  return bytes.taken();
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

}  // namespace ricochet
