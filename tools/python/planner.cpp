#include <pybind11/functional.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "io/planner/config.hpp"
#include "io/planner/gripper_file.hpp"
#include "io/planner/octree_file.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/looks.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/shape.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille::python {
namespace {

void bind_gripper(py::module_& module) {
  py::class_<Gripper>(module, "Gripper",
                      "A hand of two parallel jaws, as boxes in the grasp frame G: origin between "
                      "the pads, z approach, y closing.")
      .def(py::init(&io::load_gripper), py::arg("name_or_path"))
      .def_readonly("name", &Gripper::name, "Its name.")
      .def_readonly("max_opening", &Gripper::max_opening, "Largest distance between the pads [m].")
      .def_readonly("min_opening", &Gripper::min_opening, "Smallest distance between the pads [m].")
      .def_property_readonly(
          "finger", [](const Gripper& g) { return g.finger; },
          "Size of a finger along x, y and z, from its back to its tip, (3,) [m].")
      .def_readonly("finger_front", &Gripper::finger_front,
                    "How far the tip lies before the origin of G [m].")
      .def_property_readonly(
          "pad", [](const Gripper& g) { return g.pad; }, "Size of a pad along x and z, (2,) [m].")
      .def_property_readonly(
          "palm", [](const Gripper& g) { return g.palm; },
          "Size of the palm along x, y and z, (3,) [m].")
      .def_readonly("max_force", &Gripper::max_force, "Largest closing force [N].")
      .def_readonly("link_length", &Gripper::link_length,
                    "Length of the links on which the fingers swing [m]; 0 if they slide.")
      .def_readonly("link_angle", &Gripper::link_angle,
                    "Angle of the links to the approach at the largest opening [rad].")
      .def_readonly("tcp", &Gripper::tcp,
                    "From the origin of the hand's own frame to that of G [m]; 0: that frame lies "
                    "at the palm's back.")
      .def("__repr__", [](const Gripper& g) { return "<Gripper " + g.name + ">"; });
  module.def("grippers", &io::gripper_names, "Names of the built-in hands.");
}

std::vector<std::string> conventions() {
  std::vector<std::string> names;
  names.reserve(std::size(kHandConventions));
  for (const HandConvention convention : kHandConventions) {
    names.emplace_back(to_string(convention));
  }
  return names;
}

HandConvention convention_of(const std::string& name) {
  std::string known;
  for (const HandConvention convention : kHandConventions) {
    if (to_string(convention) == name) return convention;
    known += (known.empty() ? "" : ", ") + std::string(to_string(convention));
  }
  throw std::invalid_argument("no convention '" + name + "'; there are: " + known);
}

Eigen::Matrix<double, 2, 3> contacts_of(const Grasp& g) {
  Eigen::Matrix<double, 2, 3> contacts;
  contacts << g.contacts_C[0].transpose(), g.contacts_C[1].transpose();
  return contacts;
}

void bind_grasp(py::module_& module) {
  py::class_<Grasp> grasp(module, "Grasp",
                          "One grasp. Frame G: origin between the pads, z approach, y closing.");
  grasp.def_readonly("target", &Grasp::target, "Id of the detection, box or body that it holds.")
      .def_readonly("track", &Grasp::track, "Its track; 0 if it has none.")
      .def_property_readonly(
          "kind", [](const Grasp& g) { return std::string(to_string(g.kind)); },
          "'across' the body, on both 'end's, at the 'rim' of a vessel, or by the 'tip's.")
      .def_readonly("score", &Grasp::score, "0 to 1, best first.")
      .def_property_readonly(
          "X_CG", [](const Grasp& g) { return matrix_of(g.X_CG); }, "Pose of the hand, (4, 4) [m].")
      .def_property_readonly(
          "pregrasp", [](const Grasp& g) { return matrix_of(g.pregrasp()); },
          "Pose X_CG from which the hand comes straight, (4, 4) [m]; closed, it can go back there.")
      .def_readonly("width", &Grasp::width, "Distance between the contacts [m].")
      .def_readonly("preshape", &Grasp::preshape, "Opening of the hand on its way in [m].")
      .def_property_readonly("contacts", &contacts_of, "Both of them in frame C, (2, 3) [m].")
      .def_readonly("approach", &Grasp::approach, "Length of the straight way in [m].")
      .def_readonly("friction_needed", &Grasp::friction_needed, "Least friction coefficient.")
      .def_readonly("epsilon", &Grasp::epsilon,
                    "The largest wrench, of any direction, that a unit contact force resists.")
      .def_readonly("clearance", &Grasp::clearance,
                    "Distance of the hand from all but its target [m].")
      .def_readonly("unknown_contact", &Grasp::unknown_contact,
                    "Whether a contact lies on a part of the target that was not seen.");
  grasp
      .def(
          "hand_pose",
          [](const Grasp& g, const Gripper& gripper, const std::string& convention) {
            return matrix_of(hand_pose(convention_of(convention), gripper, g.X_CG, g.width));
          },
          py::arg("gripper"), py::arg("convention"),
          "Pose of the hand as other software writes it, (4, 4) [m]; see conventions().")
      .def("__repr__", [](const Grasp& g) {
        return "<Grasp on " + std::to_string(g.target) + ": score " + std::to_string(g.score) + ">";
      });
  module.def("conventions", &conventions,
             "Names of the ways in which other software writes the pose of a hand.");
}

void bind_plan(py::module_& module) {
  py::class_<TargetOutcome>(module, "TargetOutcome", "What became of one target.")
      .def_readonly("target", &TargetOutcome::target, "Id of the detection, box or body.")
      .def_readonly("grasps", &TargetOutcome::grasps, "Number of grasps that were found.")
      .def_property_readonly(
          "rejected",
          [](const TargetOutcome& outcome) {
            std::map<std::string, int> counts;
            for (const auto& [why, count] : outcome.refusals) counts.emplace(to_string(why), count);
            return counts;
          },
          "How many of its candidates were refused, by reason.")
      .def_property_readonly(
          "furthest",
          [](const TargetOutcome& outcome) -> std::optional<std::string> {
            if (const auto why = furthest(outcome.refusals)) return std::string(to_string(*why));
            return std::nullopt;
          },
          "The reason that refused the candidates which passed most checks; None if there is "
          "none.");
  py::class_<Remedy>(module, "Remedy", "A change of one setting with which a target has a grasp.")
      .def_readonly("target", &Remedy::target, "Id of the detection, box or body.")
      .def_readonly("change", &Remedy::change,
                    "The change, as on the command line: '--gripper robotiq_2f85'.")
      .def_readonly("grasps", &Remedy::grasps, "Number of grasps of the target after the change.")
      .def_readonly("score", &Remedy::score, "Score of the best of them.");
  py::class_<Look>(module, "Look", "A view that would help bodies without a good grasp.")
      .def_property_readonly(
          "X_CK", [](const Look& look) { return matrix_of(look.X_CK); },
          "Pose of the camera's frame K, (4, 4) [m]: z ahead, x along the rows of its image.")
      .def_readonly("bodies", &Look::bodies,
                    "Ids of the bodies that it would help, the largest gain first.")
      .def_readonly("gain", &Look::gain,
                    "Sum over these of the share, 0 to 1, of the unknown space about them that it "
                    "would show.");
  py::class_<GraspPlan>(module, "Plan", "What was planned on a cloud: a sequence of its grasps.")
      .def_readonly("grasps", &GraspPlan::grasps, "Best first.")
      .def_readonly("rejected", &GraspPlan::rejected, "How much was refused, by reason.")
      .def_readonly("targets", &GraspPlan::targets,
                    "What became of each target that was asked for.")
      .def_readonly("remedies", &GraspPlan::remedies,
                    "What would give grasps to targets that have none, if advise was asked for.")
      .def_readonly("looks", &GraspPlan::looks,
                    "Views that would help bodies without a good grasp, best first, if advise was "
                    "asked for.")
      .def_readonly("boxes", &GraspPlan::boxes, "Boxes among the detections, which may be targets.")
      .def_property_readonly(
          "timings", [](const GraspPlan& p) { return dict_of(p.timings); }, "By stage [ms].")
      .def_readonly("total_ms", &GraspPlan::total_ms, "Of all stages [ms].")
      .def_readonly("warnings", &GraspPlan::warnings,
                    "Why the plan may be empty or poor; empty when all is well.")
      .def("__iter__", [](const GraspPlan& p) { return py::iter(py::cast(p.grasps)); })
      .def("__getitem__",
           [](const GraspPlan& p, const py::object& index) {
             return py::cast(p.grasps)[index].cast<py::object>();
           })
      .def("__len__", [](const GraspPlan& p) { return p.grasps.size(); });
}

QuadricType type_of(const std::string& name) {
  std::string known;
  for (const auto& [word, type] : words_of(QuadricType{})) {
    if (word == name) return type;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  throw std::invalid_argument("no type '" + name + "'; there are: " + known);
}

/// Position of the base, least and greatest distance.
using PyReach = std::tuple<Eigen::Vector3d, double, double>;

std::vector<CollisionShape> with_geometries(const std::vector<SolidShape>& solids) {
  std::vector<CollisionShape> shapes;
  shapes.reserve(solids.size());
  for (const SolidShape& solid : solids) shapes.push_back(with_geometry(solid));
  return shapes;
}

/// Makes a query from the keyword arguments of Python.
GraspQuery query_of(const std::vector<int>& targets, const std::vector<int>& tracks,
                    const std::vector<std::string>& types,
                    const std::optional<Eigen::Vector3d>& near,
                    const std::optional<Eigen::Matrix<double, 2, 3>>& roi, double min_size,
                    double max_size, const std::optional<Eigen::Vector3d>& approach,
                    double approach_angle, const std::optional<PyReach>& reach,
                    const std::vector<SolidShape>& obstacles,
                    const std::vector<SolidShape>& attached, double min_clearance,
                    const std::optional<double>& min_score, const std::optional<int>& per_target,
                    const std::optional<int>& best, const std::optional<double>& deadline_ms,
                    const std::function<bool(const Grasp&)>& accept) {
  GraspQuery query;
  query.ids = targets;
  query.tracks = tracks;
  for (const std::string& type : types) query.types.push_back(type_of(type));
  query.near_C = near;
  if (roi) query.region = {Eigen::Isometry3d::Identity(), {roi->row(0), roi->row(1)}};
  query.min_size = min_size;
  query.max_size = max_size;
  if (approach) query.approach = {approach->stableNormalized(), approach_angle};
  if (reach) query.reach = {std::get<0>(*reach), std::get<1>(*reach), std::get<2>(*reach)};
  query.obstacles = with_geometries(obstacles);
  query.attached = with_geometries(attached);
  query.min_clearance = min_clearance;
  query.min_score = min_score;
  query.per_target = per_target;
  query.max_grasps = best;
  query.deadline_ms = deadline_ms;
  query.accept = accept;
  return query;
}

/// A scene with what it was made of, with which remedies and views that help are sought.
struct PlannedScene {
  PointCloud cloud;
  std::vector<Detection> detections;
  std::vector<Box> boxes;
  std::vector<SceneBody> bodies;
  Gripper gripper;
  PlanOptions options;
  Surroundings known;
  GraspScene scene{cloud, detections, gripper, options, known, boxes, bodies};

  GraspPlan plan(const GraspQuery& query, bool advise) const {
    GraspPlan plan = scene.plan(query);
    if (advise) {
      plan.remedies =
          find_remedies(plan, cloud, detections, gripper, options, known, query, boxes, bodies);
      plan.looks = propose_looks(plan, bodies, detections, cloud.viewpoint);
    }
    return plan;
  }
};

/// A map that was read.
struct PyMap {
  std::shared_ptr<const octomap::OcTree> tree;
};

PyMap map_of(const py::bytes& content, const std::string& name) {
  const auto text = static_cast<std::string_view>(content);
  return {io::parse_octree(std::as_bytes(std::span(text.data(), text.size())), name)};
}

KnownSupport support_of(const Eigen::Vector4d& plane) {
  const double norm = plane.head<3>().stableNorm();
  if (!(norm > 0.0)) throw std::invalid_argument("support has no normal; give (nx, ny, nz, d)");
  return {plane.head<3>() / norm, plane[3] / norm};
}

PlannedScene scene_of(const Points& points, const DetectionResult& result, const Gripper& gripper,
                      const Eigen::Vector3d& viewpoint, const std::vector<PyCloud>& views,
                      const RobotShapes& robot, const std::optional<PyMap>& map,
                      const std::optional<Eigen::Vector4d>& support, const std::string& settings,
                      const std::string& source) {
  const io::Config config = io::parse_config(settings, source);
  PointCloud cloud = cloud_of(view_of(points, viewpoint));
  Surroundings known;
  known.robot = robot;
  if (map) known.map.tree = map->tree;
  if (support) known.support = support_of(*support);
  std::vector<PointCloud> all = clouds_of(views);
  const py::gil_scoped_release others_run;
  if (!all.empty()) {
    all.insert(all.begin(), std::move(cloud));
    for (PointCloud& view : all) view = robot.taken_from(std::move(view));
    align_views(&all, config.detector);
    cloud = std::move(all.front());
    known.views.assign(std::make_move_iterator(all.begin() + 1),
                       std::make_move_iterator(all.end()));
  }
  // Detections are rounded as quadrille-grasp-planner would receive them, so that both plan the
  // same grasps.
  return {std::move(cloud),
          bus::as_received(result.detections),
          bus::as_received(result.boxes),
          bus::as_received(result.bodies),
          gripper,
          config.planner,
          std::move(known)};
}

void bind_scene(py::module_& module) {
  py::class_<PyMap>(module, "OctoMap", "A map of the scene, read from an OctoMap's file.")
      .def(py::init(&map_of), py::arg("content"), py::arg("name"));
  py::class_<PlannedScene>(module, "GraspScene", "See quadrille.GraspScene.")
      .def(py::init(&scene_of), py::arg("points"), py::arg("result"), py::arg("gripper"),
           py::arg("viewpoint"), py::arg("views"), py::arg("robot"), py::arg("octomap"),
           py::arg("support"), py::arg("settings"), py::arg("source"))
      .def_property_readonly("timings",
                             [](const PlannedScene& s) { return dict_of(s.scene.timings()); })
      .def("plan", &PlannedScene::plan, py::arg("query"), py::arg("advise"),
           py::call_guard<py::gil_scoped_release>());
  py::class_<GraspQuery>(module, "GraspQuery", "See quadrille.GraspScene.plan().")
      .def(py::init(&query_of), py::kw_only(), py::arg("targets") = std::vector<int>(),
           py::arg("tracks") = std::vector<int>(), py::arg("types") = std::vector<std::string>(),
           py::arg("near") = py::none(), py::arg("roi") = py::none(), py::arg("min_size") = 0.0,
           py::arg("max_size") = std::numeric_limits<double>::infinity(),
           py::arg("approach") = py::none(), py::arg("approach_angle") = 0.5,
           py::arg("reach") = py::none(), py::arg("obstacles") = std::vector<SolidShape>(),
           py::arg("attached") = std::vector<SolidShape>(), py::arg("min_clearance") = 0.0,
           py::arg("min_score") = py::none(), py::arg("per_target") = py::none(),
           py::arg("best") = py::none(), py::arg("deadline_ms") = py::none(),
           py::arg("accept") = py::none());
}

}  // namespace

void bind_planner(py::module_& module) {
  bind_gripper(module);
  bind_grasp(module);
  bind_plan(module);
  bind_scene(module);
}

}  // namespace quadrille::python
