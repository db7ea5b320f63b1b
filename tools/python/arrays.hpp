#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::python {

namespace py = pybind11;

/// Points from numpy; arrays of another type or order, or not aligned in memory, are converted.
using Points = py::array_t<float, py::array::c_style | py::array::forcecast |
                                      py::detail::npy_api::NPY_ARRAY_ALIGNED_>;

/// Returns a view of points of shape (N, 3), or (H, W, 3) for an organised cloud [m]. The points
/// are not copied, so the array must outlive the view.
/// @param name  of the points in errors
/// @throws std::invalid_argument naming them if the array has another shape
CloudView view_of(const Points& points, const Eigen::Vector3d& viewpoint,
                  const std::string& name = "points");

/// Returns points as an array.
/// @throws py::type_error if they are no numbers
Points points_of(const py::object& points);

/// Returns a cloud with its own copy of the points, for the planner.
PointCloud cloud_of(const CloudView& view);

/// Returns a cloud of points in frame C, of any type, in the frame K of its camera. Doubles are
/// rounded only there.
/// @throws py::type_error, std::invalid_argument as points_of() and view_of() do
PointCloud cloud_in_camera(const py::object& points, const Eigen::Isometry3d& X_CK);

/// A cloud as Python has it: its points, and its viewpoint.
using PyCloud = std::tuple<Points, Eigen::Vector3d>;

/// A further view as Python gives it: points in C and the viewpoint, or points in the frame of the
/// view's camera and the pose of that in C.
using PyView = std::tuple<Points, py::array_t<double, py::array::c_style | py::array::forcecast>>;

/// Returns views in frame C, with their own copies of the points.
/// @throws std::invalid_argument naming the view, as view_of() and pose_of() do
std::vector<PointCloud> clouds_of(const std::vector<PyView>& views);

/// Returns the points of a cloud as an array of shape (N, 3), or (H, W, 3), and its viewpoint.
PyCloud cloud_to_python(const PointCloud& cloud);

/// Returns a pose as a matrix of shape (4, 4).
inline Eigen::Matrix4d matrix_of(const Eigen::Isometry3d& X) { return X.matrix(); }

/// Returns a pose from a matrix.
/// @throws std::invalid_argument as checked_pose() does
Eigen::Isometry3d pose_of(const Eigen::Matrix4d& X, const std::string& name);

/// Returns the pose of a camera in frame C; the identity if none is given, so that work is done in
/// C.
/// @throws std::invalid_argument as pose_of() does
Eigen::Isometry3d working_frame(const std::optional<Eigen::Matrix4d>& camera_pose);

/// Returns the least and the greatest corner, of shape (2, 3).
Eigen::Matrix<double, 2, 3> corners_of(const Eigen::AlignedBox3d& box);

/// Returns milliseconds by stage.
py::dict dict_of(const std::vector<StageTime>& timings);

}  // namespace quadrille::python
