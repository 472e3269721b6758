#ifndef RICOCHET_RICOCHET_H
#define RICOCHET_RICOCHET_H

/**
 * @file
 * The C interface of ricochet: for solvers that ricochet loads (ricochet_plugin), and for programs
 * in any language that evaluate its problems (ricochet_open). Both use the same ricochet_problem.
 *
 * Vectors are arrays of double of the length given; matrices are row-major. No exception may pass
 * through these functions. Only one thread at a time may use a problem.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface: increases whenever a structure below changes. */
#define RICOCHET_ABI 3

/** A minimisation problem with bounds. The constraints are the equalities (= 0), then the
 * inequalities (<= 0). A violation of up to 1e-6 is allowed. */
typedef struct ricochet_problem {
  int32_t abi; /**< RICOCHET_ABI of the program that made it */
  int32_t dimension;
  int32_t constraints; /**< equalities and inequalities */
  int32_t equalities;
  int32_t has_derivatives;
  int32_t has_residuals;
  const char* name;
  const double* lower; /**< dimension */
  const double* upper; /**< dimension */
  const double* start; /**< dimension */

  /** Objective and constraints at x; costs one evaluation. Returns 0, or 1 once the run is over
   * (the budget is spent, or x is not finite): the solver must then return. `objective` or
   * `constraints` may be NULL. Two calls in a row for one point, one for each, cost one evaluation
   * together. */
  int32_t (*values)(struct ricochet_problem* problem, const double* x, double* objective,
                    double* constraints);

  /** The same with the gradient of the objective (dimension) and the Jacobian of the constraints
   * (constraints x dimension), each of which may be NULL. Costs 1 + dimension evaluations, or
   * dimension if the previous call evaluated x. Only if has_derivatives. */
  int32_t (*derivatives)(struct ricochet_problem* problem, const double* x, double* objective,
                         double* constraints, double* gradient, double* jacobian);

  /** The number of residuals, from evaluating them at x. The first call costs one evaluation; a
   * call of residuals() at the same x then costs one less. Later calls cost nothing. Returns 0 once
   * the run is over. Only if has_residuals. */
  int32_t (*residual_count)(struct ricochet_problem* problem, const double* x);

  /** The residuals at x (residual_count) and their Jacobian (residual_count x dimension), which may
   * be NULL. Half the sum of their squares is the objective, or a smooth surrogate of it. Costs one
   * evaluation; with the Jacobian 1 + dimension, or dimension if the residuals at x were evaluated
   * just before. Other evaluations at x do not reduce the cost. Returns 0 or 1 as values() does.
   * Only if has_residuals. */
  int32_t (*residuals)(struct ricochet_problem* problem, const double* x, double* residuals,
                       double* jacobian);

  /** Evaluations left. */
  int64_t (*remaining)(struct ricochet_problem* problem);

  /** A uniform random number in [0, 1), from the run's seed. A run is reproducible if the solver
   * draws all its random numbers here. */
  double (*uniform)(struct ricochet_problem* problem);
} ricochet_problem;

/** A solver, which a shared library exports under the name ricochet_plugin:
 *
 *     const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "mine", "1.0", 0, 0, 0, 0, solve};
 */
typedef struct ricochet_solver {
  int32_t abi; /**< RICOCHET_ABI */
  const char* name;
  const char* version;
  int32_t takes_constraints; /**< 0: none; 1: inequalities; 2: also equalities */
  int32_t needs_derivatives;
  int32_t needs_residuals;
  int32_t stochastic;

  /** Minimises from problem->start until it is done or values() returns 1; ricochet restarts it
   * from another point while evaluations are left. `point` (dimension) holds the start; write the
   * returned point there. If it is left unchanged, the best evaluated point is returned. Returns
   * the termination reason in static storage, or NULL. May be called from several threads at once,
   * each with a different problem. In C++ it may throw a std::exception: the run then fails. */
  const char* (*solve)(ricochet_problem* problem, double* point);
} ricochet_solver;

/** Declared here so that C++ also exports its definition: constants are not exported there. */
extern const ricochet_solver ricochet_plugin;

/** Opens the problem of this name in this formulation (NULL or "": the true objective), as instance
 * 0 (original) or 1, 2, ... (moved, reflected), with `budget` evaluations, and `seed` for
 * uniform(). Returns NULL on an error, see ricochet_error. Close it with ricochet_close. The first
 * call takes 0.1 s because it makes all problems. */
ricochet_problem* ricochet_open(const char* problem, const char* formulation, int32_t instance,
                                int64_t budget, uint64_t seed);
/** The same for a problem of the machine in a file (TOML), such as "profile-count-8-scene":
 * `ricochet list problems --scene FILE` lists their names. Takes the time of a threshold, about a
 * second. */
ricochet_problem* ricochet_open_scene(const char* scene, const char* problem,
                                      const char* formulation, int32_t instance, int64_t budget,
                                      uint64_t seed);
void ricochet_close(ricochet_problem* problem);

/** The true objective at x, and the largest constraint violation (0 if x is feasible). Costs no
 * evaluation. Returns 0, or 1 on an error. */
int32_t ricochet_judge(ricochet_problem* problem, const double* x, double* objective,
                       double* violation);

/** The name of problem 0, 1, 2, ..., in static storage; NULL past the last one. */
const char* ricochet_problem_name(int32_t index);

/** The message of the last error in this thread; "" if there was none. */
const char* ricochet_error(void);

#ifdef __cplusplus
}
#endif

#endif
