#pragma once

#include <algorithm>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/choices.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

/// A table with quadrics, cans and boxes on it, before a camera of few pixels.
struct SmallScene {
  std::vector<Patch> patches;
  Camera camera;

  PointCloud render() const { return test::render(patches, camera); }
  /// The detections that a detector without error would make.
  std::vector<Detection> truth() const;
};

inline std::vector<Detection> SmallScene::truth() const {
  std::vector<Detection> found;
  for (const Patch& patch : patches) {
    const CanonicalForm form = canonical_form(Quadric(patch.D).transformed(patch.X_CB));
    Detection d;
    d.id = static_cast<int>(found.size()) + 1;
    d.type = form.type;
    d.X_CQ = form.X;
    d.Q_C = Quadric(patch.D).transformed(patch.X_CB).normalized();
    d.rms = 0.001;
    d.score = 1.0;
    // Sides of a patch that are open are those of the largest thing in the scene.
    const Eigen::Vector3d open = Eigen::Vector3d::Constant(0.1);
    const Eigen::AlignedBox3d box_B =
        patch.box_B.sizes().minCoeff() > 1.0 ? Eigen::AlignedBox3d(-open, open) : patch.box_B;
    for (int k = 0; k < 8; ++k) {
      Eigen::Vector3d corner = box_B.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
      corner = corner.cwiseMax(-0.4).cwiseMin(0.4);
      d.extent_Q.extend(d.X_CQ.inverse() * (patch.X_CB * corner));
    }
    for (const auto& [name, value] : form.dimensions) d.dimensions.push_back({name, value, 0.001});
    const Eigen::Vector3d size = d.extent_Q.sizes();
    if (d.type == QuadricType::kPlane) {
      d.dimensions = {{"width", size.x(), 0.01}, {"height", size.y(), 0.01}};
    } else if (d.type == QuadricType::kCylinder || d.type == QuadricType::kEllipticCylinder) {
      d.dimensions.push_back({"length", size.z(), 0.005});
    }
    found.push_back(std::move(d));
  }
  return found;
}

inline Camera small_camera(Choices& choices) {
  Camera camera;
  camera.width = choices.pick(std::array{80, 64, 96, 24, 120});
  camera.height = camera.width * 3 / 4;
  camera.pitch = choices.pick(std::array{0.7, 0.4, 1.2, 3.9}) / camera.width;
  camera.noise = choices.pick(std::array{0.001, 0.0, 1e-8, 0.003, 0.02});
  camera.seed = choices.below(4);
  return camera;
}

/// A quadric of any type, upright on its foot, of which the middle shows.
inline Patch any_quadric(Choices& choices, const Eigen::Isometry3d& X_CB, double r, double h) {
  const auto square = [&] { return choices.pick(std::array{1.0, 0.5, 0.0, -0.5, -1.0, 1e-4}); };
  Patch patch;
  const double b = square(), c = square(), d = choices.pick(std::array{-1.0, 0.0, 1.0});
  patch.D = diagonal(1.0, b, c, d * r * r);
  patch.D(2, 3) = patch.D(3, 2) = choices.pick(std::array{0.0, 0.5}) * r;
  patch.X_CB = X_CB;
  const Eigen::Vector3d half(r, r, 0.5 * h);
  patch.box_B = {-half, half};
  return patch;
}

inline void add_object(Choices& choices, const Eigen::Isometry3d& X_CF, std::vector<Patch>* all) {
  const double r = choices.between(0.02, 0.1), h = choices.between(0.03, 0.2);
  const auto add = [&](const std::vector<Patch>& patches) {
    all->insert(all->end(), patches.begin(), patches.end());
  };
  switch (choices.below(6)) {
    case 0:
      return all->push_back(sphere(X_CF * translation(0, 0, r), r));
    case 1:
      return add(can(X_CF * translation(0, 0, 0.5 * h), r, h));
    case 2:
      return add(box(X_CF * translation(0, 0, 0.5 * h), {2 * r, r, h}));
    case 3: {
      const Eigen::AngleAxisd lying(0.5 * M_PI, Eigen::Vector3d::UnitX());
      return all->push_back(mantle(X_CF * translation(0, 0, r) * lying, r, h));
    }
    default:
      return all->push_back(any_quadric(choices, X_CF * translation(0, 0, 0.5 * h), r, h));
  }
}

inline std::vector<Patch> small_patches(Choices& choices) {
  const Eigen::Isometry3d X_CW = world_seen_from(
      {choices.between(0.0, 0.5), -choices.between(0.5, 0.9), choices.between(0.4, 0.9)});
  std::vector<Patch> all;
  if (!choices.one_in(6)) all.push_back(rectangle(X_CW, 0.8, 0.6));
  const std::size_t objects = choices.below(4);
  for (std::size_t k = 0; k <= objects; ++k) {
    const double x = choices.between(0.2, -0.2), y = choices.between(0.1, -0.1);
    add_object(choices, X_CW * translation(x, y, 0.0), &all);
  }
  return all;
}

inline SmallScene small_scene(Choices& choices) {
  SmallScene scene;
  scene.camera = small_camera(choices);
  scene.patches = small_patches(choices);
  return scene;
}

}  // namespace quadrille::test
