#pragma once

#include "grasping/exact_overlap.hpp"
#include "grasping/scenes.hpp"

namespace quadrille::test {

/// A box of a finger's sizes, one in four along the axes of C.
inline OrientedBox random_box(std::mt19937& random, const Eigen::AlignedBox3d& region) {
  OrientedBox box;
  if (random() % 4) box.R_CB = random_rotation(random);
  box.p_CB = random_point(random, region);
  for (int i = 0; i < 3; ++i) box.half[i] = uniform(random, 0.002, 0.03);
  return box;
}

/// How far a box goes along d until it just touches a solid that it starts in [m].
inline double touching(const ExactSolid& solid, OrientedBox box, const Eigen::Vector3d& d) {
  double hit = 0.0, free = 1.0;
  const Eigen::Vector3d start = box.p_CB;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (hit + free);
    box.p_CB = start + middle * d;
    (solid.meets(box) ? hit : free) = middle;
  }
  return hit;
}

}  // namespace quadrille::test
