#include "problems/carrier_track/check/reference_integrators/cvode_memory.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ricochet::carrier_track::inline reference_integrators {

void require_cvode(bool done, const char* what) {
  if (!done) throw std::runtime_error(std::string("CVODE: ") + what);
}

void require_cvode_flag(int flag) {
  if (flag >= 0) return;
  char* name = CVodeGetReturnFlagName(flag);
  const std::string text = name;
  std::free(name);
  require_cvode(false, text.c_str());
}

CvodeMemory::CvodeMemory(int method, CVRhsFn slope, void* user, double tolerance, double absolute) {
  require_cvode_flag(SUNContext_Create(nullptr, context_.address()));
  vector_ = N_VMake_Serial(2, state_.data(), context_);
  require_cvode(vector_ != nullptr, "no memory for the state");
  memory_ = CVodeCreate(method, context_);
  require_cvode(memory_ != nullptr, "no memory for the integrator");
  require_cvode_flag(CVodeSetErrHandlerFn(
      memory_, [](int, const char*, const char*, char*, void*) {}, nullptr));
  require_cvode_flag(CVodeInit(memory_, slope, 0.0, vector_));
  require_cvode_flag(CVodeSetUserData(memory_, user));
  require_cvode_flag(CVodeSStolerances(memory_, tolerance, absolute));
}

}  // namespace ricochet::carrier_track::inline reference_integrators
