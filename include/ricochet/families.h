#pragma once

/// @file
/// All families of problems.

#include "problems/families.h"
