#pragma once

#include "src/campaign/campaign.h"
#include "src/campaign/planned_runs.h"

namespace ricochet {

/// A campaign whose runs other machines make: one process keeps the store, others make what they
/// are told. All know the same plan, so that a run is told by its place among those of the shard,
/// 8 bytes. Messages are frames, see frame.h; what moves them to and fro is no matter here.

/// Says which runs the store lacks, then adds the records that come, each behind its place, until
/// an empty message. Returns whether that came. Throws InputError for a record of another run than
/// its place says.
bool serve_store(const Campaign& campaign, const Shard& shard, Store& store, int in, int out);

/// Makes the runs of every message, which is a list of places, and tells every record behind its
/// place as soon as the run has ended; until no message comes any more.
void serve_runs(const Campaign& campaign, const Shard& shard, int in, int out);

}  // namespace ricochet
