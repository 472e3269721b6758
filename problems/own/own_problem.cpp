#include "problems/own/own_problem.h"

#include <fcntl.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>

#include "problems/own/program.h"
#include "src/core/child_process.h"
#include "src/core/instance.h"

namespace ricochet::own {

namespace {

/// Of the box, in the solver's coordinates: for forward differences of residuals.
constexpr double difference_step = 1e-6;

}  // namespace

/// Counts that forked processes share.
class SharedCounts {
 public:
  SharedCounts() {
    void* page =
        mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::bad_alloc();
    counts_ = new (page) Counts;
  }
  ~SharedCounts() { munmap(counts_, sizeof(Counts)); }
  SharedCounts(const SharedCounts&) = delete;
  SharedCounts& operator=(const SharedCounts&) = delete;

  void add(bool computed, const Given& given) {
    ++(computed ? counts_->computed : counts_->found);
    if (!given.failure.empty()) ++counts_->failed;
    counts_->seconds += given.seconds;
  }
  void ask(std::int64_t id) { counts_->asked = id; }
  EvaluationCounts read() const {
    return {counts_->computed, counts_->found, counts_->failed, counts_->seconds, counts_->asked};
  }

 private:
  struct Counts {
    std::atomic<std::int64_t> computed = 0, found = 0, failed = 0;
    std::atomic<double> seconds = 0;
    std::atomic<std::int64_t> asked = 0;
  };
  Counts* counts_;
};

/// Lets one process at a time compute a point: of others that ask for it meanwhile, forked from the
/// same one, each finds it then. The system takes back what a process holds that ends.
class ComputedPoints {
 public:
  ComputedPoints() : file_(memfd_create("points", MFD_CLOEXEC)) {
    if (file_.number() < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }

  class Hold {
   public:
    /// Waits until no other process holds the point. Where locks fail, it may be computed twice.
    Hold(const ComputedPoints& points, const Vector& x) : file_(points.file_.number()) {
      FnvHash hash;
      hash.add({reinterpret_cast<const char*>(x.data()),
                static_cast<std::size_t>(x.size()) * sizeof(double)});
      place_ = static_cast<off_t>(hash.value() >> 2);
      set(F_SETLKW, F_WRLCK);
    }
    ~Hold() { set(F_SETLK, F_UNLCK); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    void set(int how, short kind) const {
      struct flock lock = {};
      lock.l_type = kind;
      lock.l_whence = SEEK_SET;
      lock.l_start = place_;
      lock.l_len = 1;
      while (fcntl(file_, how, &lock) != 0 && errno == EINTR) {
      }
    }

    int file_;
    off_t place_;
  };

 private:
  Descriptor file_;
};

struct OwnProblem::Shared {
  Shared(ProblemFile its_file, std::string its_run)
      : file(std::move(its_file)),
        run(std::move(its_run)),
        program(std::make_shared<Program>(file)),
        store(std::make_shared<EvaluationStore>(store_of(file.path), program->content())) {}
  Shared(const Shared& other, std::string its_run)
      : file(other.file),
        run(std::move(its_run)),
        program(other.program),
        store(other.store),
        points(other.points) {}

  /// An evaluation at a point in the solver's coordinates, from the store if it is there; of a
  /// noisy problem the next one of this point, or its last one. A run is scored where it has just
  /// evaluated: that is neither read nor counted again.
  Given at(const Vector& seen, bool derivatives, bool last = false) {
    const Vector x = file.stated(seen);
    EvaluationKey key;
    {
      const std::scoped_lock lock(mutex);
      if ((!file.noise || last) && latest.x.size() == x.size() && latest.x == x &&
          (latest.derivatives || !derivatives)) {
        return latest.given;
      }
    }
    if (file.noise) {
      const std::scoped_lock lock(mutex);
      std::int64_t& attempt = attempts[std::vector<double>(x.begin(), x.end())];
      key = {run, last && attempt > 0 ? attempt - 1 : attempt++};
    }
    std::optional<Given> given = store->find(file, key, x, derivatives);
    bool computed = false;
    if (!given) {
      std::optional<ComputedPoints::Hold> hold;
      if (!file.noise) {  // another process may be about to compute the same
        hold.emplace(*points, x);
        given = store->find(file, key, x, derivatives);
      }
      computed = !given;
      if (computed && file.program.told) {
        counts.ask(store->ask(key, x, derivatives));
        throw std::runtime_error("its value at a point is not told yet: `ricochet ask` and `tell`");
      }
      if (computed) {
        given = store->keep(file, key, x, derivatives, program->evaluate(x, derivatives));
      }
    }
    if (computed || !last) counts.add(computed, *given);
    const std::scoped_lock lock(mutex);
    latest = {x, derivatives, *given};
    if (!given->failure.empty()) latest.x.resize(0);  // the store may forget it
    return *given;
  }

  double objective(const Given& given) const {
    return file.goal == Goal::maximise ? 0 - given.objective : given.objective;
  }

  Values values(const Given& given) const {
    Values values{objective(given), Vector(static_cast<Eigen::Index>(order.size()))};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double value = given.constraints[static_cast<Eigen::Index>(order[i])];
      const bool binary = file.constraints[order[i]].kind == ConstraintKind::binary;
      values.constraints[static_cast<Eigen::Index>(i)] = binary ? 2 * value - 1 : value;
    }
    return values;
  }

  /// Derivatives by a solver's coordinates from those by the file's: d/d(ln x) = x d/dx.
  Vector slopes(const Vector& seen) const {
    Vector slopes = Vector::Ones(seen.size());
    const Vector x = file.stated(seen);
    for (std::size_t i = 0; i < file.variables.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (file.variables[i].scale == Scale::logarithmic) slopes[k] = x[k];
    }
    return slopes;
  }

  Derivatives derivatives(const Vector& seen) {
    const Given given = at(seen, true);
    const Vector by = slopes(seen);
    Derivatives result{values(given), given.gradient.cwiseProduct(by),
                       Matrix(static_cast<Eigen::Index>(order.size()), seen.size())};
    if (file.goal == Goal::maximise) result.gradient = -result.gradient;
    for (std::size_t i = 0; i < order.size(); ++i) {
      result.jacobian.row(static_cast<Eigen::Index>(i)) =
          given.jacobian.row(static_cast<Eigen::Index>(order[i])).cwiseProduct(by.transpose());
    }
    return result;
  }

  Residuals residuals(const Vector& seen, const Vector& width, const Vector& upper) {
    if (file.program.derivatives) {
      const Given given = at(seen, true);
      return {given.residuals, given.residual_jacobian * slopes(seen).asDiagonal()};
    }
    Residuals result{at(seen, false).residuals, {}};
    result.jacobian.resize(result.values.size(), seen.size());
    for (Eigen::Index i = 0; i < seen.size(); ++i) {
      const double step = difference_step * width[i];
      Vector beside = seen;
      beside[i] += seen[i] + step > upper[i] ? -step : step;
      result.jacobian.col(i) =
          step > 0 ? Vector((at(beside, false).residuals - result.values) / (beside[i] - seen[i]))
                   : Vector::Zero(result.values.size());
    }
    return result;
  }

  const ProblemFile file;
  const std::string run;
  const std::vector<std::size_t> order = file.order();
  const std::shared_ptr<Program> program;
  const std::shared_ptr<EvaluationStore> store;
  const std::shared_ptr<ComputedPoints> points = std::make_shared<ComputedPoints>();
  SharedCounts counts;
  std::mutex mutex;
  std::map<std::vector<double>, std::int64_t> attempts;
  struct {
    Vector x = {};  ///< as the file states it; empty: none yet
    bool derivatives = false;
    Given given = {};
  } latest;
};

OwnProblem::OwnProblem(ProblemFile file, std::string run)
    : OwnProblem(std::make_shared<Shared>(std::move(file), std::move(run))) {}

OwnProblem OwnProblem::of_run(std::string run) const {
  return OwnProblem(std::make_shared<Shared>(*shared_, std::move(run)));
}

OwnProblem::OwnProblem(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {
  const ProblemFile& f = shared_->file;
  const auto n = static_cast<Eigen::Index>(f.variables.size());
  Vector lower(n), upper(n), start(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const FileVariable& v = f.variables[static_cast<std::size_t>(i)];
    problem_.variables.push_back({v.name, v.unit});
    lower[i] = v.lower;
    upper[i] = v.upper;
    start[i] = v.start.value();
  }
  problem_.name = f.name;
  problem_.source = "your own, " + f.path.filename().string();
  problem_.unit = f.unit;
  problem_.maximises = f.goal == Goal::maximise;
  problem_.lower = f.seen(lower);
  problem_.upper = f.seen(upper);
  problem_.start = f.seen(start);
  problem_.constraints = static_cast<Eigen::Index>(f.constraints.size());
  for (const FileConstraint& c : f.constraints) {
    if (c.kind == ConstraintKind::equality) ++problem_.equalities;
  }
  problem_.tolerance = f.tolerance;
  problem_.gradient_cost = f.program.gradient_cost;
  problem_.jumps = f.jumps || std::any_of(f.constraints.begin(), f.constraints.end(),
                                          [](const FileConstraint& c) {
                                            return c.kind == ConstraintKind::binary;
                                          });
  if (f.best_known) problem_.best_known = problem_.maximises ? 0 - *f.best_known : *f.best_known;
  problem_.evaluate = [shared = shared_](const Vector& x) {
    return shared->values(shared->at(x, false));
  };
  if (f.noise) {  // scored by what the solver was told, not by another evaluation
    problem_.true_values = [shared = shared_, equalities = problem_.equalities](const Vector& x) {
      return true_values_of(shared->values(shared->at(x, false, true)), equalities);
    };
  }
  if (f.program.derivatives) {
    problem_.differentiate = [shared = shared_](const Vector& x) { return shared->derivatives(x); };
  }
  if (f.program.residuals > 0) {
    if (!f.program.derivatives) {
      problem_.residual_values = [shared = shared_](const Vector& x) -> Vector {
        return shared->at(x, false).residuals;
      };
    }
    problem_.residuals = [shared = shared_, width = Vector(problem_.upper - problem_.lower),
                          upper = problem_.upper](const Vector& x) {
      return shared->residuals(x, width, upper);
    };
  }
}

const ProblemFile& OwnProblem::file() const {
  return shared_->file;
}

std::string OwnProblem::command() const {
  return shared_->program->command();
}

std::filesystem::path OwnProblem::store_path() const {
  return store_of(shared_->file.path);
}

EvaluationStore& OwnProblem::store() const {
  return *shared_->store;
}

EvaluationCounts OwnProblem::counts() const {
  return shared_->counts.read();
}

Given OwnProblem::evaluate_again(const Vector& stated) const {
  const ProblemFile& file = shared_->file;
  const bool derivatives = file.program.derivatives;
  const Given given = shared_->program->evaluate(stated, derivatives);
  if (!file.noise) shared_->store->keep(file, {}, stated, derivatives, given);
  return given;
}

std::filesystem::path store_of(const std::filesystem::path& problem_file) {
  std::filesystem::path store = problem_file;
  return store.replace_extension(".evaluations");
}

}  // namespace ricochet::own
