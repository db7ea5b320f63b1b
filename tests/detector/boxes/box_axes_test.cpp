#include "boxes/box_axes.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace quadrille {
namespace {

Face face_with(const Eigen::Vector3d& n, std::size_t points) {
  Face face;
  face.n_C = n.normalized();
  face.points_C.assign(points, Eigen::Vector3d::Zero());
  return face;
}

TEST_CASE("axes are a rotation, along the normals of two and of three faces", "[boxes]") {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, -2, 3).normalized()).matrix();
  const Face a = face_with(R.col(0), 10), b = face_with(R.col(1), 20), c = face_with(R.col(2), 5);
  const Face back = face_with(-R.col(2), 5);
  CHECK(box_axes({&a, &b}).isApprox(R, 1e-9));
  CHECK(box_axes({&a, &b, &c}).isApprox(R, 1e-9));
  const Eigen::Matrix3d mirrored = box_axes({&a, &b, &back});
  CHECK(mirrored.determinant() == Approx(1.0));
  CHECK(mirrored.leftCols<2>().isApprox(R.leftCols<2>(), 1e-9));
}

TEST_CASE("normals off the right angle share the error by their points", "[boxes]") {
  const double off = 0.06;
  const Face a = face_with(Eigen::Vector3d::UnitX(), 300);
  const Face b = face_with({std::sin(off), std::cos(off), 0.0}, 100);
  const Eigen::Matrix3d R = box_axes({&a, &b});
  CHECK((R.transpose() * R).isApprox(Eigen::Matrix3d::Identity(), 1e-9));
  CHECK(std::acos(R.col(0).dot(a.n_C)) == Approx(0.25 * off).epsilon(0.01));
  CHECK(std::acos(R.col(1).dot(b.n_C)) == Approx(0.75 * off).epsilon(0.01));
}

TEST_CASE("the axes of one face lie along the sides of its rectangle", "[boxes]") {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.5, Eigen::Vector3d(3, 1, 1).normalized()).matrix();
  Face face;
  face.n_C = R.col(2);
  for (int i = 0; i <= 40; ++i) {
    for (int k = 0; k <= 20; ++k) {
      face.points_C.push_back(R * Eigen::Vector3d(0.005 * i - 0.1, 0.005 * k - 0.05, 0.0));
    }
  }
  const Eigen::Matrix3d axes = box_axes({&face});
  CHECK(axes.col(0).isApprox(R.col(2), 1e-9));
  CHECK(axes.determinant() == Approx(1.0));
  const double along =
      std::max(std::abs(axes.col(1).dot(R.col(0))), std::abs(axes.col(2).dot(R.col(0))));
  CHECK(along == Approx(1.0).margin(1e-6));
}

}  // namespace
}  // namespace quadrille
