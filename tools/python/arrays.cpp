#include "python/arrays.hpp"

#include <algorithm>
#include <stdexcept>

#include "quadrille/detector/known_detection.hpp"

namespace quadrille::python {
namespace {

std::string text_of_shape(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t n = 0; n < array.ndim(); ++n) {
    text += (n > 0 ? ", " : "") + std::to_string(array.shape(n));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

/// @throws py::type_error if an object is no array of numbers
template <class Array>
Array array_of(const py::object& points) {
  Array array = Array::ensure(points);
  if (array) return array;
  throw py::type_error("incompatible points of type " +
                       std::string(py::str(py::type::of(points).attr("__name__"))) +
                       "; give an array of numbers of shape (N, 3) or (H, W, 3)");
}

PointCloud view_in_C(const PyView& view, std::size_t number) {
  const auto& [points, place] = view;
  const std::string name = "views[" + std::to_string(number) + "]",
                    points_name = "the points of " + name;
  if (place.ndim() == 1 && place.size() == 3) {
    return cloud_of(view_of(points, Eigen::Vector3d(place.data()), points_name));
  }
  if (place.ndim() != 2 || place.shape(0) != 4 || place.shape(1) != 4) {
    throw std::invalid_argument(name + " has a place of shape " + text_of_shape(place) +
                                "; give a viewpoint (3,), or the pose of its camera (4, 4)");
  }
  using Rows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  return moved(cloud_of(view_of(points, Eigen::Vector3d::Zero(), points_name)),
               pose_of(Eigen::Map<const Rows>(place.data()), "the pose of " + name));
}

}  // namespace

Points points_of(const py::object& points) { return array_of<Points>(points); }

CloudView view_of(const Points& points, const Eigen::Vector3d& viewpoint, const std::string& name) {
  const py::ssize_t dimensions = points.ndim();
  if (dimensions < 2 || dimensions > 3 || points.shape(dimensions - 1) != 3) {
    throw std::invalid_argument(name + " of shape " + text_of_shape(points) +
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

PointCloud cloud_in_camera(const py::object& points, const Eigen::Isometry3d& X_CK) {
  using Wide = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Wide wide = array_of<Wide>(points);
  PointCloud cloud = cloud_of(view_of(Points(wide), Eigen::Vector3d::Zero()));
  const Eigen::Isometry3d X_KC = X_CK.inverse();
  const Eigen::Map<const Eigen::Matrix3Xd> p_C(wide.data(), 3, wide.size() / 3);
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    if (!cloud.points[n].allFinite()) continue;
    cloud.points[n] = (X_KC * p_C.col(static_cast<Eigen::Index>(n))).cast<float>();
  }
  return cloud;
}

std::vector<PointCloud> clouds_of(const std::vector<PyView>& views) {
  std::vector<PointCloud> clouds;
  clouds.reserve(views.size());
  for (const PyView& view : views) clouds.push_back(view_in_C(view, clouds.size()));
  return clouds;
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
  return checked_pose(Eigen::Isometry3d(X), name);
}

Eigen::Isometry3d working_frame(const std::optional<Eigen::Matrix4d>& camera_pose) {
  return camera_pose ? pose_of(*camera_pose, "camera_pose") : Eigen::Isometry3d::Identity();
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
