// What a solver holds does not tell what a run is scored by. These are checked when they compile.

#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>

#include "ricochet/run.h"
#include "src/core/evaluator.h"

namespace ricochet {
namespace {

template <class T>
concept TellsTheProblem = requires(T& t) {
  t.problem();
}
|| requires(T& t) {
  t.problem_;
}
|| std::convertible_to<T&, const Problem&>;

template <class T>
concept TellsTheTrueObjective = requires(T& t, const Vector& x) {
  t.true_values(x);
}
|| requires(T& t) {
  t.true_values;
}
|| requires(T& t) {
  t.score();
};

template <class T>
concept TellsTheBestPoint = requires(T& t) {
  t.best();
}
|| requires(T& t) {
  t.best_point;
}
|| requires(T& t) {
  t.best_point();
};

template <class T>
concept TellsTheBestValue = requires(T& t) {
  t.best_known;
}
|| requires(T& t) {
  t.best_known();
};

template <class T>
concept TellsTheTrace = requires(T& t) {
  t.trace();
}
|| requires(T& t) {
  t.scorer();
}
|| requires(T& t) {
  t.scorer_;
}
|| std::convertible_to<T&, const Scorer&>;

template <class T>
concept EvaluatesForNothing = requires(T& t, const Vector& x) {
  t.evaluate(x);
}
|| requires(T& t, const Vector& x) {
  t.differentiate(x);
};

template <class T>
concept TellsNothingOfTheScore =
    !TellsTheProblem<T> && !TellsTheTrueObjective<T> && !TellsTheBestPoint<T> &&
    !TellsTheBestValue<T> && !TellsTheTrace<T> && !EvaluatesForNothing<T>;

static_assert(TellsNothingOfTheScore<Evaluator>);
static_assert(!std::is_copy_constructible_v<Evaluator> && !std::is_move_constructible_v<Evaluator>,
              "a copy would have a budget of its own");
static_assert(!std::is_assignable_v<Evaluator&, const Evaluator&>);

// The checks find what they look for.
static_assert(TellsTheTrueObjective<Problem> && TellsTheBestPoint<Problem> &&
              TellsTheBestValue<Problem> && EvaluatesForNothing<Problem> &&
              TellsTheProblem<Problem>);
static_assert(TellsTheBestPoint<Scorer> && TellsTheTrace<Scorer>);

// A solver is called with nothing else.
static_assert(std::is_same_v<decltype(Solver::solve),
                             std::function<SolverTermination(Evaluator&, const Vector&, Random&)>>);

TEST(NoLeak, IsCheckedByTheCompiler) {}

}  // namespace
}  // namespace ricochet
