#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "ricochet/error.h"
#include "src/core/child_process.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/worker.h"

namespace ricochet {

namespace {

using Place = std::uint64_t;

template <class Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// The places in a message, each the index of a planned run.
std::vector<Place> places_in(const std::string& message, std::size_t planned) {
  std::vector<Place> places(message.size() / sizeof(Place));
  std::memcpy(places.data(), message.data(), places.size() * sizeof(Place));
  for (const Place place : places) {
    if (place >= planned) throw InputError("the processes have different plans");
  }
  return places;
}

/// What is sent before a record: its place, and the content of its solver, which another machine
/// may have in another version.
constexpr std::size_t length_of_content = 16;

std::string heading(Place place, const Solver& solver) {
  std::string bytes;
  append(bytes, place);
  std::string content = solver.content;
  content.resize(length_of_content);
  return bytes + content;
}

/// Returns true if the record is of this job: its seed depends on all names of the job.
bool is_of(const RunRecord& record, const Job& job) {
  const RunRecord mine = nothing_run(*job.problem, *job.solver, job.budget, job.number, job.shown);
  return record.problem == mine.problem && record.solver == mine.solver &&
         record.instance == mine.instance && record.run == mine.run && record.seed == mine.seed &&
         record.budget.evaluations == mine.budget.evaluations &&
         record.budget.gradient_price == mine.budget.gradient_price;
}

}  // namespace

bool serve_store(const Campaign& campaign, const Shard& shard, Store& store, int in, int out) {
  const PlannedRuns planned(campaign, shard, {});
  std::set<RunKey> done = store.keys();
  std::string opening;
  double work = 0;
  for (Place place = 0; place < planned.all().size(); ++place) {
    const PlannedRun& run = planned.all()[place];
    if (done.contains(run.key)) continue;
    append(opening, place);
    work += run.length;
  }
  if (!write_frame(out, opening)) return false;
  Progress progress("running", std::max(work, 1.0));
  while (const auto message = read_frame(in)) {
    if (message->empty()) {
      store.finish();
      return true;
    }
    const Place place = places_in(message->substr(0, sizeof(Place)), planned.all().size()).at(0);
    const PlannedRun& run = planned.all()[place];
    const std::string expected = heading(place, *run.job.solver);
    if (!message->starts_with(expected)) {
      throw InputError(
          fmt::format("the processes have different files of {}", run.job.solver->name));
    }
    const RunRecord record = record_from(message->substr(expected.size()));
    if (!is_of(record, run.job)) throw InputError("the processes have different plans");
    if (!done.insert(run.key).second) continue;  // from a rank that was taken for dead
    store.add(run.key, record);
    progress.advance(run.length);
  }
  return false;
}

void serve_runs(const Campaign& campaign, const Shard& shard, int in, int out) {
  const PlannedRuns planned(campaign, shard, {});
  while (const auto message = read_frame(in)) {
    const std::vector<Place> places = places_in(*message, planned.all().size());
    std::vector<Job> jobs;
    for (const Place place : places) jobs.push_back(planned.all()[place].job);
    run_all(jobs, campaign.plan().limits, [&](std::size_t j, const RunRecord& record) {
      require_unchanged(*jobs[j].solver);
      const std::string answer = heading(places[j], *jobs[j].solver) + text_of(record);
      if (!write_frame(out, answer)) throw OutputError("nobody reads the runs");
    });
  }
}

}  // namespace ricochet
