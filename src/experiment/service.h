#pragma once

#include <optional>
#include <string>

#include "src/experiment/campaign.h"
#include "src/experiment/planned_runs.h"

namespace ricochet {

/// A campaign whose runs are made on other machines: one process keeps the store, others make the
/// runs they are given. All know the same plan, so 8 bytes name a run: its place among the runs of
/// the shard. Messages are frames, see frame.h; how they are transported does not matter here.

/// Sends the list of runs that the store lacks, then adds the records that arrive, each after its
/// place and the content of its solver, until an empty message. Returns true if that arrived.
/// Throws InputError for a record that does not belong to its place, or whose solver has other
/// files.
bool serve_store(const Campaign& campaign, const Shard& shard, Store& store, int in, int out);

/// Makes the runs of every message, a list of places, and sends each record after its place and the
/// content of its solver as soon as the run has ended, until no further message comes. Throws as
/// require_unchanged() does.
void serve_runs(const Campaign& campaign, const Shard& shard, int in, int out);

/// Messages of bytes over a pipe, each after its length: the processes of a campaign under MPI
/// exchange them.

/// Writes all of a message. Returns false if no one reads any more.
bool write_frame(int descriptor, const std::string& message);

/// Waits for a message. Returns nothing if the sender has closed the pipe, also within a message.
std::optional<std::string> read_frame(int descriptor);

/// The file descriptor for the messages that a server of a campaign writes; it reads messages from
/// standard input.
inline constexpr int frames_out = 3;

}  // namespace ricochet
