#pragma once

/// A problem for direct_tao(), which is loaded from a shared library.
struct DirectTao {
  int n, m, limit;  ///< variables, residuals (0: none are shown), evaluations
  const double *lower, *upper;
  /// Tells the Jacobian of the residuals by columns, where that is not null; else the m residuals.
  /// With m = 0: returns the value, and tells the gradient where that is not null.
  double (*tell)(const DirectTao& asked, const double* u, double* told, double* jacobian);
  const void* data;
};
