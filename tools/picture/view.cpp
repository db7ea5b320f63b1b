#include "picture/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

constexpr double kNear = 1e-3;

std::vector<Eigen::Vector3d> finite_points(const PointCloud& cloud) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) {
    if (p.allFinite()) points.push_back(p.cast<double>());
  }
  return points;
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

Eigen::Vector3d median_point(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& p : points) values.push_back(p[axis]);
    median[axis] = quantile(values, 0.5);
  }
  return median;
}

/// An eye at `eye_C` that looks at `target_C` with `up_C` up.
Eigen::Isometry3d look_at(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& target_C,
                          const Eigen::Vector3d& up_C) {
  const Eigen::Vector3d forward = (target_C - eye_C).normalized();
  Eigen::Vector3d right = forward.cross(up_C);
  if (right.norm() < 1e-3) right = forward.unitOrthogonal();
  right.normalize();
  Eigen::Isometry3d X_CV = Eigen::Isometry3d::Identity();
  X_CV.linear() << right, forward.cross(right), forward;
  X_CV.translation() = eye_C;
  return X_CV.inverse();
}

/// Share of the points that lie before an eye, not too far aside.
double share_before(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& X_VC) {
  std::size_t count = 0;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d p_V = X_VC * p;
    if (p_V.z() > kNear && p_V.head<2>().norm() < 1.8 * p_V.z()) ++count;
  }
  return static_cast<double>(count) / static_cast<double>(points.size());
}

Eigen::Isometry3d choose_pose(const std::vector<Eigen::Vector3d>& points,
                              const Eigen::Vector3d& viewpoint) {
  // A camera's own frame is the commonest; its y axis points down.
  Eigen::Isometry3d X_VC = Eigen::Isometry3d::Identity();
  X_VC.translation() = -viewpoint;
  if (share_before(points, X_VC) > 0.98) return X_VC;
  const Eigen::Vector3d target = median_point(points), up = Eigen::Vector3d::UnitZ();
  if ((target - viewpoint).norm() > kNear) {
    X_VC = look_at(viewpoint, target, up);
    if (share_before(points, X_VC) > 0.98) return X_VC;
  }
  std::vector<double> distances;
  for (const Eigen::Vector3d& p : points) distances.push_back((p - target).norm());
  const double reach = std::max(quantile(distances, 0.98), kNear);
  return look_at(target + 2.5 * reach * Eigen::Vector3d(-0.6, -0.6, 0.5).normalized(), target, up);
}

/// Half the side of the square that a point has to cover [pixels].
int splat_radius(const std::vector<Eigen::Vector2i>& pixels, const View& view) {
  // Cells of growing size: once they hold the cloud without gaps, their number falls with the area.
  double last = 0.0;
  for (int cell = 1; cell <= 12; ++cell) {
    const int columns = view.width / cell + 1, rows = view.height / cell + 1;
    std::vector<char> hit(static_cast<std::size_t>(columns) * rows, 0);
    std::size_t count = 0;
    for (const Eigen::Vector2i& p : pixels) {
      char& mark = hit[static_cast<std::size_t>(p.y() / cell) * columns + p.x() / cell];
      count += mark == 0;
      mark = 1;
    }
    const double area = static_cast<double>(count) * cell * cell;
    if (cell > 1 && area < 1.06 * last) return cell / 2;
    last = area;
  }
  return 6;
}

}  // namespace

std::optional<Eigen::Vector2d> View::project(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d p = X_VC * p_C;
  if (!(p.z() > kNear)) return std::nullopt;
  return Eigen::Vector2d(focal * p.x() / p.z() + cx, focal * p.y() / p.z() + cy);
}

View fit_view(const PointCloud& cloud, int width) {
  View view;
  view.width = width;
  view.height = width * 3 / 4;
  const std::vector<Eigen::Vector3d> points = finite_points(cloud);
  if (points.empty()) return view;
  view.X_VC = choose_pose(points, cloud.viewpoint);
  std::vector<double> u, v;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d p_V = view.X_VC * p;
    if (p_V.z() <= kNear) continue;
    u.push_back(p_V.x() / p_V.z());
    v.push_back(p_V.y() / p_V.z());
  }
  if (u.empty()) return view;
  const auto range = [](const std::vector<double>& values) {
    return Eigen::Vector2d(quantile(values, 0.002), quantile(values, 0.998));
  };
  const Eigen::Vector2d u_range = range(u), v_range = range(v);
  const double du = std::max(u_range[1] - u_range[0], 1e-6);
  const double dv = std::max(v_range[1] - v_range[0], 1e-6);
  view.height = static_cast<int>(width * std::clamp(dv / du, 0.45, 0.9));
  view.focal = 0.97 * std::min(width / du, view.height / dv);
  view.cx = width / 2.0 - view.focal * (u_range[0] + u_range[1]) / 2;
  view.cy = view.height / 2.0 - view.focal * (v_range[0] + v_range[1]) / 2;
  return view;
}

std::vector<float> depth_image(const PointCloud& cloud, const View& view) {
  std::vector<Eigen::Vector2i> pixels;
  std::vector<float> depths;
  for (const Eigen::Vector3d& p : finite_points(cloud)) {
    const auto at = view.project(p);
    if (!at || at->minCoeff() < 0 || at->x() >= view.width || at->y() >= view.height) continue;
    pixels.push_back(at->cast<int>());
    depths.push_back(static_cast<float>((view.X_VC * p).z()));
  }
  std::vector<float> image(static_cast<std::size_t>(view.width) * view.height, 0.0f);
  const int radius = splat_radius(pixels, view);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int left = std::max(0, pixels[i].x() - radius);
    const int right = std::min(view.width - 1, pixels[i].x() + radius);
    const int bottom = std::min(view.height - 1, pixels[i].y() + radius);
    for (int y = std::max(0, pixels[i].y() - radius); y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        float& z = image[static_cast<std::size_t>(y) * view.width + x];
        if (z == 0.0f || depths[i] < z) z = depths[i];
      }
    }
  }
  return image;
}

}  // namespace quadrille
