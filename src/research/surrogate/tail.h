#pragma once

#include <cstddef>
#include <vector>

#include "src/report/json.h"

namespace ricochet::studies::surrogate {

/// Which share of the values is larger than limits from 1e-16 to 1: rows of limit and share.
report::Json tail_of(const std::vector<double>& rising);

/// How many of the values are larger.
std::size_t larger_than(double limit, const std::vector<double>& rising);

}  // namespace ricochet::studies::surrogate
