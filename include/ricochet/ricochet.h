#ifndef RICOCHET_RICOCHET_H
#define RICOCHET_RICOCHET_H

/**
 * @file
 * The C interface of ricochet: for solvers that ricochet loads (ricochet_plugin), and for programs
 * of any language that ask its questions (ricochet_open). Both see the same ricochet_problem.
 *
 * Vectors are arrays of double of the length given; matrices are row-major. Nothing may be thrown
 * through these functions. A problem is used by one thread at a time.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface: rises whenever a structure below changes. */
#define RICOCHET_ABI 2

/** A minimisation problem within a box: objective, and constraints of which the equalities come
 * first and must be 0, the others <= 0. */
typedef struct ricochet_problem {
  int32_t abi; /**< RICOCHET_ABI of who made it */
  int32_t dimension;
  int32_t constraints; /**< equalities and others */
  int32_t equalities;
  int32_t has_derivatives;
  int32_t has_residuals;
  const char* name;
  const double* lower; /**< dimension */
  const double* upper; /**< dimension */
  const double* start; /**< dimension */

  /** Objective and constraints at x; costs one evaluation. Returns 0, or 1 once the run is over
   * (the budget is spent, or x is not finite): then return. `objective` or `constraints` may be
   * NULL: asking for both of one point, one after the other, costs one evaluation, too. */
  int32_t (*values)(struct ricochet_problem* problem, const double* x, double* objective,
                    double* constraints);

  /** The same with the gradient of the objective (dimension) and the Jacobian of the constraints
   * (constraints x dimension), each of which may be NULL; costs 1 + dimension evaluations, or
   * dimension where the values at x were just asked for. Only where has_derivatives. */
  int32_t (*derivatives)(struct ricochet_problem* problem, const double* x, double* objective,
                         double* constraints, double* gradient, double* jacobian);

  /** How many residuals there are, told by those at x. Costs one evaluation, which whoever then
   * asks for the residuals at x has paid; nothing once it is known. Returns 0 once the run is over.
   * Only where has_residuals. */
  int32_t (*residual_count)(struct ricochet_problem* problem, const double* x);

  /** The residuals at x (residual_count), of whose squares the objective is half the sum, or that
   * of a smooth stand-in for it; and their Jacobian (residual_count x dimension), which may be
   * NULL. Costs one evaluation, with the Jacobian 1 + dimension, or dimension where the residuals
   * at x were just asked for; what else is known of x makes them no cheaper. Returns as values()
   * does. Only where has_residuals. */
  int32_t (*residuals)(struct ricochet_problem* problem, const double* x, double* residuals,
                       double* jacobian);

  /** Evaluations left. */
  int64_t (*remaining)(struct ricochet_problem* problem);

  /** A number uniform in [0, 1), from the run's own seed: a solver that draws all its numbers here
   * makes the same run again. */
  double (*uniform)(struct ricochet_problem* problem);
} ricochet_problem;

/** What a shared library exports, under the name ricochet_plugin, to be a solver:
 *
 *     const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "mine", "1.0", 0, 0, 0, 0, solve};
 */
typedef struct ricochet_solver {
  int32_t abi; /**< RICOCHET_ABI */
  const char* name;
  const char* version;
  int32_t takes_constraints; /**< 0: none; 1: inequalities; 2: equalities, too */
  int32_t needs_derivatives;
  int32_t needs_residuals;
  int32_t stochastic;

  /** Minimises from problem->start until it is done or values() returns 1; ricochet starts it
   * again elsewhere while evaluations are left. `point` (dimension) holds the start, and takes the
   * point handed over; left as it is, the best one shown is. Returns why it ended, in static
   * storage, or NULL. May be called from several threads at once, each with a problem of its own;
   * from C++ it may throw a std::exception, which ends the run as a failure. */
  const char* (*solve)(ricochet_problem* problem, double* point);
} ricochet_solver;

/** Declared so that its definition is exported from C++, too, where constants are not. */
extern const ricochet_solver ricochet_plugin;

/** The question of this name in this form (NULL or "": as it is judged), as instance 0 (as stated)
 * or 1, 2, ... (moved, reflected); `budget` evaluations, and `seed` for uniform(). NULL where
 * something is wrong: see ricochet_error. To be closed. The first call takes a tenth of a
 * second, for it makes all questions. */
ricochet_problem* ricochet_open(const char* question, const char* form, int32_t instance,
                                int64_t budget, uint64_t seed);
void ricochet_close(ricochet_problem* problem);

/** What the suite judges by: the true objective and the largest violation, 0 where feasible.
 * Costs nothing. Returns 0, or 1 where something is wrong. */
int32_t ricochet_judge(ricochet_problem* problem, const double* x, double* objective,
                       double* violation);

/** The name of a question: of index 0, 1, 2, ..., and NULL where there are no more. Static. */
const char* ricochet_question_name(int32_t index);

/** What went wrong last in this thread; "" where nothing did. */
const char* ricochet_error(void);

#ifdef __cplusplus
}
#endif

#endif
