#pragma once

#include <cstddef>
#include <vector>

#include "src/report/json.h"

namespace ricochet::studies::surrogate {

/// Share of the values above limits from 1e-16 to 1: rows of limit and share.
report::Json tail_of(const std::vector<double>& rising);

/// Number of values above the limit.
std::size_t larger_than(double limit, const std::vector<double>& rising);

}  // namespace ricochet::studies::surrogate
