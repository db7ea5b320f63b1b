#pragma once

#include <cmath>

#include "lab/scoring/frame.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline constexpr double kBallRadius = 0.1;

inline Quadric ball_at(double x, double radius) {
  return from_canonical({QuadricType::kSphere, translation(x, 0, 1), {{"radius", radius}}})
      .normalized();
}

/// The plane z = depth.
inline Quadric wall_at(double depth) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(2, 3) = Q(3, 2) = -0.5;
  Q(3, 3) = depth;
  return Quadric(Q).normalized();
}

/// A ball of 10 cm (surface 0) before a wall (1), and half a metre to its side another ball (2)
/// that is hardly seen, with half a millimetre of noise.
inline scoring::Frame make_known_frame() {
  scoring::Frame frame;
  frame.name = "known";
  frame.family = "easy";
  const std::vector<Patch> patches = {sphere(translation(0, 0, 1), kBallRadius),
                                      rectangle(translation(0, 0, 1.5), 4, 4),
                                      sphere(translation(0.5, 0, 1), kBallRadius)};
  const std::vector<Quadric> quadrics = {ball_at(0, kBallRadius), wall_at(1.5),
                                         ball_at(0.5, kBallRadius)};
  frame.cloud = render(patches, {640, 480, 1.0 / 600.0, 0.0005});
  for (int id = 0; id < 3; ++id) {
    scoring::TrueSurface surface;
    surface.id = surface.body = id;
    surface.curved = id != 1;
    surface.type = id == 1 ? "wall" : "sphere";
    surface.Q_C = quadrics[id];
    surface.X_CS = patches[id].X_CB;
    const Eigen::Vector3d half = id == 1 ? Eigen::Vector3d(2, 2, 0)
                                         : Eigen::Vector3d(Eigen::Vector3d::Constant(kBallRadius));
    surface.box_S = {-half, half};
    surface.size = surface.box_S.sizes().maxCoeff();
    surface.sigma = 0.001;
    surface.evaluate = id != 2;
    frame.surfaces.push_back(surface);
  }
  for (const Eigen::Vector3f& p : frame.cloud.points) {
    int nearest = 0;
    for (int id = 1; id < 3; ++id) {
      const auto distance = [&](int i) { return std::abs(quadrics[i].distance(p.cast<double>())); };
      if (distance(id) < distance(nearest)) nearest = id;
    }
    frame.labels.push_back(nearest);
    frame.normals.push_back(
        quadrics[nearest].gradient(p.cast<double>()).normalized().cast<float>());
  }
  frame.cloud.width = frame.cloud.height = 0;
  return frame;
}

}  // namespace quadrille::test
