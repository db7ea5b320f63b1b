#include "python/arrays.hpp"

#include <algorithm>
#include <stdexcept>

namespace quadrille::python {
namespace {

// Poses are used as given, so a matrix that differs from a rotation by more than this is a mistake.
constexpr double kMaxOff = 1e-6;

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t n = 0; n < array.ndim(); ++n) {
    text += (n > 0 ? ", " : "") + std::to_string(array.shape(n));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

}  // namespace

CloudView view_of(const Points& points, const Eigen::Vector3d& viewpoint) {
  const py::ssize_t dimensions = points.ndim();
  if (dimensions < 2 || dimensions > 3 || points.shape(dimensions - 1) != 3) {
    throw std::invalid_argument("points of shape " + shape_of(points) +
                                ": give (N, 3), or (H, W, 3) of an organised cloud");
  }
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) &&
                alignof(Eigen::Vector3f) == alignof(float));
  CloudView view;
  view.points = {reinterpret_cast<const Eigen::Vector3f*>(points.data()),
                 static_cast<std::size_t>(points.size()) / 3};
  view.viewpoint = viewpoint;
  if (dimensions == 3) {
    view.height = static_cast<int>(points.shape(0));
    view.width = static_cast<int>(points.shape(1));
  }
  return view;
}

PointCloud cloud_of(const CloudView& view) {
  PointCloud cloud;
  cloud.points.assign(view.points.begin(), view.points.end());
  cloud.width = view.width;
  cloud.height = view.height;
  cloud.viewpoint = view.viewpoint;
  cloud.read = cloud.points.size();
  return cloud;
}

std::vector<PointCloud> clouds_of(const std::vector<PyCloud>& clouds) {
  std::vector<PointCloud> copies;
  copies.reserve(clouds.size());
  for (const auto& [points, viewpoint] : clouds) {
    copies.push_back(cloud_of(view_of(points, viewpoint)));
  }
  return copies;
}

PyCloud cloud_to_python(const PointCloud& cloud) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(cloud.points.size()), 3};
  if (cloud.organised()) shape = {cloud.height, cloud.width, 3};
  Points points(shape);
  if (!cloud.points.empty()) {
    std::copy_n(cloud.points.front().data(), 3 * cloud.points.size(), points.mutable_data());
  }
  return {points, cloud.viewpoint};
}

Eigen::Isometry3d pose_of(const Eigen::Matrix4d& X, const std::string& name) {
  const Eigen::Matrix3d R = X.topLeftCorner<3, 3>();
  const bool is_rotation = (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kMaxOff &&
                           R.determinant() > 0.0 && X.allFinite() &&
                           (X.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kMaxOff;
  if (!is_rotation) throw std::invalid_argument(name + " is no rotation and translation");
  return Eigen::Isometry3d(X);
}

Eigen::Matrix<double, 2, 3> corners_of(const Eigen::AlignedBox3d& box) {
  Eigen::Matrix<double, 2, 3> corners;
  corners << box.min().transpose(), box.max().transpose();
  return corners;
}

py::dict dict_of(const std::vector<StageTime>& timings) {
  py::dict dict;
  for (const StageTime& stage : timings) dict[py::str(stage.stage)] = stage.ms;
  return dict;
}

}  // namespace quadrille::python
