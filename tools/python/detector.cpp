#include "quadrille/detector/detector.hpp"

#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud_file.hpp"
#include "io/settings/config.hpp"
#include "python/arrays.hpp"
#include "python/found.hpp"
#include "python/module.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/lasting_detector.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/tracker.hpp"
#include "quadrille/detector/view_memory.hpp"

namespace quadrille::python {
namespace {

Found detect_in(const py::object& points, const Eigen::Vector3d& viewpoint,
                const std::vector<PyView>& views, const RobotShapes& robot,
                const std::optional<Eigen::Matrix4d>& camera_pose, const std::string& settings,
                const std::string& source) {
  const DetectorOptions options = io::search_options(io::parse_detector_config(settings, source));
  Found found;
  found.X_CK = working_frame(camera_pose);
  const Eigen::Isometry3d X_KC = found.X_CK.inverse();
  std::vector<PointCloud> all = clouds_of(views);
  if (all.empty() && robot.shapes.empty() && !camera_pose) {
    // A single cloud without a robot in it is not copied.
    const Points array = points_of(points);
    const CloudView cloud = view_of(array, viewpoint);
    const py::gil_scoped_release others_run;
    found.in_K = detect(cloud, options);
    return found;
  }
  PointCloud first = camera_pose ? cloud_in_camera(points, found.X_CK)
                                 : cloud_of(view_of(points_of(points), viewpoint));
  const py::gil_scoped_release others_run;
  const RobotShapes robot_K = moved(robot, X_KC);
  for (PointCloud& view : all) view = moved(std::move(view), X_KC);
  all.insert(all.begin(), std::move(first));
  for (PointCloud& view : all) view = robot_K.taken_from(std::move(view));
  const std::vector<Eigen::Isometry3d> motions = align_views(&all, options);
  for (std::size_t n = 1; n < motions.size(); ++n) {
    found.corrections_C.push_back(found.X_CK * motions[n] * X_KC);
  }
  found.in_K = detect_views(all, options);
  return found;
}

/// Binds what both memories of views have: how to forget, and their length.
template <class Memory>
void bind_forgetting(py::class_<Memory>& memory) {
  memory.def("forget", py::overload_cast<>(&Memory::forget))
      .def(
          "forget_box",
          [](Memory& self, const Eigen::Matrix4d& X_WR, const Eigen::Vector3d& size) {
            self.forget(pose_of(X_WR, "X_WR"), {-0.5 * size, 0.5 * size});
          },
          py::arg("X_WR"), py::arg("size"))
      .def("__len__", &Memory::size);
}

template <class Memory>
std::unique_ptr<Memory> memory_of(const std::string& settings, const std::string& source) {
  return std::make_unique<Memory>(io::search_options(io::parse_detector_config(settings, source)));
}

void bind_memory(py::module_& module) {
  py::class_<ViewMemory> memory(module, "ViewMemory", "See quadrille.ViewMemory.");
  memory.def(py::init(&memory_of<ViewMemory>), py::arg("settings"), py::arg("source"))
      .def(
          "add",
          [](ViewMemory& self, std::int64_t utime, const Points& points,
             const Eigen::Vector3d& viewpoint, const Eigen::Matrix4d& X_WC, int camera) {
            const PointCloud cloud = cloud_of(view_of(points, viewpoint));
            return matrix_of(self.add(utime, cloud, pose_of(X_WC, "X_WC"), camera));
          },
          py::arg("utime"), py::arg("points"), py::arg("viewpoint"), py::arg("X_WC"),
          py::arg("camera"))
      .def(
          "others",
          [](const ViewMemory& self, std::int64_t utime, const Eigen::Matrix4d& X_WC, int camera) {
            std::vector<PyCloud> views;
            for (const PointCloud& view : self.others(utime, pose_of(X_WC, "X_WC"), camera)) {
              views.push_back(cloud_to_python(view));
            }
            return views;
          },
          py::arg("utime"), py::arg("X_WC"), py::arg("camera"));
  bind_forgetting(memory);
}

Found detect_lasting(LastingDetector& detector, std::int64_t utime, const Points& points,
                     const Eigen::Vector3d& viewpoint, const Eigen::Matrix4d& X_WC,
                     const RobotShapes& robot, int camera) {
  const PointCloud cloud = robot.taken_from(cloud_of(view_of(points, viewpoint)));
  // Other Python threads wait, since they might use the same detector.
  return {detector.detect(utime, cloud, pose_of(X_WC, "X_WC"), camera)};
}

void bind_lasting(py::module_& module) {
  py::class_<LastingDetector> detector(module, "LastingDetector", "See quadrille.LastingDetector.");
  detector.def(py::init(&memory_of<LastingDetector>), py::arg("settings"), py::arg("source"))
      .def("detect", &detect_lasting, py::arg("utime"), py::arg("points"), py::arg("viewpoint"),
           py::arg("X_WC"), py::arg("robot"), py::arg("camera"));
  bind_forgetting(detector);
}

void bind_tracker(py::module_& module) {
  const Eigen::Matrix4d at_rest = Eigen::Matrix4d::Identity();
  py::class_<Tracker>(module, "Tracker", "See quadrille.Tracker.")
      .def(py::init([](const std::string& settings, const std::string& source) {
             return std::make_unique<Tracker>(io::parse_detector_config(settings, source).track);
           }),
           py::arg("settings"), py::arg("source"))
      .def(
          "update",
          [](Tracker& tracker, Found& result, std::int64_t utime, const Eigen::Matrix4d& X_WC) {
            tracker.update(utime, pose_of(X_WC, "X_WC") * result.X_CK, &result.in_K);
          },
          py::arg("result"), py::arg("utime"), py::arg("X_WC") = at_rest);
}

/// Returns the length of a unit [m].
double length_of(const std::string& unit) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 1e-3;
  throw std::invalid_argument("unit is '" + printable(unit) + "'; give 'm' or 'mm'");
}

PyCloud read_cloud_file(const std::filesystem::path& path, const std::string& unit) {
  return cloud_to_python(
      io::read_cloud(path.string(), Eigen::Affine3d(Eigen::Scaling(length_of(unit)))));
}

/// The pose of a message: a position, and a quaternion w, x, y, z.
Eigen::Matrix4d pose_from(const Eigen::Vector3d& position, const Eigen::Vector4d& quaternion) {
  const Eigen::Quaterniond R(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  if (!(std::abs(R.norm() - 1.0) < 1e-2)) {
    throw std::invalid_argument("quaternion must have length 1; give w, x, y, z");
  }
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = R.normalized().toRotationMatrix();
  X.translation() = position;
  return X.matrix();
}

Eigen::Vector4d quaternion_of(const Eigen::Matrix4d& X) {
  const Eigen::Quaterniond R = rotation_of(pose_of(X, "X"));
  return {R.w(), R.x(), R.y(), R.z()};
}

}  // namespace

void bind_detector(py::module_& module) {
  bind_tracker(module);
  bind_memory(module);
  bind_lasting(module);
  module.def("detect", &detect_in, py::arg("points"), py::arg("viewpoint"), py::arg("views"),
             py::arg("robot"), py::arg("camera_pose"), py::arg("settings"), py::arg("source"),
             "See quadrille.detect().");
  module.def(
      "pose", &pose_from, py::arg("position"), py::arg("quaternion"),
      "The pose, (4, 4), of a position and a quaternion w, x, y, z, as messages and JSON have "
      "them.");
  module.def("quaternion", &quaternion_of, py::arg("X"),
             "The quaternion w, x, y, z of a pose, (4,), as messages and JSON have it.");
  module.def("read_cloud", &read_cloud_file, py::arg("path"), py::arg("unit") = "m",
             "The points of a file, (N, 3) or (H, W, 3) [m], and its viewpoint, (3,) [m].\n\n"
             "unit   of the file's coordinates: 'm' or 'mm'\n\n"
             "Raises FileError, a ValueError, in one line if it cannot be read.");
}

}  // namespace quadrille::python
