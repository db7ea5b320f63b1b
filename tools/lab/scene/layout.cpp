#include "lab/scene/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/scene/bodies.hpp"
#include "lab/scene/render.hpp"

namespace quadrille::scene {
namespace {

Eigen::Matrix3d turn_about_z(const Eigen::Vector2d& direction) {
  Eigen::Matrix3d R;
  R << direction.x(), -direction.y(), 0, direction.y(), direction.x(), 0, 0, 0, 1;
  return R;
}

/// Finds a free place for a body; returns false if there is none.
bool place(const FamilyTraits& traits, const std::vector<Body>& bodies, std::size_t first,
           Random* random, Body* body) {
  for (int attempt = 0; attempt < 60; ++attempt) {
    const Eigen::Vector2d p = traits.radius * std::sqrt(random->uniform()) * random->direction();
    const bool is_free = std::all_of(bodies.begin() + static_cast<std::ptrdiff_t>(first),
                                     bodies.end(), [&](const Body& other) {
                                       return (other.X_WB.translation().head<2>() - p).norm() >=
                                              other.reach + body->reach + traits.gap;
                                     });
    if (!is_free) continue;
    body->X_WB.linear() = turn_about_z(random->direction());
    body->X_WB.translation() << p, 0.0;
    return true;
  }
  return false;
}

/// Returns the pose of a camera that looks at the middle of the table from y < 0.
Eigen::Isometry3d camera_pose(const FamilyTraits& traits, Random* random) {
  const double t = random->uniform(traits.min_elevation, traits.max_elevation);
  const double cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  const double distance = random->uniform(2.2, 2.7) * traits.radius + 0.15;
  const Eigen::Vector3d target(random->uniform(-0.03, 0.03), random->uniform(-0.03, 0.03), 0.04);
  const Eigen::Vector3d forward(0, cosine, -sine);
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d right(1, 0, 0);
  X_WC.linear() << right, forward.cross(right), forward;
  X_WC.translation() = target - distance * forward;
  return X_WC.inverse();
}

Layout draw_layout(const FamilyTraits& traits, Random* random) {
  Layout layout;
  layout.bodies = {make_table(random->uniform(0.6, 0.8), random->uniform(0.5, 0.6)), make_wall()};
  layout.bodies[1].X_WB.translation().y() = random->uniform(0.62, 0.9);
  const std::size_t first = layout.bodies.size();
  const int quadrics = random->integer(traits.min_quadrics, traits.max_quadrics);
  const int boxes = random->integer(traits.min_boxes, traits.max_boxes);
  for (int i = 0; i < quadrics + boxes; ++i) {
    const double scale = random->uniform(traits.min_scale, traits.max_scale);
    Body body = i < quadrics ? random_quadric(scale, random) : random_box(scale, random);
    if (place(traits, layout.bodies, first, random, &body)) layout.bodies.push_back(body);
  }
  layout.X_CW = camera_pose(traits, random);
  return layout;
}

/// Returns how far the occlusions lie outside the family's bounds; 0 means that they fit.
double misfit(const FamilyTraits& traits, const Layout& layout) {
  const Rendering view = render(Camera::of_size(160, 120), layout.bodies, layout.X_CW);
  double sum = 0.0, worst = 0.0;
  int count = 0, index = 0;
  for (const Body& body : layout.bodies) {
    for (const Surface& surface : body.surfaces) {
      const int alone = view.alone[index], visible = view.visible[index];
      ++index;
      if (!surface.curved) continue;
      const double occlusion = alone > 0 ? 1.0 - static_cast<double>(visible) / alone : 1.0;
      sum += occlusion;
      worst = std::max(worst, occlusion);
      ++count;
    }
  }
  if (count < traits.min_quadrics) return 2.0;
  const double mean = sum / count;
  return std::max({0.0, worst - traits.max_occlusion, traits.min_mean_occlusion - mean,
                   mean - traits.max_mean_occlusion});
}

}  // namespace

Layout find_layout(const FamilyTraits& traits, Random* random) {
  Layout best;
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 60 && least > 0.0; ++attempt) {
    Layout layout = draw_layout(traits, random);
    const double wrong = misfit(traits, layout);
    if (wrong >= least) continue;
    least = wrong;
    best = std::move(layout);
  }
  return best;
}

}  // namespace quadrille::scene
