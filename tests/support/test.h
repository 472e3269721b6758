#pragma once

/// What most tests include, compiled once (tests/CMakeLists.txt), and what they call by its short
/// name.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ricochet {
namespace fs = std::filesystem;
using testing::AllOf, testing::Contains, testing::Each, testing::ElementsAre, testing::EndsWith,
    testing::FieldsAre, testing::HasSubstr, testing::IsEmpty, testing::Not, testing::StartsWith;
}  // namespace ricochet
