#include "src/experiment/mpi_ranks.h"

#include <fcntl.h>
#include <mpi.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
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
#include <system_error>
#include <thread>
#include <vector>

#include "src/experiment/service.h"

namespace ricochet::mpi {

/// A child process of `ricochet`, the program beside this one, with which frames are exchanged.
class Child {
 public:
  /// Throws std::system_error if no process can be started.
  explicit Child(std::vector<std::string> arguments);

  /// Waits until it ends by itself.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Sends a message. Returns whether it still listens.
  bool tell(const std::string& message);

  /// Waits for at most this time. Returns true if there is a message or it has ended.
  bool waits_for_news(std::chrono::milliseconds most);

  /// The next message; nothing if it has ended.
  std::optional<std::string> hear();

  /// Closes its input and waits for its end. Returns its exit code, or 128 plus the signal.
  int wait();

 private:
  int to_ = -1, from_ = -1;
  pid_t process_ = -1;
};

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

Child::Child(std::vector<std::string> arguments) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("ricochet").string();
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int in[2];
  int out[2];
  if (pipe2(in, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  if (pipe2(out, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // a rank that is killed leaves nothing behind
    if (getppid() != parent) _exit(127);
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], frames_out);
    fcntl(frames_out, F_SETFD, 0);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  const int error = errno;
  close(in[0]);
  close(out[1]);
  to_ = in[1];
  from_ = out[0];
  if (process_ < 0) throw std::system_error(error, std::generic_category(), "fork");
}

Child::~Child() {
  wait();
  close(from_);
}

bool Child::tell(const std::string& message) {
  return write_frame(to_, message);
}

bool Child::waits_for_news(std::chrono::milliseconds most) {
  pollfd news{from_, POLLIN, 0};
  return poll(&news, 1, static_cast<int>(most.count())) > 0;
}

std::optional<std::string> Child::hear() {
  return read_frame(from_);
}

int Child::wait() {
  if (to_ >= 0) close(to_);
  to_ = -1;
  if (process_ < 0) return 0;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

namespace {

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
  RankScheduler(Child& store, int ranks) : store_(store), ranks_(static_cast<std::size_t>(ranks)) {
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

  Child& store_;
  std::vector<Rank> ranks_;
  std::deque<Place> waiting_;
  bool open_ = false;  // the store accepts runs
  bool lost_ = false;
};

}  // namespace

int hand_out_runs(std::vector<std::string> arguments, int ranks, bool& lost) {
  arguments.insert(arguments.end(), {"--serve", "store"});
  Child store(std::move(arguments));
  RankScheduler office(store, ranks);
  const bool all = office.work();
  lost = office.lost();
  const int status = store.wait();
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
