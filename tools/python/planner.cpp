#include <limits>
#include <optional>

#include "io/planner/config.hpp"
#include "io/planner/gripper_file.hpp"
#include "python/arrays.hpp"
#include "python/module.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp_scene.hpp"

namespace quadrille::python {
namespace {

void bind_gripper(py::module_& module) {
  py::class_<Gripper>(module, "Gripper")
      .def(py::init(&io::load_gripper), py::arg("name_or_path"))
      .def_readonly("name", &Gripper::name)
      .def_readonly("max_opening", &Gripper::max_opening)
      .def_readonly("min_opening", &Gripper::min_opening)
      .def_property_readonly("finger", [](const Gripper& g) { return g.finger; })
      .def_readonly("finger_front", &Gripper::finger_front)
      .def_property_readonly("pad", [](const Gripper& g) { return g.pad; })
      .def_property_readonly("palm", [](const Gripper& g) { return g.palm; })
      .def_readonly("max_force", &Gripper::max_force)
      .def_readonly("tcp", &Gripper::tcp)
      .def("__repr__", [](const Gripper& g) { return "<Gripper " + g.name + ">"; });
  module.def("grippers", &io::gripper_names);
}

HandConvention convention_of(const std::string& name) {
  std::string known;
  for (const HandConvention convention : kHandConventions) {
    if (to_string(convention) == name) return convention;
    known += (known.empty() ? "" : ", ") + std::string(to_string(convention));
  }
  throw std::invalid_argument("no convention '" + name + "'; there are: " + known);
}

void bind_grasp(py::module_& module) {
  py::class_<Grasp>(module, "Grasp")
      .def_readonly("target", &Grasp::target)
      .def_readonly("track", &Grasp::track)
      .def_property_readonly("kind", [](const Grasp& g) { return std::string(word_of(g.kind)); })
      .def_readonly("score", &Grasp::score)
      .def_property_readonly("X_CG", [](const Grasp& g) { return matrix_of(g.X_CG); })
      .def_property_readonly("pregrasp", [](const Grasp& g) { return matrix_of(g.pregrasp()); })
      .def_readonly("width", &Grasp::width)
      .def_readonly("preshape", &Grasp::preshape)
      .def_property_readonly("contacts",
                             [](const Grasp& g) {
                               Eigen::Matrix<double, 2, 3> contacts;
                               contacts << g.contacts_C[0].transpose(), g.contacts_C[1].transpose();
                               return contacts;
                             })
      .def_readonly("approach", &Grasp::approach)
      .def_readonly("friction_needed", &Grasp::friction_needed)
      .def_readonly("epsilon", &Grasp::epsilon)
      .def_readonly("clearance", &Grasp::clearance)
      .def_readonly("unknown_contact", &Grasp::unknown_contact)
      .def(
          "hand_pose",
          [](const Grasp& g, const Gripper& gripper, const std::string& convention) {
            return matrix_of(hand_pose(convention_of(convention), gripper, g.X_CG, g.width));
          },
          py::arg("gripper"), py::arg("convention"))
      .def("__repr__", [](const Grasp& g) {
        return "<Grasp on " + std::to_string(g.target) + ": score " + std::to_string(g.score) + ">";
      });
}

void bind_plan(py::module_& module) {
  py::class_<GraspPlan>(module, "Plan")
      .def_readonly("grasps", &GraspPlan::grasps)
      .def_readonly("rejected", &GraspPlan::rejected)
      .def_readonly("boxes", &GraspPlan::boxes)
      .def_property_readonly("timings", [](const GraspPlan& p) { return dict_of(p.timings); })
      .def_readonly("total_ms", &GraspPlan::total_ms)
      .def_readonly("warnings", &GraspPlan::warnings)
      .def("__iter__", [](const GraspPlan& p) { return py::iter(py::cast(p.grasps)); })
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

/// As Python's keywords have it.
GraspQuery query_of(const std::vector<int>& targets, const std::vector<int>& tracks,
                    const std::vector<std::string>& types,
                    const std::optional<Eigen::Vector3d>& near, double min_size, double max_size,
                    const std::optional<Eigen::Vector3d>& approach, double approach_angle,
                    double min_clearance, const std::optional<int>& best) {
  GraspQuery query;
  query.ids = targets;
  query.tracks = tracks;
  for (const std::string& type : types) query.types.push_back(type_of(type));
  query.near_C = near;
  query.min_size = min_size;
  query.max_size = max_size;
  if (approach) query.approach = {approach->stableNormalized(), approach_angle};
  query.min_clearance = min_clearance;
  query.max_grasps = best;
  return query;
}

GraspScene scene_of(const Points& points, const DetectionResult& result, const Gripper& gripper,
                    const Eigen::Vector3d& viewpoint, const std::string& settings,
                    const std::string& source) {
  const PlanOptions options = io::parse_config(settings, source).planner;
  const PointCloud cloud = cloud_of(points, viewpoint);
  const py::gil_scoped_release others_run;
  // What quadrille-grasp-planner would get, so that both plan the same grasps.
  return {cloud, bus::as_received(result.detections), gripper, options};
}

void bind_scene(py::module_& module) {
  py::class_<GraspScene>(module, "GraspScene")
      .def(py::init(&scene_of), py::arg("points"), py::arg("result"), py::arg("gripper"),
           py::arg("viewpoint"), py::arg("settings"), py::arg("source"))
      .def_property_readonly("timings", [](const GraspScene& s) { return dict_of(s.timings()); })
      .def("plan", &GraspScene::plan, py::arg("query"), py::call_guard<py::gil_scoped_release>());
  py::class_<GraspQuery>(module, "GraspQuery")
      .def(py::init(&query_of), py::kw_only(), py::arg("targets") = std::vector<int>(),
           py::arg("tracks") = std::vector<int>(), py::arg("types") = std::vector<std::string>(),
           py::arg("near") = py::none(), py::arg("min_size") = 0.0,
           py::arg("max_size") = std::numeric_limits<double>::infinity(),
           py::arg("approach") = py::none(), py::arg("approach_angle") = 0.5,
           py::arg("min_clearance") = 0.0, py::arg("best") = py::none());
}

}  // namespace

void bind_planner(py::module_& module) {
  bind_gripper(module);
  bind_grasp(module);
  bind_plan(module);
  bind_scene(module);
}

}  // namespace quadrille::python
