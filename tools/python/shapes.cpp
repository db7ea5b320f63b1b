#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/json/shapes_file.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/detector/solid_shape.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille::python {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Faces = std::vector<std::vector<int>>;

SolidShape shape_of(const std::string& kind, const std::vector<double>& dimensions,
                    const Eigen::Matrix4d& pose, const Rows& vertices, const Faces& faces) {
  SolidShape shape{kind, pose_of(pose, "pose"), dimensions, {}, {}};
  for (Eigen::Index n = 0; n < vertices.rows(); ++n) shape.vertices_S.push_back(vertices.row(n));
  for (const std::vector<int>& face : faces) {
    shape.faces.push_back(static_cast<int>(face.size()));
    shape.faces.insert(shape.faces.end(), face.begin(), face.end());
  }
  shape.check();
  return shape;
}

Rows vertices_of(const SolidShape& shape) {
  Rows rows(shape.vertices_S.size(), 3);
  for (Eigen::Index n = 0; n < rows.rows(); ++n) rows.row(n) = shape.vertices_S[n];
  return rows;
}

/// Returns the corners of each face; the shape has passed its check.
Faces faces_of(const SolidShape& shape) {
  Faces faces;
  for (auto at = shape.faces.begin(); at != shape.faces.end();) {
    const auto end = at + 1 + *at;
    faces.emplace_back(at + 1, end);
    at = end;
  }
  return faces;
}

RobotShapes robot_of(const std::vector<SolidShape>& shapes, double padding) {
  RobotShapes robot{shapes, padding};
  robot.check();
  return robot;
}

Points without_robot(const RobotShapes& robot, const Points& points) {
  const CloudView view = view_of(points, Eigen::Vector3d::Zero());
  return std::get<0>(cloud_to_python(robot.taken_from(cloud_of(view))));
}

}  // namespace

void bind_shapes(py::module_& module) {
  const Eigen::Matrix4d here = Eigen::Matrix4d::Identity();
  py::class_<SolidShape>(module, "Shape",
                         "A convex solid at a pose: sphere (radius), ellipsoid (half axes along x, "
                         "y, z), cylinder and cone (radius, length), capsule (radius, length "
                         "between the middles of its round ends), box (full sides along x, y, z), "
                         "or convex (vertices and faces). The origin is its middle, and z its "
                         "axis; a cone's apex is at +z.")
      .def(py::init(&shape_of), py::arg("kind"), py::arg("dimensions") = std::vector<double>(),
           py::arg("pose") = here, py::arg("vertices") = Rows(0, 3), py::arg("faces") = Faces())
      .def_readonly("kind", &SolidShape::kind,
                    "'sphere', 'ellipsoid', 'cylinder', 'capsule', 'cone', 'box' or 'convex'.")
      .def_property_readonly(
          "pose", [](const SolidShape& s) { return matrix_of(s.X_CS); },
          "Pose of the shape in the frame that it is given in, (4, 4) [m].")
      .def_readonly("dimensions", &SolidShape::dimensions, "Its sizes [m]; none if it is convex.")
      .def_property_readonly("vertices", &vertices_of,
                             "Vertices of a convex shape in its own frame, (N, 3) [m].")
      .def_property_readonly("faces", &faces_of,
                             "Of each face of a convex shape the indices of its corners.")
      .def("__repr__", [](const SolidShape& s) { return "<Shape " + s.kind + ">"; });
  py::class_<CollisionShape, SolidShape>(
      module, "CollisionShape", "A Shape that stands for a detection, a box, or a part of one.")
      .def_readonly("target", &CollisionShape::target, "Id of the detection or box.")
      .def_readonly("excess", &CollisionShape::excess,
                    "How far it reaches at most beyond what it stands for [m]; 0 if exact.");
  py::class_<RobotShapes>(module, "Robot", "The robot's own shapes when a cloud was taken.")
      .def(py::init(&robot_of), py::arg("shapes"), py::arg("padding") = RobotShapes().padding)
      .def_readonly("shapes", &RobotShapes::shapes, "Its links, its hand, and what that holds.")
      .def_readonly("padding", &RobotShapes::padding,
                    "A point within this distance of a shape is the robot's [m].")
      .def("taken_from", &without_robot, py::arg("points"),
           "Returns a copy of points (N, 3) or (H, W, 3) in which those of the robot are NaN.")
      .def("__repr__", [](const RobotShapes& robot) {
        return "<Robot of " + std::to_string(robot.shapes.size()) + " shapes>";
      });
  module.def("read_robot", &io::read_robot, py::arg("path"));
}

}  // namespace quadrille::python
