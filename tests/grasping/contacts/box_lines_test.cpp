#include "contacts/box_lines.hpp"

#include <algorithm>

#include "support/catch.hpp"

namespace quadrille {
namespace {

Box box_of(const Eigen::Vector3d& size) {
  Box box;
  box.id = 4;
  box.X_CB = Eigen::Translation3d(0.1, 0.2, 0.7) *
             Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 1, 2).normalized());
  box.size = size;
  box.std = Eigen::Vector3d::Constant(0.001);
  box.seen = {true, true, true};
  box.inner_B = {-0.5 * size, 0.5 * size};
  box.outer_B = box.inner_B;
  return box;
}

TEST_CASE("contacts lie opposite on parallel faces of a box", "[contacts][boxes]") {
  const Box box = box_of({0.12, 0.08, 0.05});
  const BoxLines found = box_lines(box, franka_hand());
  CHECK(found.unmeasured == 0);
  Eigen::Vector3i pairs = Eigen::Vector3i::Zero();
  for (const ContactLine& line : found.lines) {
    int axis = 0;
    (box.X_CB.linear().transpose() * line.closing_C).cwiseAbs().maxCoeff(&axis);
    ++pairs[axis];
    CHECK(line.width == Approx(box.size[axis]));
    CHECK((line.contacts_C[0] - line.contacts_C[1]).norm() == Approx(line.width));
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d p_B = box.X_CB.inverse() * line.contacts_C[i];
      CHECK(std::abs(p_B[axis]) == Approx(0.5 * box.size[axis]));
      // Within the face, and the normals out of it.
      for (int k = 0; k < 3; ++k) CHECK(std::abs(p_B[k]) < 0.5 * box.size[k] + 1e-9);
      CHECK(line.normals_C[i].dot(line.contacts_C[i] - line.centre_C) > 0.0);
    }
  }
  CHECK(pairs.minCoeff() >= 5);
}

TEST_CASE("a face that was not seen is taken at its bound, if that is tight", "[contacts][boxes]") {
  Box box = box_of({0.12, 0.08, 0.05});
  box.seen[2] = false;
  box.outer_B.min().z() -= 0.01;
  bool across = false;
  for (const ContactLine& line : box_lines(box, franka_hand()).lines) {
    if (std::abs(line.closing_C.dot(box.X_CB.linear().col(2))) < 0.9) continue;
    across = true;
    CHECK(line.opening == Approx(0.06));
    CHECK(line.std >= 0.005);
  }
  CHECK(across);
  box.outer_B.min().z() -= 0.03;
  const BoxLines loose = box_lines(box, franka_hand());
  CHECK(loose.unmeasured == 1);
  for (const ContactLine& line : loose.lines) {
    CHECK(std::abs(line.closing_C.dot(box.X_CB.linear().col(2))) < 0.1);
  }
}

/// A box of one upright face, 9 cm wide and 12 cm high. Its depth is a guess of 28 mm, of which the
/// 6 mm next to the face were seen; it may be 60 mm.
Box box_of_one_face() {
  Box box = box_of({0.12, 0.09, 0.028});
  box.seen[2] = false;
  box.inner_B.min().z() = 0.008;
  box.outer_B.min().z() = -0.046;
  return box;
}

TEST_CASE("no contact lies in the guessed part of a box of one face", "[contacts][boxes]") {
  const Box box = box_of_one_face();
  const BoxLines found = box_lines(box, franka_hand());
  CHECK(found.unmeasured == 1);
  REQUIRE(!found.lines.empty());
  for (const ContactLine& line : found.lines) {
    for (const Eigen::Vector3d& p_C : line.contacts_C) {
      const double z = (box.X_CB.inverse() * p_C).z();
      CHECK((z > 0.008 - 1e-9 && z < 0.014 + 1e-9));
    }
  }
}

TEST_CASE("contacts lie down to the plane on which a box rests", "[contacts][boxes]") {
  // Only the top was seen, but the box reaches down to its outer bound.
  Box box = box_of({0.12, 0.08, 0.05});
  box.seen[2] = false;
  box.inner_B.min().z() = 0.025;
  double lowest = 1.0;
  for (const ContactLine& line : box_lines(box, franka_hand()).lines) {
    lowest = std::min(lowest, (box.X_CB.inverse() * line.centre_C).z());
  }
  CHECK(lowest < -0.01);
}

}  // namespace
}  // namespace quadrille
