#ifndef RICOCHET_RICOCHET_H
#define RICOCHET_RICOCHET_H

/**
 * @file
 * The C interface of ricochet: for solvers that ricochet loads (ricochet_plugin), and for programs
 * in any language that evaluate its problems (ricochet_open) or simulate a machine
 * (ricochet_open_machine). Solvers and programs use the same ricochet_problem.
 *
 * Vectors are arrays of double of the length given; matrices are row-major. Arrays for results may
 * be NULL unless said otherwise. No exception may pass through these functions. After an error,
 * ricochet_error has the reason.
 *
 * Several threads may use one problem of ricochet_open or ricochet_open_scene at once: its
 * functions take turns. Only one thread at a time may use a machine. The problem that a solver was
 * given is answered in the thread in which ricochet called solve; calls from others fail, and so
 * does the run.
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

/** The values at a point of a problem of your own: arrays for what is asked for, NULL for the rest.
 * They are NaN before; what stays so has no value. Matrices are row-major. */
typedef struct ricochet_values_at {
  int32_t abi; /**< RICOCHET_ABI of the program that asks */
  int32_t dimension;
  int32_t constraints;
  int32_t residuals;
  double* objective; /**< with residuals: may be left as it is, for half their squares' sum */
  double* constraint_values; /**< constraints, in the order of the problem file */
  double* gradient;          /**< dimension */
  double* jacobian;          /**< constraints x dimension */
  double* residual_values;   /**< residuals */
  double* residual_jacobian; /**< residuals x dimension */
} ricochet_values_at;

/** The function that a shared library with a problem of your own exports; see
 * docs/your-own-problem.md. Returns 0, or anything else if there are no values at x (dimension). In
 * C++ it may throw a std::exception. It is called in a process of its own. */
int32_t ricochet_evaluate(const double* x, ricochet_values_at* values);

/** RICOCHET_ABI of the library. */
int32_t ricochet_abi(void);
/** The version of the library, such as "0.2.0". */
const char* ricochet_version(void);

/** Opens the problem of this name in this formulation (NULL or "": the true objective), as instance
 * 0 (original) or 1, 2, ... (moved, reflected), with `budget` evaluations, and `seed` for
 * uniform(). Returns NULL on an error, see ricochet_error. Close it with ricochet_close. The first
 * call takes 0.1 s because it makes all problems. */
ricochet_problem* ricochet_open(const char* problem, const char* formulation, int32_t instance,
                                int64_t budget, uint64_t seed);
/** The same for a problem of the machine in a file (TOML), such as "profile-count-8-scene":
 * `ricochet list problems --scene FILE` lists their names. Takes the time of a threshold, about a
 * second, if the last call named another file or the file has changed. */
ricochet_problem* ricochet_open_scene(const char* scene, const char* problem,
                                      const char* formulation, int32_t instance, int64_t budget,
                                      uint64_t seed);
void ricochet_close(ricochet_problem* problem);

/** @name An open problem, by functions
 * For languages that cannot call the pointers of a ricochet_problem, which do the same. They take
 * problems of ricochet_open and ricochet_open_scene; any other pointer is an error. */
/** @{ */
const char* ricochet_name(const ricochet_problem* problem);  /**< NULL on an error, as all names */
const char* ricochet_unit(const ricochet_problem* problem);  /**< of the objective; "": none */
int32_t ricochet_dimension(const ricochet_problem* problem); /**< -1 on an error */
int32_t ricochet_constraints(const ricochet_problem* problem);     /**< -1 on an error */
int32_t ricochet_equalities(const ricochet_problem* problem);      /**< -1 on an error */
int32_t ricochet_has_derivatives(const ricochet_problem* problem); /**< -1 on an error */
int32_t ricochet_has_residuals(const ricochet_problem* problem);   /**< -1 on an error */

/** Both of length dimension. Returns 0, or 1 on an error. */
int32_t ricochet_bounds(const ricochet_problem* problem, double* lower, double* upper);
int32_t ricochet_start(const ricochet_problem* problem, double* start);

/** Name and unit of variable 0, 1, ..., dimension - 1; "" if it has none. */
const char* ricochet_variable_name(const ricochet_problem* problem, int32_t index);
const char* ricochet_variable_unit(const ricochet_problem* problem, int32_t index);

/** The best true objective of a feasible point that is known, and the gap to it that still counts
 * as solved. NaN if none is known, and on an error. */
double ricochet_best_known(const ricochet_problem* problem);
double ricochet_tolerance(const ricochet_problem* problem);

int32_t ricochet_values(ricochet_problem* problem, const double* x, double* objective,
                        double* constraints);
int32_t ricochet_derivatives(ricochet_problem* problem, const double* x, double* objective,
                             double* constraints, double* gradient, double* jacobian);
int32_t ricochet_residual_count(ricochet_problem* problem, const double* x);
int32_t ricochet_residuals(ricochet_problem* problem, const double* x, double* residuals,
                           double* jacobian);
int64_t ricochet_remaining(ricochet_problem* problem); /**< -1 on an error */
double ricochet_uniform(ricochet_problem* problem);    /**< NaN on an error */

/** ricochet_values at many points, one after another: `points` is count x dimension, `objectives`
 * has length count, `constraints` is count x constraints. Returns the number of points evaluated:
 * less than count once the run is over. */
int64_t ricochet_values_batch(ricochet_problem* problem, const double* points, int64_t count,
                              double* objectives, double* constraints);

/** The true objective at x, and the largest constraint violation (0 if x is feasible). Costs no
 * evaluation. Returns 0, or 1 on an error. */
int32_t ricochet_judge(ricochet_problem* problem, const double* x, double* objective,
                       double* violation);
/** @} */

/** @name A machine
 * Units are rad/s, s, m and m/s. Omega is the constant speed of the driver plate. */
/** @{ */
typedef struct ricochet_machine ricochet_machine;

/** The machine in a file (TOML, see docs/machine-files.md; "-": standard input), or in the text of
 * one. Returns NULL on an error, which names the file ("text"), the key, the value and what is
 * allowed. Close it with ricochet_close_machine. */
ricochet_machine* ricochet_open_machine(const char* file);
ricochet_machine* ricochet_parse_machine(const char* text);
void ricochet_close_machine(ricochet_machine* machine);

/** The text of its file. */
const char* ricochet_machine_text(const ricochet_machine* machine);
/** The speed in its file; NaN if that is a profile, and on an error. */
double ricochet_machine_speed(const ricochet_machine* machine);

/** Sets the time limit [s] of each later call of a machine in this thread: > 0, INFINITY for none;
 * 60 if it is not set. A call that reaches it returns what it knows: ricochet_simulate a count up
 * to there that is not certain, ricochet_regimes a last regime that ends by "time-limit",
 * ricochet_quiet_speed NaN for what is not known; ricochet_counts fails, as do the others if they
 * know nothing. Results that are there in time do not depend on it. Returns 0, or 1 on an error. */
int32_t ricochet_limit_seconds(double seconds);
/** How far the last of these calls in this thread came before the time limit: ricochet_simulate [s]
 * of the window, ricochet_regimes and ricochet_quiet_speed [rad/s]. NaN if it was complete. */
double ricochet_reached(void);

/** The collision counts at `size` speeds, one simulation each. Neighbours should be similar, which
 * makes it several times as fast. Neither array may be NULL. Returns 0, or 1 on an error. */
int32_t ricochet_counts(const ricochet_machine* machine, const double* omegas, int64_t size,
                        int32_t* counts);

/** Simulates the machine at this speed, NaN for the speed or profile in its file, and keeps the
 * recording until the next call: the collision count, whether it is certain, and what
 * ricochet_impacts, ricochet_path and ricochet_doubt tell. The path is sampled about `samples`
 * times in the window; 0: there is no path. Costs five simulations. Returns 0, or 1 on an error. */
int32_t ricochet_simulate(ricochet_machine* machine, double omega, int64_t samples, int32_t* count,
                          int32_t* certain);
/** Why the count is not certain; "" if it is. */
const char* ricochet_doubt(const ricochet_machine* machine);
/** Times, approach speeds and walls (0 lower, 1 upper) of all impacts. Returns their number, which
 * is the length of the arrays; -1 on an error. */
int64_t ricochet_impacts(const ricochet_machine* machine, double* times, double* speeds,
                         int32_t* walls);
/** Samples of the motion. Returns their number as ricochet_impacts does. */
int64_t ricochet_path(const ricochet_machine* machine, double* times, double* positions,
                      double* velocities);

/** Finds what the machine does in the long run over the speeds from..to, within 0.001..1000, and
 * keeps these regimes until the next call. Returns their number; -1 on an error. */
int64_t ricochet_regimes(ricochet_machine* machine, double from, double to);
/** The regimes, by increasing speed: range, collisions in a turn, turns of a period (0: the motion
 * does not repeat), whether the carrier rests in every period, whether the regime is certain.
 * Returns their number as ricochet_impacts does. */
int64_t ricochet_regime_table(const ricochet_machine* machine, double* from, double* to,
                              double* mean_per_turn, double* least_per_turn, double* most_per_turn,
                              int32_t* turns, int32_t* rests, int32_t* certain);
/** What ends regime 0, 1, ... at its fast end, such as "counting-limit". */
const char* ricochet_regime_end(const ricochet_machine* machine, int64_t index);

/** The fastest quiet speed, the first loud one, and the limit that divides them, as `ricochet
 * threshold` finds them; NaN where there is none: if no speed is quiet, not even the slowest, there
 * is no fastest quiet one, and the first loud one is the slowest. Quiet are at most `at_most` of
 * `measure`: "collisions" in the window, "collisions-per-turn", "energy" [J] in the window,
 * "impact-speed"; NULL for two collisions per turn in the long run or, of a machine without
 * regimes, for the level below the largest step of its counts. `fastest` ends the range, NaN: 18.
 * Returns 0, or 1 on an error. */
int32_t ricochet_quiet_speed(const ricochet_machine* machine, const char* measure, double at_most,
                             double fastest, double* quiet, double* first_loud, double* limit);
/** @} */

/** The name of problem 0, 1, 2, ..., in static storage; NULL past the last one. */
const char* ricochet_problem_name(int32_t index);

/** The message of the last error in this thread; "" if there was none. */
const char* ricochet_error(void);

#ifdef __cplusplus
}
#endif

#endif
