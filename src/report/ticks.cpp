#include "src/report/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::report {
namespace {

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

double step_of(const Range& limits, int wanted, bool whole_numbers) {
  const double raw = (limits.upper - limits.lower) / wanted;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= raw * (1 - 1e-9)) step = factor * power;
  return whole_numbers ? std::max(step, 1.0) : step;
}

}  // namespace

Range limits(const std::vector<double>& values, Scale scale) {
  const bool logarithmic = scale == Scale::logarithmic;
  if (values.empty()) return logarithmic ? Range{1, 10} : Range{0, 1};
  const auto [least, most] = std::ranges::minmax(values);
  if (logarithmic) {
    const double room = std::max(std::pow(most / least, 0.03), most < 2 * least ? 1.5 : 1.0);
    return {least / room, most * room};
  }
  const double span = most - least;
  const double scale_of_values = std::max(std::abs(least), std::abs(most));
  const bool flat = span <= 1e-9 * scale_of_values;
  const double room = !flat ? 0.04 * span : scale_of_values > 0 ? 0.5 * scale_of_values : 1.0;
  return {least - room, most + room};
}

double share(double value, const Range& limits, Scale scale) {
  if (scale == Scale::linear) return (value - limits.lower) / (limits.upper - limits.lower);
  return std::log(value / limits.lower) / std::log(limits.upper / limits.lower);
}

std::string number_label(double number) {
  std::string text = fmt::format("{:.10g}", std::abs(number));
  if (const auto power = text.find('e'); power != std::string::npos) {
    const std::string factor = text.substr(0, power) == "1" ? "" : text.substr(0, power) + "×";
    text = factor + power_of_ten(std::stoi(text.substr(power + 1)));
  }
  return number < 0 ? "−" + text : text;
}

std::vector<Tick> linear_ticks(const Range& limits, int wanted, bool whole_numbers) {
  const double step = step_of(limits, wanted, whole_numbers);
  const double slack = 1e-9 * step;
  const double first = std::ceil((limits.lower - slack) / step);
  std::vector<Tick> ticks;
  for (int i = 0; i <= 2 * wanted; ++i) {
    const double position = (first + i) * step;
    if (position > limits.upper + slack) break;
    ticks.push_back({std::clamp(position, limits.lower, limits.upper), number_label(position)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Range& limits, int wanted) {
  const int first = static_cast<int>(std::floor(std::log10(limits.lower)));
  const int last = static_cast<int>(std::ceil(std::log10(limits.upper)));
  const double decades = std::log10(limits.upper / limits.lower);
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / wanted)));
  const bool plain = limits.lower >= 1e-3 && limits.upper < 1e5;
  std::vector<Tick> ticks;
  const auto add = [&](double position, const std::string& label) {
    if (position >= limits.lower && position <= limits.upper) ticks.push_back({position, label});
  };
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = std::pow(10, exponent);
    const bool labelled = exponent % stride == 0;
    add(power, !labelled ? "" : plain ? fmt::format("{:g}", power) : power_of_ten(exponent));
    for (int digit = 2; digit <= 9 && decades <= 8; ++digit) {
      // Less than two decades have too few powers of ten to read off a value.
      const bool label_digit = (decades < 2 && (digit == 2 || digit == 5)) ||
                               (decades < 1 && (digit == 3 || digit == 7)) || decades < 0.5;
      add(digit * power, label_digit ? number_label(digit * power) : "");
    }
  }
  const auto labels = std::ranges::count_if(ticks, [](const Tick& t) { return !t.label.empty(); });
  return labels < 2 && decades < 1 ? linear_ticks(limits, wanted, false) : ticks;
}

}  // namespace ricochet::report
