#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "python/arrays.hpp"
#include "python/found.hpp"
#include "python/module.hpp"
#include "python/words.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/known_detection.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille::python {
namespace {

using Corners = Eigen::Matrix<double, 2, 3>;

Detection detection_of(const std::string& type, const Eigen::Matrix4d& X_CQ,
                       const std::map<std::string, double>& dimensions,
                       const std::optional<Corners>& extent, bool inside, int id) {
  Eigen::AlignedBox3d extent_Q;
  if (extent) extent_Q = {extent->row(0).transpose(), extent->row(1).transpose()};
  if (extent && extent_Q.isEmpty()) {
    throw std::invalid_argument("extent: give the least corner first");
  }
  Detection detection =
      known_detection(type_of(type), pose_of(X_CQ, "X_CQ"), dimensions, extent_Q, inside);
  detection.id = id;
  return detection;
}

Box box_of(const Eigen::Matrix4d& X_CB, const Eigen::Vector3d& size, int id) {
  Box box = known_box(pose_of(X_CB, "X_CB"), size);
  box.id = id;
  return box;
}

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
  py::class_<Detection> detection(
      module, "Detection",
      "One quadric found in a cloud of frame C, or one that you know: its "
      "type, pose and dimensions, for types without ends also the extent "
      "[m], and whether it shows its inside.");
  detection
      .def(py::init(&detection_of), py::arg("type"), py::arg("X_CQ"), py::arg("dimensions"),
           py::arg("extent") = py::none(), py::arg("inside") = false, py::arg("id") = 0)
      .def_readonly("id", &Detection::id, "1, 2, … within one Result, best score first.")
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
      .def("shapes", &make_shapes,
           "Shapes for collision checks that enclose it, a list of CollisionShapes; empty if its "
           "size is not finite.")
      .def("__repr__", &shown);
  bind_numbers(detection);
}

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Box",
                  "A box, of which one to three faces were seen, or one that you know: the pose of "
                  "its middle, and its size [m].")
      .def(py::init(&box_of), py::arg("X_CB"), py::arg("size"), py::arg("id") = 0)
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
      .def("shape", py::overload_cast<const Box&>(&make_shape),
           "The shape for collision checks, a CollisionShape.")
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
      .def_property_readonly(
          "wall",
          [](const SceneBody& body) {
            return body.wall ? std::optional(body.wall->thickness) : std::nullopt;
          },
          "Thickness of its wall, such as that of a mug, if both sides were seen, or None [m].")
      .def_property_readonly(
          "wall_deviation",
          [](const SceneBody& body) {
            return body.wall ? std::optional(body.wall->std) : std::nullopt;
          },
          "Standard deviation of the thickness, or None [m].")
      .def_readonly("standing_on", &SceneBody::standing_on, "Id of the plane, or None.")
      .def_readonly("points", &SceneBody::points, "Number of cloud points on it.")
      .def_readonly("views", &SceneBody::views, "Number of views that show it.")
      .def_readonly("unseen", &SceneBody::unseen, "Time since the newest of them [s].")
      .def_readonly("track", &SceneBody::track,
                    "Number that it keeps in all results that a Tracker saw, whatever its kind and "
                    "parts are there; 0 if none did.")
      .def("__repr__", [](const SceneBody& body) {
        return "<Body " + std::to_string(body.id) + " " + std::string(to_string(body.kind)) + ">";
      });
}

/// Returns the findings that were asked for.
template <class Thing>
std::vector<Thing> reported(const std::vector<Thing>& all) {
  std::vector<Thing> asked;
  std::copy_if(all.begin(), all.end(), std::back_inserter(asked),
               [](const Thing& thing) { return is_reported(thing); });
  return asked;
}

std::vector<Detection> detections_of(const Found& found) {
  return reported(found.in_C().detections);
}

void bind_result(py::module_& module) {
  py::class_<Found> result(
      module, "Result",
      "What detect() made of a cloud, or what you know of it: a sequence of its "
      "detections.");
  result
      .def(py::init(&found_of), py::arg("detections") = std::vector<Detection>(),
           py::arg("boxes") = std::vector<Box>(), py::arg("bodies") = std::vector<SceneBody>())
      .def("with_known", &with_known, py::arg("detections") = std::vector<Detection>(),
           py::arg("boxes") = std::vector<Box>(),
           "Returns a Result that has all of this one, and what you know besides: the last ones of "
           "its detections and boxes, with new ids.")
      .def_property_readonly("detections", &detections_of, "Best score first.")
      .def_property_readonly(
          "boxes", [](const Found& f) { return reported(f.in_C().boxes); }, "The surest first.")
      .def_property_readonly(
          "bodies", [](const Found& f) { return f.in_C().bodies; },
          "The things of the scene, by their ids.")
      .def_property_readonly(
          "corrections",
          [](const Found& f) {
            std::vector<Eigen::Matrix4d> corrections;
            for (const Eigen::Isometry3d& X : f.corrections_C) corrections.push_back(X.matrix());
            return corrections;
          },
          "For each of the views, the motion within C that brought it onto the others, (4, 4).");
  result
      .def_property_readonly(
          "points_finite", [](const Found& f) { return f.in_K.points_finite; },
          "Points that are no NaN.")
      .def_property_readonly(
          "points_used", [](const Found& f) { return f.in_K.points_used; },
          "The number of points of which samples are made.")
      .def_property_readonly(
          "timings", [](const Found& f) { return dict_of(f.in_K.timings); }, "By stage [ms].")
      .def_property_readonly(
          "total_ms", [](const Found& f) { return f.in_K.total_ms; },
          "The time of all stages together [ms].")
      .def_property_readonly(
          "warnings", [](const Found& f) { return f.in_K.warnings; },
          "Why the result may be empty or poor; empty when all is well.")
      .def("__iter__", [](const Found& f) { return py::iter(py::cast(detections_of(f))); })
      .def("__getitem__",
           [](const Found& f, const py::object& index) {
             return py::cast(detections_of(f))[index].cast<py::object>();
           })
      .def("__len__", [](const Found& f) { return reported(f.in_K.detections).size(); })
      .def("__repr__", [](const Found& f) {
        return "<Result: " + std::to_string(reported(f.in_K.detections).size()) + " quadrics, " +
               std::to_string(reported(f.in_K.boxes).size()) + " boxes>";
      });
}

}  // namespace

void bind_findings(py::module_& module) {
  bind_detection(module);
  bind_box(module);
  bind_body(module);
  bind_result(module);
}

}  // namespace quadrille::python
