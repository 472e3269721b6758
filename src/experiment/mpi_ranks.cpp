#include "src/experiment/mpi_ranks.h"

#include <fcntl.h>
#include <mpi.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "src/core/child_process.h"

namespace ricochet::mpi {

/// Tags of messages from a rank to rank 0, which answers a request with runs; no runs: the end.
enum Tag : int { request, result, gone, alive, runs };

/// Interval of a rank's signs of life, and the silence after which it is taken for dead.
inline constexpr std::chrono::seconds heartbeat(5);
inline constexpr std::chrono::seconds longest_silence(30);

struct Message {
  int rank;
  int tag;
  std::string bytes;
};

inline void send(int rank, Tag tag, const std::string& bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

/// A message that has arrived, from any rank; nothing if there is none.
inline std::optional<Message> received() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int count = 0;
  MPI_Get_count(&status, MPI_BYTE, &count);
  Message message{status.MPI_SOURCE, status.MPI_TAG,
                  std::string(static_cast<std::size_t>(count), '\0')};
  MPI_Recv(message.bytes.data(), count, MPI_BYTE, message.rank, message.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

/// Sleeps for a short time. MPI's own waiting would use a core that is needed for runs.
inline void rest() {
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

namespace {

/// A child that becomes `ricochet`, the program beside this one, with these arguments, and
/// exchanges frames as its --serve does.
ChildProcess ricochet_child(std::vector<std::string> arguments) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("ricochet").string();
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  return ChildProcess([&](int descriptor) {
    dup2(descriptor, STDIN_FILENO);
    if (descriptor == frames_out) {
      fcntl(frames_out, F_SETFD, 0);
    } else {
      dup2(descriptor, frames_out);
    }
    execv(program.c_str(), argv.data());
    _exit(127);
  });
}

/// Its exit code, or 128 plus the signal that ended it.
int exit_code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

using Clock = std::chrono::steady_clock;
using Place = std::uint64_t;  // of a run in the plan

/// Largest number of runs sent at once: many at first, few at the end.
constexpr std::size_t most_at_once = 64;

struct Rank {
  std::set<Place> given;  ///< given to it and not yet returned
  bool waits = false;     ///< for runs
  bool lost = false;
  Clock::time_point heard = Clock::now();
};

class RankScheduler {
 public:
  RankScheduler(ChildProcess& store, int ranks)
      : store_(store), ranks_(static_cast<std::size_t>(ranks)) {
    ranks_[0].lost = true;  // rank 0 makes no runs
    const auto opening = store_.hear();
    if (!opening) return;
    waiting_.resize(opening->size() / sizeof(Place));
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      std::memcpy(&waiting_[k], opening->data() + k * sizeof(Place), sizeof(Place));
    }
    open_ = true;
  }

  /// Returns whether all runs are made.
  bool work() {
    while (!done() && any_left() && open_) {
      if (const auto message = received()) {
        take(*message);
      } else {
        look_for_silence();
        rest();
      }
      serve_waiting();
    }
    const bool all = open_ && done();
    dismiss();
    return all && store_.tell("");
  }

  bool lost() const { return lost_; }

 private:
  bool done() const {
    return waiting_.empty() && std::all_of(ranks_.begin(), ranks_.end(),
                                           [](const Rank& rank) { return rank.given.empty(); });
  }

  bool any_left() const {
    return std::any_of(ranks_.begin(), ranks_.end(), [](const Rank& rank) { return !rank.lost; });
  }

  void take(const Message& message) {
    Rank& rank = ranks_[static_cast<std::size_t>(message.rank)];
    rank.heard = Clock::now();
    if (message.tag == request) {
      rank.waits = true;
    } else if (message.tag == gone && !rank.lost) {
      lose(message.rank, "has lost its process");
    } else if (message.tag == result) {
      Place place = 0;
      std::memcpy(&place, message.bytes.data(), sizeof place);
      rank.given.erase(place);
      if (!store_.tell(message.bytes)) open_ = false;
    }
  }

  void lose(int number, const char* why) {
    Rank& rank = ranks_[static_cast<std::size_t>(number)];
    std::fprintf(stderr, "ricochet: rank %d %s\n", number, why);
    waiting_.insert(waiting_.begin(), rank.given.begin(), rank.given.end());
    rank.given.clear();
    rank.lost = lost_ = true;
  }

  void look_for_silence() {
    for (std::size_t k = 1; k < ranks_.size(); ++k) {
      const bool silent = Clock::now() - ranks_[k].heard > longest_silence;
      if (silent && !ranks_[k].lost) lose(static_cast<int>(k), "is silent");
    }
  }

  void serve_waiting() {
    for (std::size_t k = 1; k < ranks_.size() && !waiting_.empty(); ++k) {
      Rank& rank = ranks_[k];
      if (!rank.waits || rank.lost) continue;
      const std::size_t count =
          std::clamp<std::size_t>(waiting_.size() / (4 * ranks_.size()), 1, most_at_once);
      std::string bytes;
      for (std::size_t j = 0; j < count; ++j) {
        bytes.append(reinterpret_cast<const char*>(&waiting_.front()), sizeof(Place));
        rank.given.insert(waiting_.front());
        waiting_.pop_front();
      }
      rank.waits = false;
      send(static_cast<int>(k), runs, bytes);
    }
  }

  /// Tells every rank, when it asks, that there are no more runs.
  void dismiss() {
    while (any_left()) {
      if (const auto message = received()) {
        take(*message);
      } else {
        look_for_silence();
        rest();
      }
      for (std::size_t k = 1; k < ranks_.size(); ++k) {
        if (!ranks_[k].waits || ranks_[k].lost) continue;
        send(static_cast<int>(k), runs, "");
        ranks_[k].lost = true;
      }
    }
  }

  ChildProcess& store_;
  std::vector<Rank> ranks_;
  std::deque<Place> waiting_;
  bool open_ = false;  // the store accepts runs
  bool lost_ = false;
};

}  // namespace

int hand_out_runs(std::vector<std::string> arguments, int ranks, bool& lost) {
  arguments.insert(arguments.end(), {"--serve", "store"});
  ChildProcess store = ricochet_child(std::move(arguments));
  RankScheduler scheduler(store, ranks);
  const bool all = scheduler.work();
  lost = scheduler.lost();
  const int status = exit_code_of(store.finish());
  return status == 0 && !all ? 1 : status;
}

namespace {

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
std::optional<std::string> record_of(ChildProcess& runner) {
  for (;;) {
    if (auto record = runner.next()) return record;
    while (!runner.has_news(Clock::now() + heartbeat)) send(0, alive, "");
    if (!runner.listen()) return std::nullopt;
  }
}

}  // namespace

void make_given_runs(const std::vector<std::string>& arguments) {
  std::vector<std::string> serving = arguments;
  serving.insert(serving.end(), {"--serve", "runs"});
  std::unique_ptr<ChildProcess> runner;
  while (true) {
    send(0, request, "");
    const std::string places = given_runs();
    if (places.empty()) {
      if (runner) runner->finish();
      return;
    }
    if (!runner) runner.reset(new ChildProcess(ricochet_child(serving)));
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
