#include "solvers/tao/session.h"

#include <mpi.h>
#include <petscsys.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace ricochet::tao {
namespace {

/// Sets or removes environment variables and restores them on destruction: programs started later
/// may be parallel ones.
class Environment {
 public:
  explicit Environment(const std::map<std::string, std::optional<std::string>>& wanted) {
    for (const auto& [name, value] : wanted) {
      const char* const before = std::getenv(name.c_str());
      before_[name] = before ? std::optional<std::string>(before) : std::nullopt;
      put(name, value);
    }
  }
  ~Environment() {
    for (const auto& [name, value] : before_) put(name, value);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
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
  const Environment environment({{"OMPI_MCA_ess", "singleton"},
                                 {"OMPI_MCA_ess_singleton_isolated", "1"},
                                 {"OMPI_MCA_pmix", "isolated"},
                                 {"OMPI_MCA_pml", "ob1"},
                                 {"OMPI_MCA_btl", "self"},
                                 {"OMPI_MCA_mtl", "^ofi"},
                                 {"OMPI_MCA_osc", "^ucx"},
                                 {"OMPI_MCA_coll", "basic,self,libnbc"},
                                 {"PETSC_OPTIONS", std::nullopt}});
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
