#pragma once

#include <vector>

#include "src/report/page.h"
#include "src/studies/dynamics/study.h"

/// The parts of the report, in its order. Each says first what it found.
namespace ricochet::studies::dynamics {

/// Restitution asked for against restitution returned, a line a contact law.
report::Section restitution_section(const std::vector<LawStudy>& laws);

/// What the methods' accuracy costs in one arena.
report::Section work_section(const SceneWork& work);

/// The speed of every method over that of the event-driven one, all arenas.
report::Section speed_section(const std::vector<SceneWork>& works);

/// Error against processor time, in one arena.
report::Figure work_chart(const SceneWork& work);

/// Where a compliant wall counts otherwise than a hard one.
report::Section fidelity_section(const FidelityStudy& fidelity);

/// Which level a scene needs, what the cheaper ones get wrong, and what each costs.
report::Section levels_section(const LevelStudy& study);

/// Where penalty methods count wrong, gain energy or give up.
report::Section stability_section(const StabilityStudy& stability);

/// Its maps, costs, and what a wall returns too much.
std::vector<report::Figure> stability_charts(const StabilityStudy& stability);

/// Which motions are chaotic, and how long an impact can be trusted.
report::Section lyapunov_section(const LyapunovStudy& study);

/// What every method does where the motion is hard to compute.
report::Section failure_modes_section(const FailureModeStudy& study);

/// What made this report.
report::Section origin_section(const Study& study);

}  // namespace ricochet::studies::dynamics
