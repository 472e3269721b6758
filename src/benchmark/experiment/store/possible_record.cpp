#include "src/benchmark/experiment/store/possible_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ricochet {
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
  if (const auto wrong = impossible_count("evaluations", step.evaluations, record.ledger.charged,
                                          ", those charged");
      !wrong.empty()) {
    return wrong;
  }
  if (const auto wrong = impossible_time("seconds", step.seconds); !wrong.empty()) return wrong;
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
