#include "picture/cloud_layer.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

/// Smoothing window: half its side, and the step between its samples [pixels].
constexpr int kHalfWindow = 4, kTapStep = 2;
/// Neighbours whose depth differs by more than this share belong to another surface.
constexpr float kSameDepth = 0.02f;

/// Returns the normal of the plane that fits a pixel's surroundings; on a plane, 1/z is linear in
/// the pixel coordinates.
Eigen::Vector3d normal_at(const std::vector<float>& depth, const View& view, int x, int y) {
  const float z = depth[static_cast<std::size_t>(y) * view.width + x];
  float n = 1e-3f, sx = 0, sy = 0, sxx = 1e-3f, sxy = 0, syy = 1e-3f, sw = 0, sxw = 0, syw = 0;
  for (int dy = -kHalfWindow; dy <= kHalfWindow; dy += kTapStep) {
    for (int dx = -kHalfWindow; dx <= kHalfWindow; dx += kTapStep) {
      const int u = x + dx, v = y + dy;
      if (u < 0 || v < 0 || u >= view.width || v >= view.height) continue;
      const float w = depth[static_cast<std::size_t>(v) * view.width + u];
      if (w == 0.0f || std::abs(w - z) > kSameDepth * z) continue;
      const float i = static_cast<float>(dx), j = static_cast<float>(dy), inverse = 1.0f / w;
      n += 1.0f;
      sx += i;
      sy += j;
      sxx += i * i;
      sxy += i * j;
      syy += j * j;
      sw += inverse;
      sxw += i * inverse;
      syw += j * inverse;
    }
  }
  Eigen::Matrix3d moments;
  moments << sxx, sxy, sx, sxy, syy, sy, sx, sy, n;
  const Eigen::Vector3d slope = moments.inverse() * Eigen::Vector3d(sxw, syw, sw);
  const Eigen::Vector2d tilt = view.focal * slope.head<2>();
  const Eigen::Vector3d ray = view.ray(x, y);
  Eigen::Vector3d normal(tilt.x(), tilt.y(), slope.z() - tilt.dot(ray.head<2>()));
  normal.normalize();
  return normal.dot(ray) > 0 ? Eigen::Vector3d(-normal) : normal;
}

void draw_colours(const CloudImage& cloud, const View& view, Image* image) {
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * view.width + x;
      if (cloud.depth[i] == 0.0f) continue;
      const Rgb& rgb = cloud.colours[i];
      image->blend(x, y, Color(rgb[0], rgb[1], rgb[2]) / 255.0f, 1.0f);
    }
  }
}

void draw_grey(const std::vector<float>& depth, const View& view, Image* image) {
  std::vector<float> known;
  for (const float z : depth) {
    if (z > 0.0f) known.push_back(z);
  }
  if (known.empty()) return;
  std::sort(known.begin(), known.end());
  const float near = known[known.size() / 50], far = known[known.size() - 1 - known.size() / 50];
  const Eigen::Vector3d light = Eigen::Vector3d(-0.45, -0.6, -0.66).normalized();
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const float z = depth[static_cast<std::size_t>(y) * view.width + x];
      if (z == 0.0f) continue;
      const double lit = std::max(0.0, normal_at(depth, view, x, y).dot(light));
      const float distance = std::clamp((z - near) / std::max(far - near, 1e-6f), 0.0f, 1.0f);
      const float grey = (0.22f + 0.62f * static_cast<float>(lit)) * (1.05f - 0.35f * distance);
      image->blend(x, y, Color(grey, grey, grey), 1.0f);
    }
  }
}

}  // namespace

void draw_cloud(const CloudImage& cloud, const View& view, Image* image) {
  if (cloud.colours.empty()) {
    draw_grey(cloud.depth, view, image);
  } else {
    draw_colours(cloud, view, image);
  }
}

}  // namespace quadrille
