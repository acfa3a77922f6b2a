#include "wirepack/dynamics/gear_values.hpp"

namespace wirepack {

void gear_predict(GearValues& values) {
  const Eigen::Index n = values.rows();
  double* const v0 = values.col(0).data();
  double* const v1 = v0 + n;
  double* const v2 = v1 + n;
  double* const v3 = v2 + n;
  double* const v4 = v3 + n;
  double* const v5 = v4 + n;
  // Pascal's triangle, in one pass over the coordinates
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x1 = v1[i], x2 = v2[i], x3 = v3[i], x4 = v4[i], x5 = v5[i];
    v0[i] += x1 + x2 + x3 + x4 + x5;
    v1[i] = x1 + 2 * x2 + 3 * x3 + 4 * x4 + 5 * x5;
    v2[i] = x2 + 3 * x3 + 6 * x4 + 10 * x5;
    v3[i] = x3 + 4 * x4 + 10 * x5;
    v4[i] = x4 + 5 * x5;
  }
}

void gear_correct(GearValues& values, const Eigen::Ref<const Eigen::VectorXd>& acceleration,
                  double step, const GearWeights& weights) {
  const Eigen::Index n = values.rows();
  const double half_square = step * step / 2;
  double* const v0 = values.col(0).data();
  double* const v1 = v0 + n;
  double* const v2 = v1 + n;
  double* const v3 = v2 + n;
  double* const v4 = v3 + n;
  double* const v5 = v4 + n;
  const double* const a = acceleration.data();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double correction = half_square * a[i] - v2[i];
    v0[i] += weights[0] * correction;
    v1[i] += weights[1] * correction;
    v2[i] += weights[2] * correction;
    v3[i] += weights[3] * correction;
    v4[i] += weights[4] * correction;
    v5[i] += weights[5] * correction;
  }
}

}  // namespace wirepack
