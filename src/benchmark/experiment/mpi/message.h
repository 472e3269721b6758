#pragma once

#include <mpi.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace ricochet::mpi {

/// What a rank tells rank 0, which answers a request with runs; no runs: there are no more.
enum Tag : int { request, result, gone, alive, runs };

/// A rank says so often that it is alive, and is taken for dead after such a silence.
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

/// A message that has come, from any rank.
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

/// MPI's own waiting would keep a core busy that is there for runs.
inline void rest() {
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

}  // namespace ricochet::mpi
