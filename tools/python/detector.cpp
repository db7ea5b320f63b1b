#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>

#include "io/cloud_file.hpp"
#include "io/config.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "quadrille/detector/tracker.hpp"

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

void bind_detection(py::module_& module) {
  py::class_<Detection>(module, "Detection")
      .def_readonly("id", &Detection::id)
      .def_property_readonly("type",
                             [](const Detection& d) { return std::string(to_string(d.type)); })
      .def_readonly("score", &Detection::score)
      .def_readonly("inliers", &Detection::inliers)
      .def_readonly("rms", &Detection::rms)
      .def_property_readonly("Q",
                             [](const Detection& d) -> Eigen::Matrix4d { return d.Q_C.matrix(); })
      .def_property_readonly("X_CQ", [](const Detection& d) { return matrix_of(d.X_CQ); })
      .def_property_readonly("dimensions", &values_of)
      .def_property_readonly("deviations", &deviations_of)
      .def_property_readonly(
          "q", [](const Detection& d) { return d.Q_C.coefficients(); },
          "A … J of unit norm, shape (10,).")
      .def_property_readonly(
          "covariance", [](const Detection& d) { return d.covariance.known; },
          "Covariance of q along the directions that the view shows, (10, 10).")
      .def_property_readonly(
          "open_directions", [](const Detection& d) { return d.covariance.open; },
          "Directions of q that the view leaves open, orthonormal columns, (10, K).")
      .def_property_readonly("extent", [](const Detection& d) { return corners_of(d.extent_Q); })
      .def_readonly("seen", &Detection::seen)
      .def_readonly("track", &Detection::track)
      .def("distance",
           [](const Detection& d, const Eigen::Matrix<double, Eigen::Dynamic, 3>& points) {
             Eigen::VectorXd distances(points.rows());
             for (Eigen::Index n = 0; n < points.rows(); ++n) {
               distances[n] = d.Q_C.distance(points.row(n).transpose());
             }
             return distances;
           })
      .def("__repr__", &shown);
}

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Box")
      .def_readonly("id", &Box::id)
      .def_readonly("faces", &Box::faces)
      .def_readonly("score", &Box::score)
      .def_property_readonly("X_CB", [](const Box& box) { return matrix_of(box.X_CB); })
      .def_property_readonly("size", [](const Box& box) { return box.size; })
      .def_property_readonly("deviations", [](const Box& box) { return box.std; })
      .def_readonly("seen", &Box::seen)
      .def_property_readonly("inner", [](const Box& box) { return corners_of(box.inner_B); })
      .def_property_readonly("outer", [](const Box& box) { return corners_of(box.outer_B); })
      .def("__repr__", [](const Box& box) { return "<Box " + std::to_string(box.id) + ">"; });
}

/// Those that were asked for.
template <class Found>
std::vector<Found> reported(const std::vector<Found>& all) {
  std::vector<Found> asked;
  std::copy_if(all.begin(), all.end(), std::back_inserter(asked),
               [](const Found& found) { return is_reported(found); });
  return asked;
}

void bind_result(py::module_& module) {
  py::class_<DetectionResult>(module, "Result")
      .def_property_readonly("detections",
                             [](const DetectionResult& r) { return reported(r.detections); })
      .def_property_readonly("boxes", [](const DetectionResult& r) { return reported(r.boxes); })
      .def_readonly("points_finite", &DetectionResult::points_finite)
      .def_readonly("points_used", &DetectionResult::points_used)
      .def_property_readonly("timings", [](const DetectionResult& r) { return dict_of(r.timings); })
      .def_readonly("total_ms", &DetectionResult::total_ms)
      .def_readonly("warnings", &DetectionResult::warnings)
      .def("__iter__",
           [](const DetectionResult& r) { return py::iter(py::cast(reported(r.detections))); })
      .def("__len__", [](const DetectionResult& r) { return reported(r.detections).size(); });
}

DetectionResult detect_in(const Points& points, const Eigen::Vector3d& viewpoint,
                          const std::string& settings, const std::string& source) {
  const io::DetectorConfig config = io::parse_detector_config(settings, source);
  const PointCloud cloud = cloud_of(points, viewpoint);
  const py::gil_scoped_release others_run;
  return detect(cloud, config.detector);
}

void bind_tracker(py::module_& module) {
  py::class_<Tracker>(module, "Tracker")
      .def(py::init([](const std::string& settings, const std::string& source) {
             return std::make_unique<Tracker>(io::parse_detector_config(settings, source).track);
           }),
           py::arg("settings") = "", py::arg("source") = "settings")
      .def(
          "update",
          [](Tracker& tracker, DetectionResult& result, std::int64_t utime,
             const Eigen::Matrix4d& X_WC) {
            tracker.update(utime, pose_of(X_WC, "X_WC"), &result.detections);
          },
          py::arg("result"), py::arg("utime"),
          py::arg("X_WC") = Eigen::Matrix4d(Eigen::Matrix4d::Identity()));
}

py::tuple read_cloud_file(const std::string& path) {
  const PointCloud cloud = io::read_cloud(path);
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(cloud.points.size()), 3};
  if (cloud.organised()) shape = {cloud.height, cloud.width, 3};
  Points points(shape);
  if (!cloud.points.empty()) {
    std::copy_n(cloud.points.front().data(), 3 * cloud.points.size(), points.mutable_data());
  }
  return py::make_tuple(points, cloud.viewpoint);
}

}  // namespace

void bind_detector(py::module_& module) {
  bind_detection(module);
  bind_box(module);
  bind_result(module);
  bind_tracker(module);
  module.def("detect", &detect_in, py::arg("points"), py::arg("viewpoint"), py::arg("settings"),
             py::arg("source"));
  module.def("read_cloud", &read_cloud_file, py::arg("path"));
}

}  // namespace quadrille::python
