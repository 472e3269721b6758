#pragma once

/// A problem for direct_tao(), which is loaded from a shared library.
struct DirectTao {
  int n, m, limit;  ///< variables, residuals (0: none are shown), evaluations
  const double *lower, *upper;
  double (*value)(void* data, const double* u);
  double (*gradient)(void* data, const double* u, double* gradient);  ///< returns the value
  void (*residuals)(void* data, const double* u, double* residuals);
  void (*jacobian)(void* data, const double* u, double* by_columns);
  void* data;
};
