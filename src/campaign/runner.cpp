#include "src/campaign/runner.h"

#include <poll.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace ricochet {
namespace {

using Clock = std::chrono::steady_clock;

struct Running {
  std::size_t job;
  std::unique_ptr<Worker> worker;
};

/// Waits for news of any of them. Returns whether there are some, for each.
std::vector<bool> wait_for(const std::vector<Running>& running) {
  std::vector<pollfd> descriptors;
  auto deadline = Clock::time_point::max();
  for (const Running& each : running) {
    descriptors.push_back({each.worker->descriptor(), POLLIN, 0});
    deadline = std::min(deadline, each.worker->deadline());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  // An hour at most: it is an int.
  poll(descriptors.data(), descriptors.size(),
       static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 3'600'000)));
  std::vector<bool> news;
  for (const pollfd& each : descriptors) news.push_back(each.revents != 0);
  return news;
}

}  // namespace

void run_all(const std::vector<Job>& jobs, const Limits& limits,
             const std::function<void(std::size_t, RunRecord)>& done) {
  const std::size_t at_once = std::max<std::size_t>(
      1, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  std::vector<Running> running;
  std::size_t next = 0;
  while (next < jobs.size() || !running.empty()) {
    while (next < jobs.size() && running.size() < at_once) {
      running.push_back({next, std::make_unique<Worker>(jobs[next], limits)});
      ++next;
    }
    const std::vector<bool> news = wait_for(running);
    std::vector<Running> still;
    for (std::size_t i = 0; i < running.size(); ++i) {
      Worker& worker = *running[i].worker;
      const bool goes_on = !news[i] || worker.listen();
      if (goes_on && Clock::now() < worker.deadline()) {
        still.push_back(std::move(running[i]));
      } else {
        done(running[i].job, worker.record());
      }
    }
    running = std::move(still);
  }
}

std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress) {
  std::vector<RunRecord> records(jobs.size());
  run_all(jobs, Limits{}, [&](std::size_t job, RunRecord record) {
    records[job] = std::move(record);
    progress.advance(1);
  });
  return records;
}

}  // namespace ricochet
