#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// Searches whole numbers: values that are equal on plateaus and jump between them.
///
/// In the unit cube, again and again until the budget is spent: the best of five points (the start,
/// which only the first round has, and uniform ones) drifts (drift.h), a (1+1) evolution strategy
/// to which a step onto an equal value is a success like one onto a lower one: so its steps grow
/// until about two in eleven stay as low as they were, and it leaves a plateau however wide that
/// is. Points are compared by feasibility rules (Deb 2000, doi 10.1016/S0045-7825(99)00389-8): the
/// less violated, then the lower. No point is asked for twice. With constraints every other round,
/// at random, begins at the best point so far instead, with shorter steps.
///
/// Where the problem has derivatives and no constraints, a drift that has come to nothing is
/// followed by a descent (descent.h) of what is shown, at the smoothing widths 0.25 and 0.1 in
/// turn where there is that knob, and by another drift from where it led, while the true value
/// falls. Where there is the knob, drifts see what is judged.
///
/// Takes no equalities, and hands over the best point that it saw.
Solver plateau_search();

}  // namespace ricochet
