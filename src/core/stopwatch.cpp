#include "ricochet/stopwatch.h"

#include <algorithm>

#include "src/core/processor_time.h"

namespace ricochet {
namespace {

constexpr double between_readings = 1e-4;  // [s], about
constexpr double most_glances = 64;        // between two readings: the cost is then negligible

}  // namespace

double Stopwatch::now() {
  return processor_seconds();
}

Stopwatch::Stopwatch() : started_(now()) {}

double Stopwatch::read() {
  last_ = now() - started_;
  return last_;
}

double Stopwatch::glance() {
  if (++glances_ < until_) return last_;
  const double before = last_;
  const double each = (read() - before) / static_cast<double>(glances_);
  const double fitting = each > 0 ? between_readings / each : most_glances;
  until_ = static_cast<std::int64_t>(std::clamp(fitting, 1.0, most_glances));
  glances_ = 0;
  return last_;
}

}  // namespace ricochet
