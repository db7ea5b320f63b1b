#include "picture/quadric_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quadrille {
namespace {

/// Where a ray meets the surface first: depth along z (0 if it misses) and the mesh cell.
struct Hit {
  float z = 0.0f;
  int ring = 0, sector = 0;
};

/// A detection's surface within its extent, ready for rays from the eye.
class ClippedQuadric {
 public:
  ClippedQuadric(const Detection& detection, const View& view)
      : X_QV_((view.X_VC * detection.X_CQ).inverse()),
        Q_V_(detection.Q_C.transformed(view.X_VC)),
        box_Q_(detection.extent_Q),
        tolerance_(std::max(4.0 * detection.rms, 0.003)) {
    const double slack = is_flat(detection.type) ? tolerance_ : 0.02 * box_Q_.sizes().maxCoeff();
    box_Q_.min().array() -= slack;
    box_Q_.max().array() += slack;
    ring_height_ = std::max(box_Q_.sizes().z() / 6.0, 1e-6);
  }

  double tolerance() const { return tolerance_; }
  const Eigen::AlignedBox3d& box_Q() const { return box_Q_; }

  /// Depths at which a ray (z = 1) meets the piece, nearest first; 0 for none.
  std::array<double, 2> depths(const Eigen::Vector3d& ray) const {
    const Eigen::Matrix4d& Q = Q_V_.matrix();
    const double a = ray.dot(Q.topLeftCorner<3, 3>() * ray);
    const double b = Q.topRightCorner<3, 1>().dot(ray);
    const double c = Q(3, 3);
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0.0)) return {0.0, 0.0};
    const double s = -(b + std::copysign(std::sqrt(discriminant), b));
    std::array<double, 2> roots = {c / s, s / a};
    if (!(roots[0] <= roots[1])) std::swap(roots[0], roots[1]);
    std::array<double, 2> kept = {0.0, 0.0};
    int count = 0;
    for (const double t : roots) {
      if (std::isfinite(t) && t > 0.0 && box_Q_.contains(X_QV_ * (t * ray))) kept[count++] = t;
    }
    return kept;
  }

  Hit hit(const Eigen::Vector3d& ray) const {
    const double t = depths(ray)[0];
    if (t == 0.0) return {};
    const Eigen::Vector3d p_Q = X_QV_ * (t * ray);
    const double angle = std::atan2(p_Q.y(), p_Q.x()) / (2 * std::numbers::pi) + 0.5;
    return {static_cast<float>(t),
            static_cast<int>(std::floor((p_Q.z() - box_Q_.min().z()) / ring_height_)),
            static_cast<int>(std::floor(angle * kSectors))};
  }

 private:
  static constexpr int kSectors = 18;

  Eigen::Isometry3d X_QV_;
  Quadric Q_V_;
  Eigen::AlignedBox3d box_Q_;
  double tolerance_, ring_height_;
};

/// The part of the image that a detection may cover.
struct Window {
  int left = 0, top = 0, width = 0, height = 0;
};

Window window_of(const Detection& detection, const ClippedQuadric& surface, const View& view) {
  Eigen::AlignedBox2d box;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
    const auto at = view.project(detection.X_CQ * surface.box_Q().corner(corner));
    if (!at) return {0, 0, view.width, view.height};
    box.extend(*at);
  }
  const auto clip = [](double v, int last) {
    return static_cast<int>(std::clamp(v, 0.0, double(last)));
  };
  const int left = clip(box.min().x() - 3, view.width), top = clip(box.min().y() - 3, view.height);
  return {left, top, clip(box.max().x() + 4, view.width) - left,
          clip(box.max().y() + 4, view.height) - top};
}

void tint(const ClippedQuadric& surface, const Window& window, const std::vector<float>& depth,
          const View& view, const Color& color, float alpha, Image* image) {
  for (int y = window.top; y < window.top + window.height; ++y) {
    for (int x = window.left; x < window.left + window.width; ++x) {
      const float z = depth[static_cast<std::size_t>(y) * view.width + x];
      if (z == 0.0f) continue;
      const Eigen::Vector3d ray = view.ray(x, y);
      for (const double t : surface.depths(ray)) {
        if (t == 0.0 || std::abs(t - z) * ray.norm() > 2.0 * surface.tolerance()) continue;
        image->blend(x, y, color, alpha);
        break;
      }
    }
  }
}

/// The first hits of all pixels of a window, with easy access beyond its border.
class HitImage {
 public:
  HitImage(const ClippedQuadric& surface, const Window& window, const View& view)
      : window_(window), hits_(static_cast<std::size_t>(window.width) * window.height) {
    for (int y = 0; y < window.height; ++y) {
      for (int x = 0; x < window.width; ++x) {
        hits_[static_cast<std::size_t>(y) * window.width + x] =
            surface.hit(view.ray(window.left + x, window.top + y));
      }
    }
  }

  Hit at(int x, int y) const {
    if (x < 0 || y < 0 || x >= window_.width || y >= window_.height) return {};
    return hits_[static_cast<std::size_t>(y) * window_.width + x];
  }

  /// True where the surface ends or steps back, within a distance of some pixels.
  bool is_outline(int x, int y, int reach) const {
    const Hit here = at(x, y);
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const float z = at(x + reach * dx, y + reach * dy).z;
      if (z == 0.0f || std::abs(z - here.z) > 0.03f * here.z) return true;
    }
    return false;
  }

  bool is_mesh_line(int x, int y) const {
    const Hit here = at(x, y), right = at(x + 1, y), below = at(x, y + 1);
    return here.ring != right.ring || here.ring != below.ring || here.sector != right.sector ||
           here.sector != below.sector;
  }

 private:
  Window window_;
  std::vector<Hit> hits_;
};

std::optional<Eigen::Vector2i> draw_lines(const HitImage& hits, const Window& window,
                                          const Color& color, Image* image) {
  int top = window.height, left = window.width, right = -1;
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      if (hits.at(x, y).z == 0.0f) continue;
      top = std::min(top, y);
      left = std::min(left, x);
      right = std::max(right, x);
      if (hits.is_outline(x, y, 3)) {
        image->blend(window.left + x, window.top + y, color, 1.0f);
      } else if (hits.is_mesh_line(x, y)) {
        image->blend(window.left + x, window.top + y, color, 0.75f);
      }
    }
  }
  if (right < 0) return std::nullopt;
  return Eigen::Vector2i(window.left + (left + right) / 2, window.top + top);
}

}  // namespace

std::optional<Eigen::Vector2i> draw_quadric(const Detection& detection, const Color& color,
                                            const std::vector<float>& depth, const View& view,
                                            Image* image) {
  if (detection.extent_Q.isEmpty() || !detection.Q_C.matrix().allFinite()) return std::nullopt;
  const ClippedQuadric surface(detection, view);
  const Window window = window_of(detection, surface, view);
  const bool flat = is_flat(detection.type);
  tint(surface, window, depth, view, color, flat ? 0.2f : 0.45f, image);
  if (flat) return std::nullopt;
  return draw_lines(HitImage(surface, window, view), window, color, image);
}

}  // namespace quadrille
