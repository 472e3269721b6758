#include "src/core/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "src/core/one_line.h"

namespace ricochet {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds between_lines{10};  // elsewhere than on a terminal

std::atomic<bool> silent = false;

/// The columns of the terminal that standard error is; many if it does not say.
std::size_t terminal_columns() {
  winsize size{};
  const bool says = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return says ? size.ws_col : 1000;
}

}  // namespace

void Progress::announce(std::string_view line) {
  if (!silent) std::fputs((one_line(line) + "\n").c_str(), stderr);
}

bool Progress::redraws() {
  const char* const terminal = std::getenv("TERM");
  const bool takes_escapes =
      terminal != nullptr && *terminal != '\0' && std::string_view(terminal) != "dumb";
  return takes_escapes && isatty(STDERR_FILENO) == 1;
}

void Progress::silence() {
  silent = true;
}

Progress::Progress(std::string what, double work, First first)
    : what_(std::move(what)),
      work_(work),
      redraws_(redraws()),
      start_(steady_clock::now()),
      drawn_(first == First::at_once ? start_ - between_lines : start_),
      interrupted_([this] {
        if (!silent.exchange(true) && redraws_) std::fputs("\n", stderr);  // the bar stays
      }) {}

Progress::~Progress() {
  if (redraws_ && !silent) draw(true);
}

void Progress::begin(std::string what, steady_clock::time_point start) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
  done_ = 0;
  start_ = start;
}

void Progress::advance(double work) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  done_ += work;
  if (silent || steady_clock::now() - drawn_ < (redraws_ ? 100ms : between_lines)) return;
  drawn_ = steady_clock::now();
  draw(false);
}

void Progress::draw(bool last) const {
  constexpr int width = 30;
  const double share = std::clamp(done_ / work_, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(steady_clock::now() - start_).count();
  const std::string time =
      last ? fmt::format("{:.1f} s", elapsed)
           : (share > 0 ? fmt::format("{:.0f} s left", elapsed * (1 - share) / share)
                        : fmt::format("{:.0f} s", elapsed));
  if (redraws_) {
    const auto filled = static_cast<std::size_t>(share * width);
    const std::string bar = std::string(filled, '=') + std::string(width - filled, ' ');
    std::string line = fmt::format("{:<28} [{}] {:3.0f} %  {}", what_, bar, 100 * share, time);
    const std::size_t columns = terminal_columns();
    if (line.size() >= columns) line = fmt::format("{} {:.0f} %  {}", what_, 100 * share, time);
    line = fmt::format("\r\033[K{}{}", line.substr(0, columns - 1), last ? "\n" : "");
    std::fputs(line.c_str(), stderr);
  } else {
    std::fputs(fmt::format("{}: {:.0f} %, {}\n", what_, 100 * share, time).c_str(), stderr);
  }
  std::fflush(stderr);
}

}  // namespace ricochet
