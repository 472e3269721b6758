#include "src/campaign/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace ricochet {

using std::chrono::steady_clock;

Progress::Progress(std::string what, double work)
    : what_(std::move(what)),
      work_(work),
      shown_(isatty(STDERR_FILENO) == 1),
      start_(steady_clock::now()),
      drawn_(start_) {}

Progress::~Progress() {
  if (shown_) draw(true);
}

void Progress::advance(double work) {
  const std::lock_guard lock(mutex_);
  done_ += work;
  if (!shown_ || steady_clock::now() - drawn_ < std::chrono::milliseconds(100)) return;
  drawn_ = steady_clock::now();
  draw(false);
}

void Progress::draw(bool last) {
  constexpr int width = 30;
  const double share = std::clamp(done_ / work_, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(steady_clock::now() - start_).count();
  const auto filled = static_cast<std::size_t>(share * width);
  const std::string bar = std::string(filled, '=') + std::string(width - filled, ' ');
  const std::string time =
      last ? fmt::format("{:.1f} s", elapsed)
           : (share > 0 ? fmt::format("{:.0f} s left", elapsed * (1 - share) / share) : "");
  fmt::print(stderr, "\r\033[K{:<28} [{}] {:3.0f} %  {}{}", what_, bar, 100 * share, time,
             last ? "\n" : "");
  std::fflush(stderr);
}

}  // namespace ricochet
