#include "src/studies/calibration/fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/core/toml_fields.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

/// The seed is part of the name, which alone determines the random numbers.
Problem seeded(const Parameterisation& parameterisation, const Search& search,
               const CaseIds& left_out = {}) {
  Problem problem = calibration_problem(parameterisation, left_out);
  problem.name += fmt::format("-seed-{}{}", search.seed, fmt::join(left_out, ""));
  return problem;
}

Fit fit_of(const Parameterisation& parameterisation, const BestPoint& best,
           const CaseIds& left_out = {}) {
  return {parameterisation.interpretation, parameterisation.free,
          constants_at(parameterisation, best.x), best.loss, left_out};
}

void polish(Problem& problem, const Search& search, std::int64_t evaluations, BestPoint& best) {
  improve(problem, search.least_squares, evaluations / 2, best);
  improve(problem, search.local, evaluations / 2, best);
}

}  // namespace

std::string words_of(Unknown constant) {
  std::string words(unknown_parameters()[static_cast<std::size_t>(constant)].name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

Fit fit(const Parameterisation& parameterisation, const Search& search, const CaseIds& left_out) {
  Problem problem = seeded(parameterisation, search, left_out);
  BestPoint best = start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  polish(problem, search, search.evaluations / 3, best);
  return fit_of(parameterisation, best, left_out);
}

Fit polish(const Parameterisation& parameterisation, const Search& search) {
  Problem problem = seeded(parameterisation, search);
  BestPoint best = start_of(problem);
  polish(problem, search, search.evaluations, best);
  return fit_of(parameterisation, best);
}

Fit best_within(std::int64_t evaluations, const RunRecord& record,
                const Parameterisation& parameterisation, double loss_of_held) {
  Fit fit{parameterisation.interpretation,
          parameterisation.free,
          parameterisation.held,
          loss_of_held,
          {}};
  for (const Improvement& better : record.trace) {
    if (better.evaluations > evaluations) break;
    if (better.true_values.objective >= fit.loss) continue;
    fit.loss = better.true_values.objective;
    fit.constants = constants_at(parameterisation, better.x);
  }
  return fit;
}

namespace {

std::vector<Fit> known_or_searched(const FitTask& task, FitStore& store) {
  std::vector<Fit> fits;
  for (const AskedFit& asked : task.asked) {
    auto known = store.find(asked);
    if (!known) break;
    fits.push_back(std::move(*known));
  }
  if (fits.size() == task.asked.size()) return fits;
  fits = task.search();
  store.add(task.asked, fits);
  return fits;
}

}  // namespace

FitTask fit_task(const std::string& kind, const carrier_track::Parameterisation& parameterisation,
                 const Search& search, const CaseIds& left_out) {
  AskedFit asked{fmt::format("{} by {}, seed {}", kind, search.global.name, search.seed),
                 parameterisation, left_out, options_of(search), [](const Fit& found) {
                   return carrier_track::loss(found.interpretation, found.constants,
                                              found.left_out);
                 }};
  return {{std::move(asked)},
          [=] { return std::vector{fit(parameterisation, search, left_out)}; },
          static_cast<double>(search.evaluations)};
}

std::vector<std::vector<Fit>> searched(const std::string& what, const std::vector<FitTask>& tasks,
                                       FitStore& store) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return tasks[i].work; });
  double work = 0;
  for (const FitTask& task : tasks) work += task.work;
  Progress progress(what, work);
  std::vector<std::vector<Fit>> fits(tasks.size());
  std::atomic<std::size_t> next = 0;
  tbb::parallel_for(0U, std::max(1U, std::thread::hardware_concurrency()), [&](unsigned) {
    for (std::size_t k = next++; k < order.size(); k = next++) {
      if (tbb::is_current_task_group_canceling()) return;  // another one has failed
      const FitTask& task = tasks[order[k]];
      fits[order[k]] = known_or_searched(task, store);
      progress.advance(task.work);
    }
  });
  return fits;
}

std::vector<Fit> fits_by(const std::string& what, const std::vector<FitTask>& tasks,
                         FitStore& store) {
  std::vector<Fit> ends;
  for (std::vector<Fit>& fits : searched(what, tasks, store)) {
    ends.push_back(std::move(fits.back()));
  }
  return ends;
}

Search with_evaluations(Search search, std::int64_t evaluations) {
  search.evaluations = evaluations;
  return search;
}

namespace {

/// Relative tolerance, since logarithms round differently on other machines.
constexpr double same_loss = 1e-9;

std::string hash_of(const std::string& text) {
  FnvHash hash;
  hash.add(text);
  return fmt::format("{:016x}", hash.value());
}

/// A file of fits.
struct KeptFit {
  std::string name, options;
  double loss = 0;
  Constants constants = {};
};

template <class Visit, IsOf<KeptFit>... K>
void visit_fields(const Visit& visit, K&... k) {
  using enum Presence;
  visit(Field{"name", "", "", {}, required}, k.name...);
  visit(Field{"options", "", "", {}, required}, k.options...);
  visit(Field{"loss", "1", "", {}, required}, k.loss...);
  visit(Field{"constants", "1", "", {}, required}, k.constants...);
}

struct FitsFile {
  std::int64_t version = 1;
  std::string data;
  std::int64_t fits = -1;
  std::vector<KeptFit> fit = {};
};

template <class Visit, IsOf<FitsFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  visit(Field{"version", "1", "", {}, Presence::stated}, f.version...);
  visit(Field{"data", "", "", {}, Presence::stated}, f.data...);
  visit(Field{"fits", "1", "", {}, Presence::stated}, f.fits...);
  visit(Field{"fit"}, f.fit...);
}

std::string hash_of_data() {
  return data_hash(all_cases(), unknown_parameters());
}

constexpr const char* instead = "remove it, or choose another folder";

void check_version(std::int64_t version, const std::string& file) {
  if (version == suite_version) return;
  throw InputError(
      fmt::format("{}: its fits are of version {} of the suite, this is version {}: {}", file,
                  version, suite_version, instead));
}

/// Throws InputError if the file was fitted to other data, or has fewer fits than it states.
void check_head(const FitsFile& fits, const std::string& file) {
  if (fits.data != hash_of_data()) {
    throw InputError(
        fmt::format("{}: its fits are to other cases, claims or bounds (hash {}, not {}): {}", file,
                    fits.data, hash_of_data(), instead));
  }
  if (fits.fits != std::ssize(fits.fit)) {
    throw InputError(
        fmt::format("{}: has {} of its {} fits: {}", file, fits.fit.size(), fits.fits, instead));
  }
}

}  // namespace

std::string AskedFit::name() const {
  std::string text;
  for (const Unknown open : parameterisation.free)
    text += fmt::format(" {}", static_cast<int>(open));
  for (const double value : parameterisation.held) text += fmt::format(" {}", value);
  return fmt::format("{}: {}{}{}, from {}", kind, name_of(parameterisation.interpretation),
                     left_out.empty() ? "" : " without ", fmt::join(left_out, ", "), hash_of(text));
}

std::string options_of(const Search& search) {
  std::string text = fmt::format("{} evaluations", search.evaluations);
  for (const Solver* solver : {&search.global, &search.least_squares, &search.local}) {
    if (!solver->name.empty()) text += fmt::format(", {} ({})", solver->name, solver->version);
  }
  return text;
}

std::string data_hash(const std::vector<Case>& cases,
                      const std::vector<UnknownParameter>& parameters) {
  std::string text;
  for (const Case& c : cases) {
    text += fmt::format("{} {} {} {}", c.id, c.restitution, c.friction, c.disturbance);
    if (c.claim.threshold) text += fmt::format(" threshold {}", *c.claim.threshold);
    if (c.claim.quiet_count) text += fmt::format(" count {}", *c.claim.quiet_count);
    if (c.claim.figure) {
      text += fmt::format(" examples {} {}", c.claim.figure->quiet, c.claim.figure->loud);
    }
    text += '\n';
  }
  for (const UnknownParameter& p : parameters) {
    text += fmt::format("{} {} {} {}", p.name, p.lower, p.upper, p.logarithmic);
    if (p.natural) text += fmt::format(" natural {}", *p.natural);
    text += '\n';
  }
  return hash_of(text);
}

FitStore::FitStore(std::filesystem::path file) : file_(std::move(file)) {
  if (!std::filesystem::exists(file_)) return;
  const std::string name = file_.string();
  const toml::table table = parse_toml_file(name);
  if (!table.contains("fit")) {
    throw InputError(name + ": is no file of fits: must be one that ricochet calibrate wrote");
  }
  check_version(table["version"].value_or<std::int64_t>(1), name);
  const auto kept = fields_from<FitsFile>(TomlTable(&table, name));
  check_head(kept, name);
  for (const KeptFit& fit : kept.fit) {
    fits_[fit.name].insert_or_assign(fit.options,
                                     Kept{{{}, {}, fit.constants, fit.loss, {}}, true});
  }
}

std::optional<Fit> FitStore::find(const AskedFit& asked) const {
  const std::string name = asked.name();
  std::unique_lock lock(mutex_);
  const auto named = fits_.find(name);
  if (named == fits_.end()) return std::nullopt;
  const auto found = named->second.find(asked.options);
  if (found == named->second.end()) {
    const auto& [options, other] = *named->second.begin();
    if (other.from_file && !told_) {
      warn(
          fmt::format("{}: {} is there by other options, {} in place of {}: this and others like "
                      "it are searched again",
                      file_.string(), name, options, asked.options));
      told_ = true;
    }
    return std::nullopt;
  }
  const Kept kept = found->second;
  lock.unlock();
  Fit fit{asked.parameterisation.interpretation, asked.parameterisation.free, kept.fit.constants,
          kept.fit.loss, asked.left_out};
  if (kept.from_file) check_loss(asked, fit);
  return fit;
}

void FitStore::check_loss(const AskedFit& asked, const Fit& fit) const {
  const double loss = asked.loss(fit);
  if (std::abs(loss - fit.loss) <= same_loss * std::max(1.0, std::abs(loss))) return;
  throw InputError(fmt::format("{}: {}: has loss {}, but its constants have {}: remove the file",
                               file_.string(), asked.name(), fit.loss, loss));
}

void FitStore::add(const std::vector<AskedFit>& asked, const std::vector<Fit>& fits) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    fits_[asked[i].name()].insert_or_assign(asked[i].options, Kept{fits[i], false});
  }
  FitsFile file{suite_version, hash_of_data()};
  for (const auto& [name, named] : fits_) {
    for (const auto& [options, kept] : named) {
      file.fit.push_back({name, options, kept.fit.loss, kept.fit.constants});
    }
  }
  file.fits = std::ssize(file.fit);
  write_text_file(file_, toml_of_fields(file), SymbolicLinks::refused);
}

BestPoint start_of(const Problem& problem) {
  return {problem.start, problem.evaluate(problem.start).objective};
}

void improve(Problem& problem, const Solver& solver, std::int64_t evaluations, BestPoint& best) {
  problem.start = best.x;
  const RunRecord record = run(problem, solver, Budget{evaluations}, 0);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty() || record.trace.back().true_values.objective >= best.loss) return;
  best = {record.trace.back().x, record.trace.back().true_values.objective};
}

}  // namespace ricochet::studies::calibration
