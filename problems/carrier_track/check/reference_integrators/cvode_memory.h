#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>

#include <array>
#include <type_traits>

namespace ricochet::carrier_track::inline reference_integrators {

/// Owns a C object that is freed through a pointer to its handle, or by its handle.
template <class Handle, auto free>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    if (handle_) release(handle_);
  }
  Owned& operator=(Handle handle) {
    handle_ = handle;
    return *this;
  }
  operator Handle() const { return handle_; }
  Handle* address() { return &handle_; }

 private:
  static void release(Handle& handle) {
    if constexpr (std::is_invocable_v<decltype(free), Handle*>) {
      free(&handle);
    } else {
      free(handle);
    }
  }
  Handle handle_ = nullptr;
};

/// Throws std::runtime_error with `what` unless `done`.
void require_cvode(bool done, const char* what);

/// Throws std::runtime_error with the name of a negative return flag.
void require_cvode_flag(int flag);

/// CVODE's integrator of a position and a velocity, with one relative and one absolute tolerance
/// for both. Its nonlinear solver must still be set. Throws std::runtime_error if CVODE fails.
class CvodeMemory {
 public:
  /// `method` is CV_ADAMS or CV_BDF; `user` is passed to `slope`.
  CvodeMemory(int method, CVRhsFn slope, void* user, double tolerance, double absolute);

  std::array<double, 2>& state() { return state_; }
  SUNContext context() const { return context_; }
  N_Vector vector() const { return vector_; }
  void* get() const { return memory_; }

 private:
  static void free_memory(void** memory) { CVodeFree(memory); }

  std::array<double, 2> state_{};
  // NOTE: freed from the last to the first; the context must outlive the others.
  Owned<SUNContext, SUNContext_Free> context_;
  Owned<N_Vector, N_VDestroy> vector_;
  Owned<void*, free_memory> memory_;
};

}  // namespace ricochet::carrier_track::inline reference_integrators
