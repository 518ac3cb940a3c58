// SPDX-License-Identifier: Apache-2.0
#include "geometry/accelerators/bvh/oriented_box.h"

#include <algorithm>
#include <limits>

namespace lume::geometry::bvh {
namespace {

/// Turns a symmetric matrix in the plane of axes p and q so that its element (p, q) becomes 0, and
/// `axes` along with it (Jacobi 1846; Golub and Van Loan, "Matrix Computations", section 8.5.2).
void turn(DMat3& matrix, DMat3& axes, int p, int q) {
  if (matrix[p][q] == 0.0) return;
  const double ratio = 0.5 * (matrix[q][q] - matrix[p][p]) / matrix[p][q];
  const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::hypot(ratio, 1.0));
  const double cosine = 1.0 / std::hypot(tangent, 1.0);
  const double sine = tangent * cosine;
  const auto turn_columns = [=](DMat3& m) {
    const DVec3 column_p = m[p];
    m[p] = cosine * column_p - sine * m[q];
    m[q] = sine * column_p + cosine * m[q];
  };
  turn_columns(matrix);
  matrix = glm::transpose(matrix);
  turn_columns(matrix);
  matrix[p][q] = matrix[q][p] = 0.0;
  turn_columns(axes);
}

/// The eigenvectors of the points' covariance, as columns.
DMat3 principal_axes(std::span<const Vec3> points) {
  DVec3 mean(0.0);
  for (const Vec3& point : points) mean += DVec3(point);
  mean /= static_cast<double>(points.size());
  DMat3 covariance(0.0);
  for (const Vec3& point : points) {
    const DVec3 way = DVec3(point) - mean;
    covariance += glm::outerProduct(way, way);
  }
  DMat3 axes(1.0);
  constexpr int k_sweeps = 6;  // each squares what is left beside the diagonal
  for (int sweep = 0; sweep < k_sweeps; ++sweep) {
    turn(covariance, axes, 0, 1);
    turn(covariance, axes, 0, 2);
    turn(covariance, axes, 1, 2);
  }
  return axes;
}

OrientedBox fit(OrientedBox box, std::span<const Vec3> points) {
  box.lower = DVec3(std::numeric_limits<double>::infinity());
  box.upper = -box.lower;
  for (const Vec3& point : points) {
    for (int i = 0; i < 3; ++i) {
      const double height = dot(DVec3(box.axes[i]), DVec3(point));
      box.lower[i] = std::min(box.lower[i], height);
      box.upper[i] = std::max(box.upper[i], height);
    }
  }
  return box;
}

}  // namespace

OrientedBox OrientedBox::around(const Bounds& box, std::span<const Vec3> points) {
  OrientedBox straight;
  straight.lower = DVec3(box.lower);
  straight.upper = DVec3(box.upper);
  const DMat3 axes = principal_axes(points);
  OrientedBox turned;
  turned.axes = {Vec3(axes[0]), Vec3(axes[1]), Vec3(axes[2])};
  turned = fit(turned, points);
  return half_area(turned) < half_area(straight) ? turned : straight;
}

}  // namespace lume::geometry::bvh
