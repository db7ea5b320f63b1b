#include <pybind11/functional.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/planner/config.hpp"
#include "python/arrays.hpp"
#include "python/found.hpp"
#include "python/module.hpp"
#include "python/octomap.hpp"
#include "python/words.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/looks.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "quadrille/grasping/shape.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille::python {
namespace {

/// A plan in frame C, with its space in the frame K in which it was made.
struct PlanInC : GraspPlan {
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity();
};

std::shared_ptr<OccupancyGrid> space_of(const PlanInC& plan) {
  if (!plan.space) return nullptr;
  const bool moves = !plan.X_CK.matrix().isIdentity(0.0);
  return std::make_shared<OccupancyGrid>(moves ? plan.space->moved(plan.X_CK) : *plan.space);
}

std::string shown(const PlanInC& plan) {
  int refused = 0;
  for (const auto& [reason, count] : plan.rejected) refused += count;
  return "<Plan: " + std::to_string(plan.targets.size()) + " targets, " +
         std::to_string(plan.grasps.size()) + " grasps, " + std::to_string(refused) + " refused>";
}

void bind_plan(py::module_& module) {
  py::class_<PlanInC>(module, "Plan", "What was planned on a cloud: a sequence of its grasps.")
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
      .def_readonly(
          "shapes", &GraspPlan::shapes,
          "CollisionShapes of the boxes, and of the detections that are no faces of boxes.")
      .def_readonly("cut", &GraspPlan::cut,
                    "Whether the deadline ended the search, so that there may be more grasps.")
      .def_property_readonly("space", &space_of,
                             "Free, occupied and unknown space about the targets, a Space; None if "
                             "the deadline passed before it was mapped.")
      .def_property_readonly(
          "timings", [](const PlanInC& p) { return dict_of(p.timings); }, "By stage [ms].")
      .def_readonly("total_ms", &GraspPlan::total_ms, "Of all stages [ms].")
      .def_readonly("warnings", &GraspPlan::warnings,
                    "Why the plan may be empty or poor; empty when all is well.")
      .def("__iter__", [](const PlanInC& p) { return py::iter(py::cast(p.grasps)); })
      .def("__getitem__",
           [](const PlanInC& p, const py::object& index) {
             return py::cast(p.grasps)[index].cast<py::object>();
           })
      .def("__len__", [](const PlanInC& p) { return p.grasps.size(); })
      .def("__repr__", &shown);
}

/// Position of the base, least and greatest distance.
using PyReach = std::tuple<Eigen::Vector3d, double, double>;
/// Pose of a box, with the origin at its middle, and its sides.
using PyRegion = std::tuple<Eigen::Matrix4d, Eigen::Vector3d>;

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
                    const std::optional<Eigen::Matrix<double, 2, 3>>& roi,
                    const std::optional<PyRegion>& region, double min_size, double max_size,
                    const std::optional<Eigen::Vector3d>& approach, double approach_angle,
                    const std::optional<PyReach>& reach, const std::vector<SolidShape>& obstacles,
                    const std::vector<SolidShape>& attached, double min_clearance,
                    const std::optional<double>& min_score, const std::optional<int>& per_target,
                    const std::optional<int>& best, const std::optional<double>& deadline_ms,
                    const std::function<bool(const Grasp&)>& accept) {
  GraspQuery query;
  query.ids = targets;
  query.tracks = tracks;
  for (const std::string& type : types) query.types.push_back(type_of(type));
  query.near_C = near;
  if (roi && region) throw std::invalid_argument("give either roi or region");
  if (roi) query.region = {Eigen::Isometry3d::Identity(), {roi->row(0), roi->row(1)}};
  if (region) {
    const auto& [X_CR, size] = *region;
    query.region = {pose_of(X_CR, "the pose of region"), {-0.5 * size, 0.5 * size}};
  }
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

/// A scene with what it was made of, with which remedies and views that help are sought. All of it
/// is in the frame K in which it is planned.
struct PlannedScene {
  PointCloud cloud;
  DetectionResult found;
  Gripper gripper;
  PlanOptions options;
  Surroundings known;
  /// Pose of K in the frame C of the caller.
  Eigen::Isometry3d X_CK;
  GraspScene scene{cloud, found.detections, gripper, options, known, found.boxes, found.bodies};

  /// @param query  in frame C
  /// @param from_start  whether times and the deadline include the construction of the scene
  PlanInC plan(const GraspQuery& query, bool advise, bool from_start) const {
    const GraspQuery query_K = moved(completed(query, options), X_CK.inverse());
    GraspPlan plan = from_start ? scene.plan_from_start(query_K) : scene.plan(query_K);
    if (advise) {
      plan.remedies = find_remedies(plan, cloud, found.detections, gripper, options, known, query_K,
                                    found.boxes, found.bodies);
      plan.looks = propose_looks(plan, found.bodies, found.detections, gripper, options,
                                 viewpoints_of(cloud, known));
    }
    return {moved(std::move(plan), X_CK), X_CK};
  }
};

KnownSupport support_of(const Eigen::Vector4d& plane) {
  const double norm = plane.head<3>().stableNorm();
  if (!(norm > 0.0)) throw std::invalid_argument("support has no normal; give (nx, ny, nz, d)");
  return {plane.head<3>() / norm, plane[3] / norm};
}

PlannedScene scene_of(const py::object& points, const Found& result, const Gripper& gripper,
                      const Eigen::Vector3d& viewpoint, const std::vector<PyView>& views,
                      const RobotShapes& robot, const std::optional<Eigen::Matrix4d>& camera_pose,
                      const std::optional<PyMap>& map, const std::optional<Eigen::Matrix4d>& X_CM,
                      const std::optional<Eigen::Vector4d>& support, const std::string& settings,
                      const std::string& source) {
  const io::Config config = io::parse_config(settings, source);
  const Eigen::Isometry3d X_CK = working_frame(camera_pose), X_KC = X_CK.inverse();
  PointCloud cloud =
      camera_pose ? cloud_in_camera(points, X_CK) : cloud_of(view_of(points_of(points), viewpoint));
  Surroundings known;
  known.robot = robot;
  if (map) known.map.tree = map->tree;
  if (X_CM) known.map.X_CM = pose_of(*X_CM, "X_CM");
  if (support) known.support = support_of(*support);
  std::vector<PointCloud> all = clouds_of(views);
  DetectionResult found = result.in(X_CK);
  const py::gil_scoped_release others_run;
  known = moved(std::move(known), X_KC);
  if (!all.empty()) {
    for (PointCloud& view : all) view = moved(std::move(view), X_KC);
    all.insert(all.begin(), std::move(cloud));
    for (PointCloud& view : all) view = known.robot.taken_from(std::move(view));
    align_views(&all, config.detector);
    cloud = std::move(all.front());
    known.views.assign(std::make_move_iterator(all.begin() + 1),
                       std::make_move_iterator(all.end()));
  }
  return {std::move(cloud), std::move(found), gripper, config.planner, std::move(known), X_CK};
}

void bind_scene(py::module_& module) {
  py::class_<PlannedScene>(module, "GraspScene", "See quadrille.GraspScene.")
      .def(py::init(&scene_of), py::arg("points"), py::arg("result"), py::arg("gripper"),
           py::arg("viewpoint"), py::arg("views"), py::arg("robot"), py::arg("camera_pose"),
           py::arg("octomap"), py::arg("X_CM"), py::arg("support"), py::arg("settings"),
           py::arg("source"))
      .def_property_readonly("timings",
                             [](const PlannedScene& s) { return dict_of(s.scene.timings()); })
      .def("plan", &PlannedScene::plan, py::arg("query"), py::arg("advise"), py::arg("from_start"),
           py::call_guard<py::gil_scoped_release>());
  py::class_<GraspQuery>(module, "GraspQuery", "See quadrille.GraspScene.plan().")
      .def(py::init(&query_of), py::kw_only(), py::arg("targets") = std::vector<int>(),
           py::arg("tracks") = std::vector<int>(), py::arg("types") = std::vector<std::string>(),
           py::arg("near") = py::none(), py::arg("roi") = py::none(),
           py::arg("region") = py::none(), py::arg("min_size") = 0.0,
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
  bind_maps(module);
  bind_plan(module);
  bind_scene(module);
}

}  // namespace quadrille::python
