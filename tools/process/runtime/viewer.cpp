#include "process/runtime/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lcmtypes/drake/lcmt_viewer_draw.hpp>
#include <lcmtypes/drake/lcmt_viewer_load_robot.hpp>
#include <limits>
#include <utility>

#include "mesh/surface_mesh.hpp"
#include "quadrille/bus/encode.hpp"

namespace quadrille {
namespace {

using Geometry = drake::lcmt_viewer_geometry_data;

/// Time after which a scene is sent again [us].
constexpr std::int64_t kRepeat = 5'000'000;
/// Smaller changes of size are noise and not shown: absolute [m], and relative.
constexpr float kSameLength = 0.002f, kSameShare = 0.05f;
/// Limit of the points of a cloud that are shown.
constexpr std::size_t kMaxPoints = 30'000;
constexpr int kMeshCells = 12;
constexpr double kPlaneThickness = 0.001;

std::array<float, 4> color_of(std::size_t index, float opacity) {
  constexpr std::array<std::array<float, 3>, 6> kColors = {{{1.0f, 0.55f, 0.1f},
                                                            {0.2f, 0.75f, 1.0f},
                                                            {1.0f, 0.35f, 0.75f},
                                                            {0.95f, 0.9f, 0.2f},
                                                            {0.55f, 0.5f, 1.0f},
                                                            {0.3f, 0.95f, 0.75f}}};
  const auto& c = kColors[index % kColors.size()];
  return {c[0], c[1], c[2], opacity};
}

ViewerShape mesh_shape(const Detection& detection) {
  const Mesh mesh = mesh_of(detection, kMeshCells);
  ViewerShape shape{Geometry::MESH, Eigen::Isometry3d::Identity(), {}, {}};
  shape.numbers = {static_cast<float>(mesh.vertices.size()),
                   static_cast<float>(mesh.triangles.size())};
  for (const Eigen::Vector3f& v : mesh.vertices) {
    shape.numbers.insert(shape.numbers.end(), {v.x(), v.y(), v.z()});
  }
  for (const auto& triangle : mesh.triangles) {
    shape.numbers.insert(shape.numbers.end(), triangle.begin(), triangle.end());
  }
  return shape;
}

/// Returns the shape of a detection in its own frame Q.
ViewerShape shape_of(const Detection& d, const std::array<float, 4>& color) {
  const auto middle = [&](const Eigen::Vector3d& p_Q) {
    return Eigen::Isometry3d(Eigen::Translation3d(p_Q));
  };
  const auto number = [&](std::size_t i) { return static_cast<float>(d.dimension(i)); };
  switch (d.type) {
    case QuadricType::kSphere:
      return {Geometry::SPHERE, middle({0, 0, 0}), color, {number(0)}};
    case QuadricType::kEllipsoid:
      return {Geometry::ELLIPSOID, middle({0, 0, 0}), color, {number(0), number(1), number(2)}};
    case QuadricType::kCylinder:
      return {Geometry::CYLINDER,
              middle({0, 0, d.extent_Q.center().z()}),
              color,
              {number(0), static_cast<float>(d.extent_Q.sizes().z())}};
    case QuadricType::kPlane: {
      Eigen::Vector3d size = d.extent_Q.sizes();
      size.z() = kPlaneThickness;
      return box_shape(size, middle(d.extent_Q.center()), color);
    }
    default: {
      ViewerShape shape = mesh_shape(d);
      shape.color = color;
      return shape;
    }
  }
}

bool is_same_size(float a, float b) {
  return std::abs(a - b) <= std::max(kSameLength, kSameShare * std::max(std::abs(a), std::abs(b)));
}

/// Returns the sizes by which shapes are compared. Meshes count as equal if their bounding boxes
/// are.
std::vector<float> sizes_of(const ViewerShape& shape) {
  if (shape.type != Geometry::MESH) return shape.numbers;
  Eigen::AlignedBox3f box;
  const auto vertices = static_cast<std::size_t>(shape.numbers[0]);
  for (std::size_t i = 0; i < vertices; ++i) {
    box.extend(Eigen::Vector3f(&shape.numbers[2 + 3 * i]));
  }
  std::vector<float> sizes;
  for (int i = 0; i < 3; ++i) {
    sizes.push_back(vertices == 0 ? 0.0f : box.min()[i]);
    sizes.push_back(vertices == 0 ? 0.0f : box.max()[i]);
  }
  return sizes;
}

bool looks_same(const ViewerShape& a, const ViewerShape& b) {
  const std::vector<float> sizes_a = sizes_of(a), sizes_b = sizes_of(b);
  return a.type == b.type && a.color == b.color &&
         std::equal(sizes_a.begin(), sizes_a.end(), sizes_b.begin(), sizes_b.end(), is_same_size) &&
         (a.X_LS.translation() - b.X_LS.translation()).norm() < kSameLength;
}

void put_pose(const Eigen::Isometry3d& X, float* position, float* quaternion) {
  const Eigen::Quaterniond q = rotation_of(X);
  for (int i = 0; i < 3; ++i) position[i] = static_cast<float>(X.translation()[i]);
  const double parts[4] = {q.w(), q.x(), q.y(), q.z()};
  for (int i = 0; i < 4; ++i) quaternion[i] = static_cast<float>(parts[i]);
}

Geometry to_message(const ViewerShape& shape) {
  Geometry m;
  m.type = shape.type;
  put_pose(shape.X_LS, m.position, m.quaternion);
  std::copy(shape.color.begin(), shape.color.end(), m.color);
  m.float_data = shape.numbers;
  m.num_float_data = static_cast<std::int32_t>(m.float_data.size());
  return m;
}

drake::lcmt_viewer_load_robot make_load(const std::vector<ViewerLink>& links) {
  drake::lcmt_viewer_load_robot m;
  for (const ViewerLink& link : links) {
    drake::lcmt_viewer_link_data data;
    data.name = link.name;
    data.robot_num = 0;
    for (const ViewerShape& shape : link.shapes) data.geom.push_back(to_message(shape));
    data.num_geom = static_cast<std::int32_t>(data.geom.size());
    m.link.push_back(std::move(data));
  }
  m.num_links = static_cast<std::int32_t>(m.link.size());
  return m;
}

drake::lcmt_viewer_draw make_draw(std::int64_t utime, const std::vector<ViewerLink>& links) {
  drake::lcmt_viewer_draw m;
  // The timestamps of Drake are in milliseconds.
  m.timestamp = utime / 1000;
  m.num_links = static_cast<std::int32_t>(links.size());
  m.robot_num.assign(links.size(), 0);
  for (const ViewerLink& link : links) {
    m.link_name.push_back(link.name);
    m.position.emplace_back(3);
    m.quaternion.emplace_back(4);
    put_pose(link.X_WL, m.position.back().data(), m.quaternion.back().data());
  }
  return m;
}

}  // namespace

ViewerShape box_shape(const Eigen::Vector3d& size, const Eigen::Isometry3d& X_LS,
                      const std::array<float, 4>& color) {
  ViewerShape shape{Geometry::BOX, X_LS, color, {}};
  // Drake does not accept boxes without thickness.
  for (int i = 0; i < 3; ++i) {
    shape.numbers.push_back(static_cast<float>(std::max(size[i], 1e-4)));
  }
  return shape;
}

std::vector<ViewerLink> links_of(const DetectionResult& found) {
  std::vector<ViewerLink> links;
  for (const Detection& d : found.detections) {
    if (!is_reported(d) || d.extent_Q.isEmpty() || !d.Q_C.matrix().allFinite()) continue;
    const bool tracked = d.track != 0;
    const int number = tracked ? d.track : d.id;
    links.push_back(
        {fmt::format("quadrille::{} {}{}", to_string(d.type), tracked ? "track " : "", number),
         d.X_CQ,
         {shape_of(d,
                   color_of(static_cast<std::size_t>(number), is_flat(d.type) ? 0.25f : 0.6f))}});
  }
  for (const Box& box : found.boxes) {
    if (!is_reported(box)) continue;
    links.push_back({fmt::format("quadrille::box {}", box.id),
                     box.X_CB,
                     {box_shape(box.size, Eigen::Isometry3d::Identity(),
                                color_of(static_cast<std::size_t>(box.id), 0.6f))}});
  }
  return links;
}

Viewer::Viewer(ViewerChannels channels, bus::Publish publish)
    : channels_(std::move(channels)), publish_(std::move(publish)) {}

/// Returns true if the viewers already show these links with these shapes.
bool Viewer::shows(const std::vector<ViewerLink>& links) const {
  return std::equal(links.begin(), links.end(), loaded_.begin(), loaded_.end(),
                    [](const ViewerLink& a, const ViewerLink& b) {
                      return a.name == b.name &&
                             std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(),
                                        b.shapes.end(), looks_same);
                    });
}

std::int64_t Viewer::show(std::int64_t utime, std::vector<ViewerLink> links) {
  const auto by_name = [](const ViewerLink& a, const ViewerLink& b) { return a.name < b.name; };
  std::sort(links.begin(), links.end(), by_name);
  std::int64_t bytes = 0;
  const bool changed = !loaded_at_ || !shows(links);
  if (changed) loaded_ = links;
  if (changed || utime < *loaded_at_ || utime - *loaded_at_ >= kRepeat) {
    loaded_at_ = utime;
    const auto load = bus::encode(make_load(loaded_));
    publish_(channels_.load, load);
    bytes += static_cast<std::int64_t>(load.size());
  }
  const auto draw = bus::encode(make_draw(utime, links));
  publish_(channels_.draw, draw);
  return bytes + static_cast<std::int64_t>(draw.size());
}

std::vector<std::byte> encode_viewer_cloud(const bus::CloudMessage& cloud,
                                           const Eigen::Isometry3d& X_RC) {
  const auto& points = cloud.cloud.points;
  const std::size_t step = points.size() / kMaxPoints + 1;
  bus::CloudMessage thin{cloud.utime, cloud.seq, {}};
  thin.cloud.frame = cloud.cloud.frame;
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!points[i].allFinite()) continue;
    thin.cloud.points.push_back((X_RC * points[i].cast<double>()).cast<float>());
  }
  return bus::encode_cloud(thin, bus::CloudFormat::kDrake);
}

}  // namespace quadrille
