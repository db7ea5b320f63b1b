#include "picture/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

constexpr double kNear = 1e-3;
/// Distance of an eye above or beside the subject, in reaches; this is nearly a parallel view. An
/// eye beside it is raised by the second factor, so that the tops of tables are visible.
constexpr double kFar = 6.0, kRise = 0.25;

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

/// Returns the pose of an eye at `eye_C` that looks at `target_C` with `up_C` up.
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

/// Returns the share of the points that lie in front of an eye, not too far to the side.
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
  // The most common frame is the camera's own, whose y axis points down.
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

/// Chooses the focal length and the size so that nearly all of the points, and `more`, fill the
/// view from its pose.
void fill_view(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& more,
               View* view) {
  std::vector<double> u, v;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d p_V = view->X_VC * p;
    if (p_V.z() <= kNear) continue;
    u.push_back(p_V.x() / p_V.z());
    v.push_back(p_V.y() / p_V.z());
  }
  if (u.empty()) return;
  const auto range = [](const std::vector<double>& values) {
    return Eigen::Vector2d(quantile(values, 0.002), quantile(values, 0.998));
  };
  Eigen::Vector2d u_range = range(u), v_range = range(v);
  for (const Eigen::Vector3d& p : more) {
    const Eigen::Vector3d p_V = view->X_VC * p;
    if (p_V.z() <= kNear) continue;
    const Eigen::Vector2d at = p_V.head<2>() / p_V.z();
    u_range = {std::min(u_range[0], at.x()), std::max(u_range[1], at.x())};
    v_range = {std::min(v_range[0], at.y()), std::max(v_range[1], at.y())};
  }
  const double du = std::max(u_range[1] - u_range[0], 1e-6);
  const double dv = std::max(v_range[1] - v_range[0], 1e-6);
  view->height = static_cast<int>(view->width * std::clamp(dv / du, 0.45, 0.9));
  view->focal = 0.97 * std::min(view->width / du, view->height / dv);
  view->cx = view->width / 2.0 - view->focal * (u_range[0] + u_range[1]) / 2;
  view->cy = view->height / 2.0 - view->focal * (v_range[0] + v_range[1]) / 2;
}

/// Returns the normal of the largest plane that faces upward, otherwise the guess.
Eigen::Vector3d find_up(const ViewSubject& subject, const Eigen::Vector3d& guess) {
  Eigen::Vector3d up = guess;
  double most = 0.0;
  for (const auto& [normal, count] : subject.planes_C) {
    const double weight = count * normal.dot(guess);
    if (normal.dot(guess) < 0.3 || weight <= most) continue;
    most = weight;
    up = normal.normalized();
  }
  return up;
}

/// Chooses the middle of a view and its reach: those of the box and its surroundings, if there is a
/// box.
void choose_subject(const std::vector<Eigen::Vector3d>& points, const Eigen::AlignedBox3d& box_C,
                    View* view) {
  if (!box_C.isEmpty()) {
    view->middle_C = box_C.center();
    view->reach = std::max(0.8 * box_C.diagonal().norm(), kNear);
    return;
  }
  view->middle_C = median_point(points);
  std::vector<double> distances;
  for (const Eigen::Vector3d& p : points) distances.push_back((p - view->middle_C).norm());
  view->reach = std::max(quantile(distances, 0.98), kNear);
}

/// Returns half the side of the square that a point has to cover [pixels].
int splat_radius(const std::vector<Eigen::Vector2i>& pixels, const View& view) {
  // Tries cells of growing size. Once the cells hold the cloud without gaps, their number falls in
  // proportion to their area.
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

View View::scaled(double scale) const {
  View view = *this;
  view.focal *= scale;
  view.cx *= scale;
  view.cy *= scale;
  view.width = std::max(1, static_cast<int>(std::ceil(scale * width)));
  view.height = std::max(1, static_cast<int>(std::ceil(scale * height)));
  return view;
}

View fit_view(const PointCloud& cloud, int width) {
  View view;
  view.width = width;
  view.height = width * 3 / 4;
  const std::vector<Eigen::Vector3d> points = finite_points(cloud);
  if (points.empty()) return view;
  view.X_VC = choose_pose(points, cloud.viewpoint);
  fill_view(points, {}, &view);
  return view;
}

View fit_view(const PointCloud& cloud, int width, ViewSide side, const ViewSubject& subject) {
  View view = fit_view(cloud, width);
  std::vector<Eigen::Vector3d> points = finite_points(cloud);
  if (side == ViewSide::kCamera || points.empty()) return view;
  const Eigen::Isometry3d X_CV = view.X_VC.inverse();
  const Eigen::Vector3d up = find_up(subject, -X_CV.linear().col(1));
  Eigen::Vector3d forward = X_CV.linear().col(2) - up * up.dot(X_CV.linear().col(2));
  // A camera that looks straight down has the far side at the top.
  if (forward.norm() < 1e-3) forward = -X_CV.linear().col(1);
  forward = (forward - up * up.dot(forward)).normalized();
  choose_subject(points, subject.box_C, &view);
  std::erase_if(points,
                [&](const Eigen::Vector3d& p) { return (p - view.middle_C).norm() > view.reach; });
  if (points.empty()) return view;
  const Eigen::Vector3d aside = forward.cross(up) + kRise * up;
  const Eigen::Vector3d towards = side == ViewSide::kTop ? up : aside.normalized();
  view.X_VC = look_at(view.middle_C + kFar * view.reach * towards, view.middle_C,
                      side == ViewSide::kTop ? forward : up);
  fill_view(points, subject.more_C, &view);
  return view;
}

CloudImage cloud_image(const PointCloud& cloud, const View& view) {
  std::vector<Eigen::Vector2i> pixels;
  std::vector<float> depths;
  std::vector<std::size_t> sources;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.points[i].allFinite()) continue;
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const auto at = view.project(p);
    if (!at || !view.holds(*at) || (p - view.middle_C).norm() > view.reach) continue;
    pixels.push_back(at->cast<int>());
    depths.push_back(static_cast<float>((view.X_VC * p).z()));
    sources.push_back(i);
  }
  const bool coloured = cloud.coloured();
  const std::size_t size = static_cast<std::size_t>(view.width) * view.height;
  CloudImage image{std::vector<float>(size, 0.0f), std::vector<Rgb>(coloured ? size : 0)};
  const int radius = splat_radius(pixels, view);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int left = std::max(0, pixels[i].x() - radius);
    const int right = std::min(view.width - 1, pixels[i].x() + radius);
    const int bottom = std::min(view.height - 1, pixels[i].y() + radius);
    for (int y = std::max(0, pixels[i].y() - radius); y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * view.width + x;
        if (image.depth[at] != 0.0f && image.depth[at] <= depths[i]) continue;
        image.depth[at] = depths[i];
        if (coloured) image.colours[at] = cloud.colours[sources[i]];
      }
    }
  }
  return image;
}

}  // namespace quadrille
