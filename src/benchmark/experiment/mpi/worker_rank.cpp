#include "src/benchmark/experiment/mpi/worker_rank.h"

#include <cstdint>
#include <memory>

#include "src/benchmark/experiment/mpi/child.h"
#include "src/benchmark/experiment/mpi/message.h"

namespace ricochet::mpi {
namespace {

using Clock = std::chrono::steady_clock;

std::string given_runs() {
  auto told = Clock::now();
  while (true) {
    if (auto message = received()) return std::move(message->bytes);
    rest();
    if (Clock::now() - told < heartbeat) continue;
    send(0, alive, "");
    told = Clock::now();
  }
}

/// The next record; nothing if the runner has ended.
std::optional<std::string> record_of(Child& runner) {
  while (!runner.waits_for_news(heartbeat)) send(0, alive, "");
  return runner.hear();
}

}  // namespace

void make_given_runs(const std::vector<std::string>& arguments) {
  std::vector<std::string> serving = arguments;
  serving.insert(serving.end(), {"--serve", "runs"});
  std::unique_ptr<Child> runner;
  while (true) {
    send(0, request, "");
    const std::string places = given_runs();
    if (places.empty()) return;
    if (!runner) runner = std::make_unique<Child>(serving);
    runner->tell(places);
    for (std::size_t left = places.size() / sizeof(std::uint64_t); left > 0; --left) {
      const auto record = record_of(*runner);
      if (!record) {
        send(0, gone, "");
        return;
      }
      send(0, result, *record);
    }
  }
}

}  // namespace ricochet::mpi
