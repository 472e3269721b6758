#pragma once

#include <mpi.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

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

}  // namespace ricochet::mpi
