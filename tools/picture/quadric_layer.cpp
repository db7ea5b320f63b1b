#include "picture/quadric_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "picture/contour.hpp"

namespace quadrille {
namespace {

/// A relative step in depth larger than this is an edge.
constexpr float kStep = 0.03f;

/// The first hit of a ray on the surface: depth along z (0 if it misses), and the cell of the mesh.
struct Hit {
  float z = 0.0f;
  int ring = 0, sector = 0;
};

/// A detection's surface within its extent, prepared for rays from the eye.
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

  /// Returns the depths at which a ray (z = 1) meets the surface, nearest first; 0 for none.
  std::array<double, 2> depths(const Eigen::Vector3d& ray) const {
    std::array<double, 2> roots = Q_V_.crossings(Eigen::Vector3d::Zero(), ray);
    std::sort(roots.begin(), roots.end());
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

Window window_of(const ClippedQuadric& surface, const Eigen::Isometry3d& X_CQ, const View& view) {
  Eigen::AlignedBox2d box;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
    const auto at = view.project(X_CQ * surface.box_Q().corner(corner));
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

bool can_be_drawn(const Detection& detection) {
  return !detection.extent_Q.isEmpty() && detection.Q_C.matrix().allFinite();
}

ContourGrid grid_over(const Window& window) {
  ContourGrid grid;
  // The grid extends beyond the window by one step, so that outlines close.
  grid.origin = Eigen::Vector2d(window.left, window.top).array() - grid.step;
  grid.columns = static_cast<int>(window.width / grid.step) + 3;
  grid.rows = static_cast<int>(window.height / grid.step) + 3;
  return grid;
}

/// Returns true if the surface ends or steps in depth between two hits.
bool is_outline(const Hit& a, const Hit& b) {
  if (a.z == 0.0f || b.z == 0.0f) return a.z != b.z;
  return std::abs(a.z - b.z) > kStep * std::min(a.z, b.z);
}

bool is_on_side(const Hit& hit, const Hit& a, const Hit& b) {
  if (a.z == 0.0f || b.z == 0.0f) return (hit.z == 0.0f) == (a.z == 0.0f);
  return std::abs(hit.z - a.z) < std::abs(hit.z - b.z);
}

/// Traces the lines at which one of a mesh cell's two numbers changes, within parts of the surface
/// without outlines.
std::vector<Segment> trace_mesh(const ContourGrid& grid, const std::vector<Hit>& hits,
                                const std::function<Hit(const Eigen::Vector2d&)>& hit,
                                int Hit::*cell) {
  return trace_contours<Hit>(
      grid, hits, hit,
      [&](const Hit& a, const Hit& b) { return a.*cell != b.*cell && !is_outline(a, b); },
      [&](const Hit& h, const Hit& a, const Hit&) { return h.*cell == a.*cell; });
}

}  // namespace

void tint_quadric(const Detection& detection, const Color& color, const std::vector<float>& depth,
                  const View& view, Image* image) {
  if (!can_be_drawn(detection)) return;
  const ClippedQuadric surface(detection, view);
  const Window window = window_of(surface, detection.X_CQ, view);
  const float alpha = is_flat(detection.type) ? 0.2f : 0.45f;
  for (int y = window.top; y < window.top + window.height; ++y) {
    for (int x = window.left; x < window.left + window.width; ++x) {
      const float z = depth[static_cast<std::size_t>(y) * view.width + x];
      if (z == 0.0f) continue;
      const Eigen::Vector3d ray = view.ray(x + 0.5, y + 0.5);
      for (const double t : surface.depths(ray)) {
        if (t == 0.0 || std::abs(t - z) * ray.norm() > 2.0 * surface.tolerance()) continue;
        image->blend(x, y, color, alpha);
        break;
      }
    }
  }
}

QuadricSketch sketch_quadric(const Detection& detection, const Color& color, const View& view) {
  if (!can_be_drawn(detection) || is_flat(detection.type)) return {};
  const ClippedQuadric surface(detection, view);
  const ContourGrid grid = grid_over(window_of(surface, detection.X_CQ, view));
  const std::function hit = [&](const Eigen::Vector2d& p) {
    return surface.hit(view.ray(p.x(), p.y()));
  };
  QuadricSketch drawn;
  drawn.step = grid.step;
  std::vector<Hit> hits;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d p = grid.at(column, row);
      hits.push_back(hit(p));
      if (hits.back().z != 0.0f && view.holds(p)) drawn.covered.push_back(p);
    }
  }
  if (drawn.covered.empty()) return {};
  for (int Hit::*cell : {&Hit::ring, &Hit::sector}) {
    drawn.sketch.strokes.push_back({trace_mesh(grid, hits, hit, cell), 1.0, color, 0.75f});
  }
  drawn.sketch.strokes.push_back(
      {trace_contours<Hit>(grid, hits, hit, is_outline, is_on_side), 3.0, color, 1.0f});
  return drawn;
}

}  // namespace quadrille
