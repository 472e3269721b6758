#include <mpi.h>
#include <petscsys.h>
#include <petsctao.h>
#include <ricochet/ricochet.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ricochet::tao {

/// Initialises PETSc on the first call; it is never finalised. PETSc prints nothing, reads no
/// options from files or the environment, leaves the process's signal handlers as they were, and
/// its MPI knows this process only and starts no other. Returns whether PETSc is available. Only
/// one thread at a time may call this; a process that forks must not have called it before.
bool initialised();

// The adapter of TAO's solvers to the C interface, in a separate shared library: PETSc's MPI and
// the MPI stub of sequential Ipopt must not see each other's symbols.

namespace {

/// A callback returns this to make TAO stop at once.
constexpr PetscErrorCode give_up = PETSC_ERR_USER;

/// In the order of ricochet's; see there.
enum class Coordinates { unit, even, own };

/// A problem in these coordinates, x = origin + scale * u. A coordinate without width has u = 0.
struct Evaluations {
  ricochet_problem* problem;
  std::vector<double> origin, scale, x, best_x, rows, first;
  double best = std::numeric_limits<double>::infinity();
  std::set<Vec> seen;       // vectors seen by residuals_at
  bool over = false;        // the run is over
  bool not_finite = false;  // the last numbers sent to TAO

  Evaluations(ricochet_problem* asked, Coordinates coordinates)
      : problem(asked),
        origin(asked->lower, asked->lower + size()),
        scale(size()),
        x(asked->start, asked->start + size()) {
    for (std::size_t i = 0; i < size(); ++i) scale[i] = asked->upper[i] - asked->lower[i];
    if (coordinates == Coordinates::unit) return;
    const double longest = *std::max_element(scale.begin(), scale.end());
    for (std::size_t i = 0; i < size(); ++i) {
      if (scale[i] == 0) continue;
      scale[i] = coordinates == Coordinates::own ? 1 : longest;
      if (coordinates == Coordinates::own) origin[i] = 0;
    }
  }

  std::size_t size() const { return static_cast<std::size_t>(problem->dimension); }

  void move_to(const double* u) {
    for (std::size_t i = 0; i < size(); ++i) x[i] = origin[i] + scale[i] * u[i];
  }
  double to_scaled(std::size_t i, const double* point) const {
    return scale[i] > 0 ? (point[i] - origin[i]) / scale[i] : 0;
  }

  /// The return code for TAO after a call that returned `refused` with this objective.
  PetscErrorCode end(int32_t refused, double objective) {
    over = refused != 0;
    not_finite = !over && !std::isfinite(objective);
    if (over || not_finite) return give_up;
    if (objective < best) {
      best = objective;
      best_x = x;
    }
    return 0;
  }
};

Evaluations& asked(void* context) {
  return *static_cast<Evaluations*>(context);
}

PetscErrorCode move_to(Evaluations& self, Vec u) {
  const PetscScalar* at = nullptr;
  PetscCall(VecGetArrayRead(u, &at));
  self.move_to(at);
  return VecRestoreArrayRead(u, &at);
}

PetscErrorCode objective_at(Tao, Vec u, PetscReal* objective, void* context) {
  Evaluations& self = asked(context);
  PetscCall(move_to(self, u));
  const int32_t refused = self.problem->values(self.problem, self.x.data(), objective, nullptr);
  return self.end(refused, *objective);
}

PetscErrorCode slope_at(Tao, Vec u, PetscReal* objective, Vec gradient, void* context) {
  Evaluations& self = asked(context);
  PetscCall(move_to(self, u));
  PetscScalar* slope = nullptr;
  PetscCall(VecGetArray(gradient, &slope));
  const int32_t refused =
      self.problem->derivatives(self.problem, self.x.data(), objective, nullptr, slope, nullptr);
  double sum = refused != 0 ? 0 : *objective;
  for (std::size_t i = 0; i < self.size(); ++i) sum += std::abs(slope[i] *= self.scale[i]);
  PetscCall(VecRestoreArray(gradient, &slope));
  if (refused == 0 && !std::isfinite(sum)) return self.end(0, sum);
  return self.end(refused, *objective);
}

/// The residuals at self.x. Those computed at the start, before TAO began, are used once more.
PetscErrorCode tell_residuals(Evaluations& self, PetscScalar* values, std::size_t count) {
  if (!self.first.empty()) {
    std::copy(self.first.begin(), self.first.end(), values);
    self.first.clear();
    return 0;
  }
  const int32_t refused = self.problem->residuals(self.problem, self.x.data(), values, nullptr);
  double sum = 0;
  for (std::size_t i = 0; i < count && refused == 0; ++i) sum += values[i] * values[i];
  return self.end(refused, sum);
}

PetscErrorCode residuals_at(Tao, Vec u, Vec residuals, void* context) {
  Evaluations& self = asked(context);
  PetscCall(move_to(self, u));
  PetscScalar* values = nullptr;
  PetscInt count = 0;
  PetscCall(VecGetLocalSize(residuals, &count));
  PetscCall(VecGetArray(residuals, &values));
  const PetscErrorCode error = tell_residuals(self, values, static_cast<std::size_t>(count));
  PetscCall(VecRestoreArray(residuals, &values));
  for (Vec each : {u, residuals}) {
    if (self.seen.insert(each).second) {
      PetscObjectReference(reinterpret_cast<PetscObject>(each));
    }
  }
  return error;
}

PetscErrorCode residual_slopes_at(Tao, Vec u, Mat jacobian, Mat, void* context) {
  Evaluations& self = asked(context);
  PetscCall(move_to(self, u));
  PetscInt count = 0, n = 0;
  PetscCall(MatGetSize(jacobian, &count, &n));
  self.rows.resize(static_cast<std::size_t>(count) * self.size());
  self.over = self.problem->residuals(self.problem, self.x.data(), nullptr, self.rows.data()) != 0;
  if (self.over) return give_up;
  PetscScalar* columns = nullptr;
  PetscCall(MatDenseGetArrayWrite(jacobian, &columns));
  bool finite = true;
  for (PetscInt j = 0; j < n; ++j) {
    for (PetscInt i = 0; i < count; ++i) {
      const double slope = self.rows[static_cast<std::size_t>(i) * static_cast<std::size_t>(n) +
                                     static_cast<std::size_t>(j)] *
                           self.scale[static_cast<std::size_t>(j)];
      columns[j * count + i] = slope;
      finite = finite && std::isfinite(slope);
    }
  }
  PetscCall(MatDenseRestoreArrayWrite(jacobian, &columns));
  PetscCall(MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY));
  self.not_finite = !finite;
  return finite ? 0 : give_up;
}

/// Destroys a vector however many references it has: POUNDERS leaks the vectors it has just made if
/// its function fails.
void destroy(Vec vec) {
  PetscInt holders = 0;
  PetscObjectGetReference(reinterpret_cast<PetscObject>(vec), &holders);
  for (; holders > 0; --holders) {
    Vec held = vec;
    VecDestroy(&held);
  }
}

/// One start, with all PETSc objects that it owns.
class Search {
 public:
  explicit Search(Evaluations& asked) : asked_(asked) {}
  ~Search() {
    TaoDestroy(&tao_);
    for (Vec* each : {&u_, &lower_, &upper_, &residuals_}) VecDestroy(each);
    MatDestroy(&jacobian_);
    for (Vec each : asked_.seen) destroy(each);
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  // Each call may fail.
  PetscErrorCode prepare(TaoType type) {  // NOLINT(readability-function-size)
    const auto n = static_cast<PetscInt>(asked_.size());
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, n, &u_));
    PetscCall(VecDuplicate(u_, &lower_));
    PetscCall(VecDuplicate(u_, &upper_));
    PetscScalar *at = nullptr, *lower = nullptr, *upper = nullptr;
    PetscCall(VecGetArray(u_, &at));
    PetscCall(VecGetArray(lower_, &lower));
    PetscCall(VecGetArray(upper_, &upper));
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      lower[i] = asked_.to_scaled(i, asked_.problem->lower);
      upper[i] = asked_.scale[i] > 0 ? asked_.to_scaled(i, asked_.problem->upper) : 1;
      at[i] = std::clamp(asked_.to_scaled(i, asked_.problem->start), lower[i], upper[i]);
    }
    asked_.move_to(at);
    PetscCall(VecRestoreArray(u_, &at));
    PetscCall(VecRestoreArray(lower_, &lower));
    PetscCall(VecRestoreArray(upper_, &upper));
    PetscCall(TaoCreate(PETSC_COMM_SELF, &tao_));
    PetscCall(TaoSetType(tao_, type));
    PetscCall(TaoSetSolution(tao_, u_));
    PetscCall(TaoSetVariableBounds(tao_, lower_, upper_));
    PetscCall(TaoSetMaximumIterations(tao_, std::numeric_limits<PetscInt>::max()));
    // POUNDERS allocates for all evaluations at once; no run comes near a million.
    const std::int64_t left = asked_.problem->remaining(asked_.problem);
    const auto most = static_cast<PetscInt>(std::clamp<std::int64_t>(left, 0, 1'000'000));
    return TaoSetMaximumFunctionEvaluations(tao_, most + 1);
  }

  PetscErrorCode show_slopes() {
    PetscCall(TaoSetObjective(tao_, objective_at, &asked_));
    return TaoSetObjectiveAndGradient(tao_, nullptr, slope_at, &asked_);
  }

  PetscErrorCode show_residuals() {
    const PetscInt count = asked_.problem->residual_count(asked_.problem, asked_.x.data());
    asked_.over = count == 0;
    if (asked_.over) return give_up;
    // POUNDERS leaks memory if its first call fails.
    std::vector<double> first(static_cast<std::size_t>(count));
    PetscCall(tell_residuals(asked_, first.data(), first.size()));
    asked_.first = first;
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, count, &residuals_));
    PetscCall(TaoSetResidualRoutine(tao_, residuals_, residuals_at, &asked_));
    const auto n = static_cast<PetscInt>(asked_.size());
    PetscCall(MatCreateSeqDense(PETSC_COMM_SELF, count, n, nullptr, &jacobian_));
    return TaoSetJacobianResidualRoutine(tao_, jacobian_, jacobian_, residual_slopes_at, &asked_);
  }

  PetscErrorCode solve() { return TaoSolve(tao_); }

  const char* reason() const {
    TaoConvergedReason reason = TAO_CONTINUE_ITERATING;
    TaoGetConvergedReason(tao_, &reason);
    return TaoConvergedReasons[reason];
  }

 private:
  Evaluations& asked_;
  Tao tao_ = nullptr;
  Vec u_ = nullptr, lower_ = nullptr, upper_ = nullptr, residuals_ = nullptr;
  Mat jacobian_ = nullptr;
};

const char* search(Evaluations& asked, TaoType type, PetscErrorCode (Search::*show)()) {
  static std::mutex one_at_a_time;  // PETSc is not thread-safe
  const std::lock_guard lock(one_at_a_time);
  if (!initialised()) return "PETSc could not be initialised";
  Search search(asked);
  PetscErrorCode error = search.prepare(type);
  if (error == 0) error = (search.*show)();
  if (error == 0) error = search.solve();
  if (asked.not_finite) return "a number is not finite";
  if (error == 0) return search.reason();
  const char* message = nullptr;
  PetscErrorMessage(error, &message, nullptr);
  return message != nullptr ? message : "PETSc failed";
}

template <auto show, Coordinates coordinates>
const char* solve(TaoType type, ricochet_problem* problem, double* point) {
  Evaluations asked(problem, coordinates);
  const char* const reason = search(asked, type, show);
  std::copy(asked.best_x.begin(), asked.best_x.end(), point);
  return reason;
}

}  // namespace

}  // namespace ricochet::tao

using namespace ricochet::tao;

#define EXPORTED extern "C" __attribute__((visibility("default")))
#define IN(coordinates, type, show, slopes, residuals)                                 \
  {                                                                                    \
    RICOCHET_ABI, "tao-" type, "", 0, slopes, residuals, 0,                            \
        [](ricochet_problem* problem, double* point) -> const char* {                  \
          return solve<&Search::show, Coordinates::coordinates>(type, problem, point); \
        }                                                                              \
  }
#define IN_EACH(...) IN(unit, __VA_ARGS__), IN(even, __VA_ARGS__), IN(own, __VA_ARGS__)
#define BY_SLOPES(type) IN_EACH(type, show_slopes, 1, 0)
#define BY_RESIDUALS(type) IN_EACH(type, show_residuals, 0, 1)

EXPORTED const ricochet_solver ricochet_tao_solvers[] = {
    BY_SLOPES("blmvm"), BY_SLOPES("bqnls"), BY_SLOPES("bncg"), BY_RESIDUALS("pounders"),
    BY_RESIDUALS("brgn")};

namespace ricochet::tao {

namespace {

/// Sets or removes environment variables and restores them on destruction, and others that change
/// meanwhile: programs started later may be parallel ones.
class Environment {
 public:
  Environment(const std::map<std::string, std::optional<std::string>>& wanted,
              const std::vector<std::string>& others) {
    for (const std::string& name : others) keep(name);
    for (const auto& [name, value] : wanted) {
      keep(name);
      put(name, value);
    }
  }
  ~Environment() {
    for (const auto& [name, value] : before_) put(name, value);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  void keep(const std::string& name) {
    const char* const before = std::getenv(name.c_str());
    before_[name] = before ? std::optional<std::string>(before) : std::nullopt;
  }
  static void put(const std::string& name, const std::optional<std::string>& value) {
    if (value) {
      setenv(name.c_str(), value->c_str(), 1);
    } else {
      unsetenv(name.c_str());
    }
  }

  std::map<std::string, std::optional<std::string>> before_;
};

/// Restores all signal handlers on destruction: MPI replaces nearly every one.
class SignalHandlers {
 public:
  SignalHandlers() {
    for (int number = 1; number < NSIG; ++number) sigaction(number, nullptr, &before_[number]);
  }
  ~SignalHandlers() {
    for (int number = 1; number < NSIG; ++number) sigaction(number, &before_[number], nullptr);
  }
  SignalHandlers(const SignalHandlers&) = delete;
  SignalHandlers& operator=(const SignalHandlers&) = delete;

 private:
  struct sigaction before_[NSIG] = {};
};

bool initialise() {
  // A single process: no daemon, no network, even within a parallel job. Missing components need
  // not be searched for, which takes ten times as long.
  const Environment environment(
      {{"OMPI_MCA_ess", "singleton"},
       {"OMPI_MCA_ess_singleton_isolated", "1"},
       {"OMPI_MCA_pmix", "isolated"},
       {"OMPI_MCA_pml", "ob1"},
       {"OMPI_MCA_btl", "self"},
       {"OMPI_MCA_mtl", "^ofi"},
       {"OMPI_MCA_osc", "^ucx"},
       {"OMPI_MCA_coll", "basic,self,libnbc"},
       {"HWLOC_HIDE_ERRORS", "2"},  // without /sys it would print one
       {"PETSC_OPTIONS", std::nullopt}},
      // What MPI leaves there, and a program of its own would stumble on.
      {"HFI_NO_BACKTRACE", "OMPI_APP_CTX_NUM_PROCS", "OMPI_MCA_orte_ess_num_procs",
       "OMPI_MCA_orte_precondition_transports", "ORTE_SCHIZO_DETECTION",
       "PMIX_MCA_mca_base_component_show_load_errors"});
  const SignalHandlers handlers;
  int there = 0;
  MPI_Initialized(&there);
  int level = 0;
  if (!there && MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level) != MPI_SUCCESS) {
    return false;
  }
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_set_errhandler(MPI_COMM_SELF, MPI_ERRORS_RETURN);
  char name[] = "ricochet", files[] = "-skip_petscrc", signals[] = "-no_signal_handler";
  char* words[] = {name, files, signals, nullptr};
  char** arguments = words;
  int count = 3;
  if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) return false;
  return PetscPushErrorHandler(PetscReturnErrorHandler, nullptr) == 0;  // print nothing, return
}

}  // namespace

bool initialised() {
  static const bool done = initialise();
  return done;
}

}  // namespace ricochet::tao
