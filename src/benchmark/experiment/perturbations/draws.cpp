#include "src/benchmark/experiment/perturbations/draws.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace ricochet {
namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 divided by the golden ratio, odd

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

}  // namespace

std::uint64_t key_of(std::uint64_t key, std::uint64_t number) {
  // NOTE: without the sum, key 0 and number 0 would give 0 again.
  return mixed((key ^ number) + golden);
}

std::uint64_t key_of(std::uint64_t key, std::string_view name) {
  for (const char c : name) key = key_of(key, static_cast<unsigned char>(c));
  return key;
}

std::uint64_t key_of(std::uint64_t key, const Vector& point) {
  for (const double x : point) key = key_of(key, std::bit_cast<std::uint64_t>(x + 0.0));
  return key;
}

std::uint64_t Draws::bits() {
  state_ += golden;
  return mixed(state_);
}

double Draws::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Draws::normal() {
  const double length = std::sqrt(-2 * std::log(1 - uniform()));
  return length * std::cos(2 * std::numbers::pi * uniform());
}

double Draws::cauchy() {
  return std::tan(std::numbers::pi * (uniform() - 0.5));
}

}  // namespace ricochet
