#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::python {

namespace py = pybind11;

/// Points as they come from numpy; what is not of this type and order, or lies askew in memory, is
/// converted.
using Points = py::array_t<float, py::array::c_style | py::array::forcecast |
                                      py::detail::npy_api::NPY_ARRAY_ALIGNED_>;

/// A cloud of points of shape (N, 3), or (H, W, 3) if it is organised [m], which stay where they
/// are: the array must outlive it.
/// @throws std::invalid_argument if the shape is another
CloudView view_of(const Points& points, const Eigen::Vector3d& viewpoint);

/// The same with points of its own, for the planner.
PointCloud cloud_of(const CloudView& view);

/// A pose as a matrix of shape (4, 4).
inline Eigen::Matrix4d matrix_of(const Eigen::Isometry3d& X) { return X.matrix(); }

/// A pose from a matrix.
/// @throws std::invalid_argument naming it if it is no rotation and translation
Eigen::Isometry3d pose_of(const Eigen::Matrix4d& X, const std::string& name);

/// The least and the largest corner, of shape (2, 3).
Eigen::Matrix<double, 2, 3> corners_of(const Eigen::AlignedBox3d& box);

/// Milliseconds by stage.
py::dict dict_of(const std::vector<StageTime>& timings);

}  // namespace quadrille::python
