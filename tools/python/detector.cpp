#include "quadrille/detector/detector.hpp"

#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "io/cloud_file.hpp"
#include "io/settings/config.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/detector/tracker.hpp"
#include "quadrille/detector/view_memory.hpp"

namespace quadrille::python {
namespace {

std::string shown(const Detection& d) {
  std::string text = "<Detection " + std::to_string(d.id) + ": " + std::string(to_string(d.type));
  for (const Dimension& dimension : d.dimensions) {
    text += " " + dimension.name + "=" + std::to_string(dimension.value);
  }
  return text + ">";
}

std::map<std::string, double> values_of(const Detection& d) {
  std::map<std::string, double> values;
  for (const Dimension& dimension : d.dimensions) values[dimension.name] = dimension.value;
  return values;
}

std::map<std::string, double> deviations_of(const Detection& d) {
  std::map<std::string, double> deviations;
  for (const Dimension& dimension : d.dimensions) deviations[dimension.name] = dimension.std;
  return deviations;
}

void bind_numbers(py::class_<Detection>& detection) {
  detection
      .def_property_readonly(
          "Q", [](const Detection& d) -> Eigen::Matrix4d { return d.Q_C.matrix(); },
          "Symmetric (4, 4) of unit norm: f(p) = (p 1) Q (p 1)^T with p in frame C [m]; its "
          "gradient points to the side that the sensor saw.")
      .def_property_readonly(
          "q", [](const Detection& d) { return d.Q_C.coefficients(); },
          "A … J of unit norm, (10,): f = Ax²+By²+Cz²+2Dxy+2Exz+2Fyz+2Gx+2Hy+2Iz+J.")
      .def_property_readonly(
          "covariance", [](const Detection& d) { return d.covariance.known; },
          "Covariance of q along the directions that the view shows, (10, 10).")
      .def_property_readonly(
          "open_directions", [](const Detection& d) { return d.covariance.open; },
          "Directions of q that the view leaves open, orthonormal columns, (10, K).")
      .def_property_readonly(
          "X_CQ", [](const Detection& d) { return matrix_of(d.X_CQ); },
          "Pose of the quadric's frame Q, (4, 4) [m]: origin at its centre (or apex, vertex, "
          "middle "
          "of the seen part of an axis), z along its axis of symmetry or a plane's normal.")
      .def_property_readonly("dimensions", &values_of,
                             "Name and value [m, angles rad], such as {'radius': 0.03}.")
      .def_property_readonly(
          "deviations", &deviations_of,
          "Standard deviation of each dimension; inf where the view does not show it.")
      .def_property_readonly(
          "extent", [](const Detection& d) { return corners_of(d.extent_Q); },
          "Least and largest corner of the inliers in frame Q, (2, 3) [m].");
}

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

Eigen::VectorXd distances_to(const Detection& d, const Rows& points) {
  Eigen::VectorXd distances(points.rows());
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    distances[n] = d.Q_C.distance(points.row(n).transpose());
  }
  return distances;
}

void bind_detection(py::module_& module) {
  py::class_<Detection> detection(module, "Detection", "One quadric found in a cloud of frame C.");
  detection.def_readonly("id", &Detection::id, "1, 2, … within one Result, best score first.")
      .def_property_readonly(
          "type", [](const Detection& d) { return std::string(to_string(d.type)); },
          "Name of the type, such as 'elliptic_cylinder'.")
      .def_readonly("score", &Detection::score, "Confidence, 0 to 1.")
      .def_readonly("inliers", &Detection::inliers, "Points that lie on it.")
      .def_readonly("rms", &Detection::rms, "Root mean square of their distances [m].")
      .def_readonly("seen", &Detection::seen, "Observed share of its extent, 0 to 1.")
      .def_property_readonly("inside", &shows_inside,
                             "Whether a round surface was seen from inside, as a mug's inner wall.")
      .def_readonly("track", &Detection::track,
                    "The same for one surface in all clouds that a "
                    "Tracker saw, from 1 on; 0 if none did.")
      .def("distance", &distances_to, py::arg("points"),
           "First-order distances of points (N, 3) in frame C, (N,) [m]; positive on the side that "
           "the sensor saw.")
      .def("__repr__", &shown);
  bind_numbers(detection);
}

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Box", "A box, of which one to three faces were seen.")
      .def_readonly("id", &Box::id, "Continues the ids of the detections.")
      .def_readonly("faces", &Box::faces, "Ids of the detections that are its faces.")
      .def_readonly("score", &Box::score, "Confidence, 0 to 1.")
      .def_property_readonly(
          "X_CB", [](const Box& box) { return matrix_of(box.X_CB); },
          "Pose of the box's frame B, (4, 4) [m]: origin at its middle, x along the longest side, "
          "z along the shortest.")
      .def_property_readonly(
          "size", [](const Box& box) { return box.size; }, "Sides along x, y, z of B, (3,) [m].")
      .def_property_readonly(
          "deviations", [](const Box& box) { return box.std; },
          "Standard deviations of the sides, (3,) [m].")
      .def_readonly("seen", &Box::seen, "Whether both ends of each side were seen.")
      .def_property_readonly(
          "inner", [](const Box& box) { return corners_of(box.inner_B); },
          "What was seen of it: least and largest corner in frame B, (2, 3) [m].")
      .def_property_readonly(
          "outer", [](const Box& box) { return corners_of(box.outer_B); },
          "What it may reach at most: least and largest corner in frame B, (2, 3) [m].")
      .def("__repr__", [](const Box& box) { return "<Box " + std::to_string(box.id) + ">"; });
}

void bind_body(py::module_& module) {
  py::class_<SceneBody>(module, "Body",
                        "A thing of the scene, made of detections or a lump of points.")
      .def_readonly("id", &SceneBody::id, "That of its box or main part; lumps continue them.")
      .def_property_readonly(
          "kind", [](const SceneBody& body) { return std::string(to_string(body.kind)); },
          "\"single\", \"revolution\", \"box\" or \"lump\".")
      .def_readonly("parts", &SceneBody::parts, "Ids of the detections that are its parts.")
      .def_property_readonly(
          "X_CB", [](const SceneBody& body) { return matrix_of(body.X_CB); },
          "Pose of the body's frame B, (4, 4) [m]: origin at its middle, z along its axis.")
      .def_property_readonly(
          "size", [](const SceneBody& body) { return body.size; },
          "Sizes along x, y, z of B, (3,) [m].")
      .def_property_readonly(
          "deviations", [](const SceneBody& body) { return body.std; },
          "Standard deviations of the sizes, (3,) [m]; infinite if the view leaves one open.")
      .def_readonly("seen", &SceneBody::seen, "Whether each size was seen.")
      .def_readonly("standing_on", &SceneBody::standing_on, "Id of the plane, or None.")
      .def_readonly("points", &SceneBody::points, "Number of cloud points on it.")
      .def_readonly("views", &SceneBody::views, "Number of views that show it.")
      .def_readonly("unseen", &SceneBody::unseen, "Time since the newest of them [s].")
      .def("__repr__", [](const SceneBody& body) {
        return "<Body " + std::to_string(body.id) + " " + std::string(to_string(body.kind)) + ">";
      });
}

/// Returns the findings that were asked for.
template <class Found>
std::vector<Found> reported(const std::vector<Found>& all) {
  std::vector<Found> asked;
  std::copy_if(all.begin(), all.end(), std::back_inserter(asked),
               [](const Found& found) { return is_reported(found); });
  return asked;
}

void bind_result(py::module_& module) {
  py::class_<DetectionResult>(module, "Result",
                              "What detect() made of a cloud: a sequence of its detections.")
      .def_property_readonly(
          "detections", [](const DetectionResult& r) { return reported(r.detections); },
          "Best score first.")
      .def_property_readonly(
          "boxes", [](const DetectionResult& r) { return reported(r.boxes); }, "The surest first.")
      .def_readonly("bodies", &DetectionResult::bodies, "The things of the scene, by their ids.")
      .def_readonly("points_finite", &DetectionResult::points_finite, "Points that are no NaN.")
      .def_readonly("points_used", &DetectionResult::points_used, "Those that samples are made of.")
      .def_property_readonly(
          "timings", [](const DetectionResult& r) { return dict_of(r.timings); }, "By stage [ms].")
      .def_readonly("total_ms", &DetectionResult::total_ms, "Of all stages [ms].")
      .def_readonly("warnings", &DetectionResult::warnings,
                    "Why the result may be empty or poor; empty when all is well.")
      .def("__iter__",
           [](const DetectionResult& r) { return py::iter(py::cast(reported(r.detections))); })
      .def("__getitem__",
           [](const DetectionResult& r, const py::object& index) {
             return py::cast(reported(r.detections))[index].cast<py::object>();
           })
      .def("__len__", [](const DetectionResult& r) { return reported(r.detections).size(); })
      .def("__repr__", [](const DetectionResult& r) {
        return "<Result: " + std::to_string(reported(r.detections).size()) + " quadrics, " +
               std::to_string(reported(r.boxes).size()) + " boxes>";
      });
}

DetectionResult detect_in(const Points& points, const Eigen::Vector3d& viewpoint,
                          const std::vector<PyCloud>& views, const RobotShapes& robot,
                          const std::string& settings, const std::string& source) {
  const DetectorOptions options = io::search_options(io::parse_detector_config(settings, source));
  const CloudView cloud = view_of(points, viewpoint);
  std::vector<PointCloud> all = clouds_of(views);
  const py::gil_scoped_release others_run;
  // A single cloud without a robot in it is not copied.
  if (all.empty() && robot.shapes.empty()) return detect(cloud, options);
  all.insert(all.begin(), cloud_of(cloud));
  for (PointCloud& view : all) view = robot.taken_from(std::move(view));
  align_views(&all, options);
  return detect_views(all, options);
}

void bind_memory(py::module_& module) {
  py::class_<ViewMemory>(module, "ViewMemory", "See quadrille.ViewMemory.")
      .def(py::init([](const std::string& settings, const std::string& source) {
             return std::make_unique<ViewMemory>(
                 io::search_options(io::parse_detector_config(settings, source)));
           }),
           py::arg("settings"), py::arg("source"))
      .def(
          "add",
          [](ViewMemory& memory, std::int64_t utime, const Points& points,
             const Eigen::Vector3d& viewpoint, const Eigen::Matrix4d& X_WC, int camera) {
            const PointCloud cloud = cloud_of(view_of(points, viewpoint));
            return matrix_of(memory.add(utime, cloud, pose_of(X_WC, "X_WC"), camera));
          },
          py::arg("utime"), py::arg("points"), py::arg("viewpoint"), py::arg("X_WC"),
          py::arg("camera"))
      .def(
          "others",
          [](const ViewMemory& memory, std::int64_t utime, const Eigen::Matrix4d& X_WC,
             int camera) {
            std::vector<PyCloud> views;
            for (const PointCloud& view : memory.others(utime, pose_of(X_WC, "X_WC"), camera)) {
              views.push_back(cloud_to_python(view));
            }
            return views;
          },
          py::arg("utime"), py::arg("X_WC"), py::arg("camera"))
      .def("forget", py::overload_cast<>(&ViewMemory::forget))
      .def(
          "forget_box",
          [](ViewMemory& memory, const Eigen::Matrix4d& X_WR, const Eigen::Vector3d& size) {
            memory.forget(pose_of(X_WR, "X_WR"), {-0.5 * size, 0.5 * size});
          },
          py::arg("X_WR"), py::arg("size"))
      .def("__len__", &ViewMemory::size);
}

void bind_tracker(py::module_& module) {
  py::class_<Tracker>(module, "Tracker", "See quadrille.Tracker.")
      .def(py::init([](const std::string& settings, const std::string& source) {
             return std::make_unique<Tracker>(io::parse_detector_config(settings, source).track);
           }),
           py::arg("settings"), py::arg("source"))
      .def(
          "update",
          [](Tracker& tracker, DetectionResult& result, std::int64_t utime,
             const Eigen::Matrix4d& X_WC) {
            tracker.update(utime, pose_of(X_WC, "X_WC"), &result.detections);
          },
          py::arg("result"), py::arg("utime"),
          py::arg("X_WC") = Eigen::Matrix4d(Eigen::Matrix4d::Identity()));
}

PyCloud read_cloud_file(const std::filesystem::path& path) {
  return cloud_to_python(io::read_cloud(path.string()));
}

}  // namespace

void bind_detector(py::module_& module) {
  bind_detection(module);
  bind_box(module);
  bind_body(module);
  bind_result(module);
  bind_tracker(module);
  bind_memory(module);
  module.def("detect", &detect_in, py::arg("points"), py::arg("viewpoint"), py::arg("views"),
             py::arg("robot"), py::arg("settings"), py::arg("source"), "See quadrille.detect().");
  module.def("read_cloud", &read_cloud_file, py::arg("path"),
             "The points of a file, (N, 3) or (H, W, 3) [m], and its viewpoint, (3,) [m].\n\n"
             "Raises FileError, a ValueError, in one line if it cannot be read.");
}

}  // namespace quadrille::python
