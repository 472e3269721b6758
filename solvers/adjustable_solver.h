#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ricochet/solver.h"
#include "src/core/fields.h"
#include "src/core/names.h"

namespace ricochet {

/// An option of a solver that a plan may change: a number, or one of `words` if there are any.
struct SolverOption {
  std::string name;
  std::string usual;  ///< the default, as text for people
  Range range = {};
  std::vector<std::string> words = {};  ///< allowed words; "*": any

  bool allows(const OptionValue& value) const;
  std::string allowed() const;  ///< e.g. "a whole number from 1 to 1000000"
};

/// A solver of the suite that can be made with other options than its defaults.
struct AdjustableSolver {
  std::string name;
  std::vector<SolverOption> options;
  /// Makes the solver with these options, whose values are allowed; with none it is the suite's
  /// solver. Throws std::invalid_argument if the options contradict each other, or this build of
  /// the solver cannot use one.
  std::function<Solver(const GivenOptions&)> with;
};

/// The default of an option as text. One that depends on the problem is a missing optional, and its
/// field's remark says what it is.
inline std::string usual_of(const Field& /*field*/, double usual) {
  return text_of(OptionValue(usual));
}
template <class Number>
std::string usual_of(const Field& field, const std::optional<Number>& usual) {
  return usual ? text_of(OptionValue(static_cast<double>(*usual))) : std::string(field.remark);
}
template <HasNames Word>
std::string usual_of(const Field& /*field*/, Word usual) {
  return std::string(name_of(names_of(usual), usual));
}

/// The words that an option may have; none for a number.
template <class Value>
std::vector<std::string> words_of(const Value& value) {
  std::vector<std::string> words;
  if constexpr (HasNames<Value>) {
    for (const auto& [word, meaning] : names_of(value)) words.emplace_back(word);
  }
  return words;
}

/// The options that a struct lists as its fields; their defaults are those of `own`.
template <HasFields Options>
std::vector<SolverOption> options_in(const Options& own) {
  std::vector<SolverOption> options;
  visit_fields(
      [&](const Field& field, const auto& usual) {
        options.push_back(
            {std::string(field.key), usual_of(field, usual), field.range, words_of(usual)});
      },
      own);
  return options;
}

template <class Number>
void give(const OptionValue& value, Number& target) {
  target = static_cast<Number>(std::get<double>(value));
}
template <class Number>
void give(const OptionValue& value, std::optional<Number>& target) {
  target = static_cast<Number>(std::get<double>(value));
}
/// The word is allowed.
template <HasNames Word>
void give(const OptionValue& value, Word& target) {
  for (const auto& [word, meaning] : names_of(target)) {
    if (word == std::get<std::string>(value)) target = meaning;
  }
}

/// The struct with the options given in place of its own.
template <HasFields Options>
Options with_given(Options options, const GivenOptions& given) {
  visit_fields(
      [&](const Field& field, auto& target) {
        const auto found = given.find(std::string(field.key));
        if (found != given.end()) give(found->second, target);
      },
      options);
  return options;
}

/// The solver that `make` makes of a struct of options.
template <HasFields Options, class Make>
AdjustableSolver adjustable(const std::string& name, const Options& own, const Make& make) {
  return {name, options_in(own),
          [own, make](const GivenOptions& given) { return make(with_given(own, given)); }};
}

constexpr Field real_option(std::string_view name, double least, double most) {
  return {name, "1", "", {.least = least, .most = most}};
}

inline constexpr Field coordinates_option{"coordinates"};  ///< of a member `Coordinates`

/// `usual` describes a default that depends on the problem.
constexpr Field whole_option(std::string_view name, double least, double most = 1e6,
                             std::string_view usual = "") {
  return {name, "1", usual, whole_number(least, most)};
}

/// Which settings a solver runs with. Both are reported, under different names: a solver tuned on
/// the problems of this suite has an unfair advantage over one that is not.
enum class Settings {
  own,   ///< the defaults of its library or its authors
  tuned  ///< the settings that did best in a sweep on this suite
};

/// Every solver of this build that has options.
std::vector<AdjustableSolver> adjustable_solvers();

/// The solver `of` under another name and with these options instead of its defaults; its version
/// lists them. Throws InputError if there is no such solver with options, for an unknown option,
/// and for a value that is not allowed.
Solver varied(const std::string& of, const std::string& name, const GivenOptions& given);

/// The options of a solver. Throws InputError if there is no such solver with options.
std::vector<SolverOption> options_of(const std::string& solver);

}  // namespace ricochet
