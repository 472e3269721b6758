#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"

/// What the charts of this study have in common.
namespace ricochet::studies::surrogate {

/// A large chart without series.
report::Chart large_chart(std::string name, report::Axis x, report::Axis y);

/// A series that has samples.
void add(report::Chart& chart, report::Series series);

/// Which share of the values is larger, for limits from 1e-16 to 1.
report::Series tail_of(std::string label, const std::vector<double>& rising);

/// How many of the values are larger.
std::size_t larger_than(double limit, const std::vector<double>& rising);

}  // namespace ricochet::studies::surrogate
