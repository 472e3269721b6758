#include "src/research/limits/study.h"

#include <fmt/format.h>

#include "src/core/interruption.h"
#include "src/research/limits/results.h"

namespace ricochet::studies {

Study limits_study(const std::filesystem::path& folder) {
  const auto compute = [folder](bool quick) {
    std::filesystem::create_directories(folder);
    const std::filesystem::path fits = folder / "fits.toml";
    calibration::FitStore store(fits);
    const AtInterruption kept([] {}, fmt::format("finished searches are kept in {}: the same "
                                                 "command goes on",
                                                 fits.string()));
    return limits::data_of(
        limits::limits(quick ? limits::quick_plan() : limits::full_plan(), store));
  };
  return {"limits", "A first look, in half a minute: nothing converges", compute};
}

}  // namespace ricochet::studies
