#pragma once

#include "src/features/feature.h"

namespace ricochet {

/// The variables come in another order, with their names: one of those in which none stays where it
/// was and all form one cycle, each as likely (Sattolo, Information Processing Letters 22 (1986)
/// 315, doi 10.1016/0020-0190(86)90073-6). For two variables or more.
Feature permuted();

/// A variable is replaced by its negative on the toss of a coin, and one at least. Every bit of
/// what the problem tells stays as it was.
Feature reflected();

/// The problem is turned about its best point by a uniformly random orthogonal matrix. The box
/// stays, but that it grows where it must to hold the start; the variables, now mixed, have no
/// names. For problems that may be turned, see Problem::rotates, of two variables or more.
Feature rotated();

}  // namespace ricochet
