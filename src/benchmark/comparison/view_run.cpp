#include "src/benchmark/comparison/view_run.h"

#include <algorithm>

namespace ricochet::studies::comparison {
namespace {

constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::int64_t largest_digit = 63;

/// Appends a number >= 0, five bits a digit.
void append(std::string& text, std::int64_t number) {
  while (number >= 32) {
    text += view_digit(32 + number % 32);
    number /= 32;
  }
  text += view_digit(number);
}

}  // namespace

char view_digit(std::int64_t value) {
  return base64_digits.at(static_cast<std::size_t>(value));
}

std::int64_t targets_at(int level, std::size_t targets) {
  const auto all = static_cast<std::int64_t>(targets);
  return (all * (level + 1) + view_levels - 1) / view_levels;  // rounded up
}

ViewRun view_run(const ricochet::comparison::Outcome& outcome,
                 const ricochet::comparison::Targets& targets) {
  const auto& gap = outcome.verdict.returned_optimality_gap;
  ViewRun run;
  run.missing = gap ? std::lower_bound(targets.begin(), targets.end(), *gap) - targets.begin()
                    : static_cast<std::int64_t>(targets.size()) + 1;
  run.evaluations = outcome.evaluations;
  run.missing = outcome.solved() ? 0 : std::max<std::int64_t>(run.missing, 1);
  const std::int64_t reached = static_cast<std::int64_t>(targets.size()) - run.missing;
  const auto steps = steps_of(outcome);
  for (int level = 0; level < view_levels; ++level) {
    const std::int64_t taken = targets_at(level, targets.size());
    if (taken > reached) break;
    std::int64_t time = evaluations_until_solved(outcome);
    if (level + 1 < view_levels) {
      const double target = targets[targets.size() - static_cast<std::size_t>(taken)];
      const auto step = std::ranges::find_if(
          steps, [&](const auto& one) { return one.optimality_gap <= target; });
      if (step != steps.end()) time = std::min(time, step->evaluations);
    }
    run.times.push_back(time);
  }
  return run;
}

void ViewRunsWriter::add(const ViewRun& run, std::int64_t budget) {
  text_.missing += view_digit(std::min(run.missing, largest_digit));
  if (run.missing >= largest_digit) append(text_.missing, run.missing - largest_digit);
  std::int64_t before = 0;
  for (const std::int64_t time : run.times) {
    append(text_.times, time - before);
    before = time;
  }
  if (run.repeats) {
    append(text_.repeats, single_);
    single_ = 0;
  } else {
    ++single_;
  }
  if (run.missing == 0) return;
  if (run.evaluations == budget) {
    ++whole_;
    return;
  }
  append(text_.spent, whole_);
  const std::int64_t left = budget - run.evaluations;
  append(text_.spent, left > 0 ? 2 * left : -2 * left - 1);
  whole_ = 0;
}

}  // namespace ricochet::studies::comparison
