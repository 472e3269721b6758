#pragma once

/// A problem for direct_tao(), which is loaded from a shared library.
struct DirectTao {
  int n, m, limit;  ///< variables, residuals (0: none are shown), evaluations
  const double *lower, *upper;
  /// Returns the value; tells of the rest what is not null, the Jacobian by columns.
  double (*tell)(void* data, const double* u, double* gradient, double* residuals,
                 double* jacobian);
  void* data;
};
