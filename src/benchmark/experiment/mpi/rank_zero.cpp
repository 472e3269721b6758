#include "src/benchmark/experiment/mpi/rank_zero.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <set>

#include "src/benchmark/experiment/mpi/child.h"
#include "src/benchmark/experiment/mpi/message.h"

namespace ricochet::mpi {
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

class Office {
 public:
  Office(Child& store, int ranks) : store_(store), ranks_(static_cast<std::size_t>(ranks)) {
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
  Office office(store, ranks);
  const bool all = office.work();
  lost = office.lost();
  const int status = store.wait();
  return status == 0 && !all ? 1 : status;
}

}  // namespace ricochet::mpi
