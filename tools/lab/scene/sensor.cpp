#include "lab/scene/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::scene {
namespace {

/// Depth step between neighbours that counts as an edge [m].
constexpr double kEdgeStep = 0.02;
constexpr double kMixedShare = 0.08, kEdgeLoss = 0.25, kLoss = 0.02, kStrays = 0.002;
/// Cosine of incidence below which returns are lost.
constexpr double kGrazing = 0.18;

/// Smooth noise with unit variance: normal numbers on a lattice, interpolated bilinearly.
class SmoothNoise {
 public:
  SmoothNoise(int width, int height, int cell, Random* random)
      : cell_(cell),
        columns_(width / cell + 2),
        lattice_(static_cast<std::size_t>(columns_) * (height / cell + 2)) {
    for (double& value : lattice_) value = random->normal();
  }

  double at(int column, int row) const {
    const int i = column / cell_, j = row / cell_;
    const double u = (column % cell_ + 0.5) / cell_, v = (row % cell_ + 0.5) / cell_;
    const double w[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    const double* corner = &lattice_[static_cast<std::size_t>(j) * columns_ + i];
    const double sum =
        w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[columns_] + w[3] * corner[columns_ + 1];
    return sum / std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3]);
  }

 private:
  int cell_, columns_;
  std::vector<double> lattice_;
};

/// One pixel on its way from the ideal to the measured image.
struct Pixel {
  double z = 0.0;
  int label = -1;
  bool lost = false;
};

/// Returns the depth of a neighbour across an edge; 0 if there is no edge here.
double depth_across_edge(const Camera& camera, const Rendering& ideal, int column, int row) {
  const std::size_t i = static_cast<std::size_t>(row) * camera.width + column;
  for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const int x = column + dx, y = row + dy;
    if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) continue;
    const double z = ideal.depth[static_cast<std::size_t>(y) * camera.width + x];
    if (z > 0.0 && std::abs(z - ideal.depth[i]) > kEdgeStep) return z;
  }
  return 0.0;
}

double quantised(double z, bool disparity) {
  if (!disparity) return std::round(z * 1000.0) / 1000.0;
  // Disparity step of 1/16 pixel with a focal length of 525 pixels and a baseline of 75 mm.
  constexpr double kScale = 525.0 * 0.075 * 16.0;
  return kScale / std::max(1.0, std::round(kScale / std::max(z, 0.1)));
}

/// Applies noise and damage to one pixel. Always draws the same number of random numbers, so that
/// one pixel's fate does not affect the others.
Pixel damaged(double z, double noise, double across, double cosine, int label,
              const FamilyTraits& traits, Random* random) {
  const double mix = random->uniform(), weight = random->uniform(), edge_loss = random->uniform();
  const double loss = random->uniform(), graze = random->uniform(), stray = random->uniform();
  const double anywhere = random->uniform(0.4, 2.5);
  Pixel pixel{z + noise, label, false};
  const bool mixed = across > 0.0 && mix < kMixedShare;
  if (mixed) pixel = {z + weight * (across - z), kMixed, false};
  pixel.lost = loss < kLoss || (across > 0.0 && !mixed && edge_loss < kEdgeLoss) ||
               graze < (kGrazing - cosine) / kGrazing;
  if (!pixel.lost && stray < kStrays) pixel = {anywhere, kStray, false};
  pixel.z = quantised(pixel.z, traits.disparity);
  return pixel;
}

}  // namespace

double depth_noise(double factor, double z) {
  return factor * (0.0012 + 0.0019 * (z - 0.4) * (z - 0.4));
}

View observe(const Camera& camera, const Rendering& ideal, const FamilyTraits& traits,
             Random* random) {
  const SmoothNoise waves[2] = {{camera.width, camera.height, 3, random},
                                {camera.width, camera.height, 10, random}};
  const double white = std::sqrt(1.0 - kSmoothShare), smooth = std::sqrt(kSmoothShare / 2.0);
  const Eigen::Vector3f none = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  View view;
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * camera.width + column;
      const double unit =
          white * random->normal() + smooth * (waves[0].at(column, row) + waves[1].at(column, row));
      const double z = ideal.depth[i];
      const Eigen::Vector3d ray = camera.ray(column, row);
      const double cosine = std::abs(ideal.normal[i].cast<double>().dot(ray)) / ray.norm();
      const Pixel pixel = damaged(z, unit * depth_noise(traits.noise, z),
                                  depth_across_edge(camera, ideal, column, row), cosine,
                                  ideal.surface[i], traits, random);
      if (pixel.lost || ideal.surface[i] < 0) continue;
      view.points.push_back((pixel.z * ray).cast<float>());
      view.labels.push_back(pixel.label);
      view.normals.push_back(pixel.label < 0 ? none : ideal.normal[i]);
      view.pixels.push_back(i);
    }
  }
  return view;
}

PointCloud organised_cloud(const Camera& camera, const View& view) {
  PointCloud cloud;
  cloud.frame = kCameraFrame;
  cloud.width = camera.width;
  cloud.height = camera.height;
  cloud.read = static_cast<std::size_t>(camera.width) * camera.height;
  cloud.points.assign(cloud.read,
                      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    cloud.points[view.pixels[i]] = view.points[i];
  }
  return cloud;
}

}  // namespace quadrille::scene
