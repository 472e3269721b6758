#ifndef RICOCHET_MINIMISE_H
#define RICOCHET_MINIMISE_H

/**
 * @file
 * Solvers of the suite on a problem of a caller's own, in the caller's process:
 * libricochet_minimise, which is linked with the libraries of the solvers (NLopt, Ipopt, ...), as
 * libricochet is not.
 */

#include <ricochet/ricochet.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a minimisation is to do, and what came of it. Fields that are 0 have their default. */
typedef struct ricochet_minimisation {
  int32_t abi;           /**< RICOCHET_ABI of the program that made it */
  const char* solver;    /**< a name of `ricochet list solvers`; NULL: "auto" */
  int64_t budget;        /**< evaluations, >= 1 */
  int32_t seed;          /**< >= 0; the same seed gives the same run, to the bit */
  int32_t jumps;         /**< not 0: values jump, as counts do; "auto" looks at it */
  int64_t gradient_cost; /**< of derivatives beside the value [evaluations]; 0: dimension */

  double* point;       /**< dimension, must be given: gets the best evaluated point; NaN: none */
  double objective;    /**< of that point; NaN: none */
  double violation;    /**< its largest violation of a constraint; 0: feasible; NaN: none */
  int64_t evaluations; /**< that were charged */
  int64_t failed;      /**< calls that gave no number, or NaN, for a part that was asked for */
  double seconds;      /**< of processor time in this thread */
  const char* chosen;  /**< the solver that ran */
  const char* why;     /**< why "auto" chose it; "" if it was named */
  const char* ended;   /**< how the run ended; after an error, what is wrong */
} ricochet_minimisation;

/** Minimises a problem that the caller fills in, with abi, dimension, constraints, equalities,
 * bounds and start. It is asked by `values`; by `derivatives` if has_derivatives, which also says
 * whether `residuals` has a Jacobian; by `residual_count`, once, and `residuals` if has_residuals,
 * which unconstrained problems are asked for. `remaining` and `uniform` are not used. `name` goes
 * into the seed; NULL: "problem".
 *
 * These functions are called in this thread. They get arrays for what is asked for and NULL for the
 * rest, full of NaN: what stays so has no value. They return 0; a positive number if there are no
 * values at x, which costs that evaluation alone; a negative one to stop the run. Without a
 * Jacobian of the residuals it is computed by forward differences, each a call of `residuals`. A
 * solver that takes no constraints sees them as a penalty; the best point is chosen by their own
 * values.
 *
 * The run goes on from points uniform in the box while evaluations are left. Returns 0, also if the
 * run was stopped or no evaluation had a value; 1 on an error. The texts last until the next call
 * in this thread. A solver that crashes takes the process with it; the program ricochet runs each
 * in a process of its own. */
int32_t ricochet_minimise(ricochet_problem* problem, ricochet_minimisation* minimisation);

#ifdef __cplusplus
}
#endif

#endif
