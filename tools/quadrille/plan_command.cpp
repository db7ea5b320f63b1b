#include "quadrille/plan_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/choice_option.hpp"
#include "cli/detector_arguments.hpp"
#include "cli/output.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "cli/planner/query_arguments.hpp"
#include "cli/planner/surroundings_arguments.hpp"
#include "cli/report_option.hpp"
#include "cli/robot_option.hpp"
#include "io/json/settings_json.hpp"
#include "io/planner/config.hpp"
#include "io/planner/plan_json.hpp"
#include "io/run_info.hpp"
#include "picture/picture.hpp"
#include "poses/robot_state.hpp"
#include "quadrille/command_report.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/finer_cells.hpp"
#include "quadrille/further_views.hpp"
#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/looks.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "quadrille/grasping/shape.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/lasting_scene.hpp"
#include "quadrille/map_file.hpp"
#include "quadrille/picture_option.hpp"
#include "quadrille/table.hpp"
#include "quadrille/tracking.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille {
namespace {

struct PlanArguments {
  std::string json, map, report;
  PictureArguments picture;
  std::vector<std::string> inputs;
  ViewArguments views;
  DetectorArguments detector;
  PlannerArguments planner;
  InputArguments input;
  QueryArguments query;
  /// In the frame of the results, without views.
  Surroundings known;
  std::optional<HandConvention> convention;
  bool advise = false;
};

Choices<HandConvention> conventions() {
  Choices<HandConvention> choices;
  for (const HandConvention convention : kHandConventions) {
    choices.emplace_back(std::string(to_string(convention)), convention);
  }
  return choices;
}

// Adds to each grasp the pose of the hand in the convention of other software.
void add_hands(const GraspPlan& plan, const Gripper& gripper, HandConvention convention,
               io::Json* json) {
  for (std::size_t n = 0; n < plan.grasps.size(); ++n) {
    const Grasp& grasp = plan.grasps[n];
    io::Json hand = {{"convention", std::string(to_string(convention))}};
    hand.update(io::to_json(hand_pose(convention, gripper, grasp.X_CG, grasp.width)));
    (*json)["grasps"][n]["X_CH"] = hand;
  }
}

/// Returns the lines that are not among the others.
std::vector<std::string> without(std::vector<std::string> lines,
                                 const std::vector<std::string>& others) {
  std::erase_if(lines, [&](const std::string& line) {
    return std::find(others.begin(), others.end(), line) != others.end();
  });
  return lines;
}

/// The settings with which the command plans, the same for all clouds.
struct PlanSetup {
  DetectorSetup detector;
  Gripper gripper;
  PlanOptions options;
  /// Information about the run, without the warnings about a cloud.
  io::RunInfo info;
  /// All settings, including those of the command line.
  io::Config config;
};

PlanSetup setup_of(const PlanArguments& arguments) {
  PlanSetup setup;
  setup.config = io::load_config(arguments.detector.config);
  setup.detector = arguments.detector.overrule_for_planning(setup.config);
  setup.gripper = arguments.planner.gripper();
  setup.options = arguments.planner.overrule(setup.config.planner, arguments.detector.threads);
  setup.config.detector = setup.detector.options;
  setup.config.planner = setup.options;
  setup.info.seed = setup.detector.options.seed;
  setup.info.settings = io::changed_settings(setup.detector.options, setup.options);
  setup.info.gripper = setup.gripper.name;
  return setup;
}

/// The destinations of the results.
struct PlanOutput {
  JsonLines json;
  PicturePaths pictures;
  std::optional<MapFile> map;
  CommandReport report;

  void finish(bool failed = false) {
    if (map) map->finish();
    json.finish();
    report.finish(failed);
  }
};

/// Writes and prints the detections and the plan, in the cloud's own frame.
/// @param info  information about the run, with the warnings so far
void put_out(const PlanArguments& arguments, const PlanSetup& setup, const InputCloud& input,
             io::RunInfo info, const SceneViews& views, const DetectionResult& result,
             const GraspPlan& plan, PlanOutput* output) {
  for (const auto& warnings : {result.warnings, without(plan.warnings, result.warnings)}) {
    info.warnings.insert(info.warnings.end(), warnings.begin(), warnings.end());
    print_warnings(input.info.input, warnings);
  }
  // If nothing was found, warnings about the cloud are the likely reason.
  GraspPlan nothing;
  nothing.warnings = result.warnings;
  const bool is_found = !result.detections.empty() || !plan.warnings.empty();
  io::Json object = io::plan_json(views.info, info, result, plan);
  if (!views.corrections.empty()) object["views"] = views.corrections;
  object["query"] = io::to_json(arguments.query.query());
  if (const io::Json known = io::to_json(arguments.known); !known.empty()) object["known"] = known;
  if (arguments.advise) {
    object["remedies"] = io::to_json(plan.remedies);
    object["look"] = io::to_json(plan.looks);
  }
  if (arguments.convention) add_hands(plan, setup.gripper, *arguments.convention, &object);
  output->json.write(object);
  if (!output->json.owns_stdout()) {
    const Paint paint = Paint::of_stdout();
    print(detection_table(views.info, result, paint) +
          grasp_table(is_found ? plan : nothing, arguments.advise, paint) +
          (has_only_planes(result) ? hint_at_finer_cells(plan.remedies, arguments.advise) : "") +
          look_table(plan.looks));
  }
  // The plan's warnings say why there is none.
  if (output->map) output->map->keep(plan.space, input.X_CK);
}

/// The tracks and views of the clouds before.
struct Before {
  Tracking tracking;
  LastingScene scene;
};

void plan_cloud(const PlanArguments& arguments, const PlanSetup& setup, const std::string& path,
                InputCloud input, Before* before, PlanOutput* output) {
  io::RunInfo info = setup.info;
  info.warnings.insert(info.warnings.end(), input.warnings.begin(), input.warnings.end());
  const RobotShapes robot = joined(moved(arguments.known.robot, input.X_CK.inverse()), input.robot);
  SceneViews views = all_views(arguments.views, input, robot, setup.detector.options,
                               arguments.input.frames.unit, &info.warnings);
  std::vector<PointCloud> earlier;
  DetectionResult found = before->scene.lasts()
                              ? before->scene.detect(&input, path, robot, &earlier)
                              : detect_views(views.clouds(), setup.detector.options);
  Surroundings known = moved(arguments.known, input.X_CK.inverse());
  known.robot = robot;
  known.views = std::move(earlier);
  views.info.viewpoint = input.X_CK * input.cloud.viewpoint;
  before->tracking.add_to(input, path, &found);
  if (!input.asked) return;
  GraspQuery query = moved(completed(arguments.query.query(), setup.options), input.X_CK.inverse());
  for (const SolidShape& shape : input.attached) query.attached.push_back(with_geometry(shape));
  // The planner drops the robot's points itself, since it needs to know what they hide; if there
  // are other views, they show that.
  const PointCloud& cloud = views.clouds().size() > 1 ? views.clouds().front() : input.cloud;
  known.views.insert(known.views.end(), views.clouds().begin() + 1, views.clouds().end());
  const GraspScene asked(cloud, found.detections, setup.gripper, setup.options, known, found.boxes,
                         found.bodies);
  GraspPlan planned = asked.plan_from_start(query);
  if (arguments.advise) {
    planned.remedies = find_remedies(planned, cloud, found.detections, setup.gripper, setup.options,
                                     known, query, found.boxes, found.bodies);
    if (has_only_planes(found)) {
      planned.remedies = try_finer_cells(
          views.clouds(), setup.detector.options, [&](const DetectionResult& finer) {
            return GraspScene(cloud, finer.detections, setup.gripper, setup.options, known,
                              finer.boxes, finer.bodies)
                .plan_from_start(query);
          });
    }
    planned.looks = propose_looks(planned, found.bodies, found.detections, setup.gripper,
                                  setup.options, viewpoints_of(cloud, known));
  }
  found.boxes = planned.boxes;
  // All detections were obstacles, but only those that were asked for are shown.
  std::erase_if(found.detections, [](const Detection& d) { return !is_reported(d); });
  std::erase_if(found.boxes, [](const Box& box) { return !is_reported(box); });
  DetectionResult result = found;
  result.detections = moved(std::move(result.detections), input.X_CK);
  result.boxes = moved(std::move(result.boxes), input.X_CK);
  result.bodies = moved(std::move(result.bodies), input.X_CK);
  put_out(arguments, setup, input, std::move(info), views, result, moved(planned, input.X_CK),
          output);
  if (output->pictures.wanted()) {
    arguments.picture.write(output->pictures.next(path),
                            {input.info.input, input.cloud, found, &planned, &setup.gripper});
  }
  if (!output->report.wanted()) return;
  view::Scene scene = view::scene_of_result(input.cloud, found, input.X_CK);
  view::add_plan(asked, query, planned, setup.gripper, setup.options.unknown, input.X_CK, {},
                 &scene);
  output->report.add(input, std::move(scene));
}

/// Refuses a map of several scenes, since it belongs to one, and one on standard output.
void check_map(const PlanArguments& arguments) {
  if (arguments.map == "-") throw CLI::ValidationError("--map", "takes the path of a file");
  if (arguments.map.empty() || arguments.input.scene || arguments.inputs.size() == 1) return;
  throw CLI::ValidationError("--map",
                             "takes a single INPUT, or views of one scene (--scene); plan for one "
                             "after the other");
}

void run(const PlanArguments& arguments) {
  arguments.input.check(arguments.inputs);
  arguments.views.check(arguments.inputs);
  check_map(arguments);
  const PlanSetup setup = setup_of(arguments);
  arguments.query.query();
  PlanOutput output{JsonLines(arguments.json),
                    PicturePaths(arguments.picture.path, may_be_several(arguments.inputs)),
                    {},
                    CommandReport(arguments.report, arguments.inputs, setup.config)};
  if (!arguments.map.empty()) output.map.emplace(arguments.map);
  Before before{{setup.detector.track, arguments.input.scene},
                {arguments.input.scene, true, setup.detector.options}};
  const auto visit = [&](const std::string& path, InputCloud input) {
    plan_cloud(arguments, setup, path, std::move(input), &before, &output);
  };
  InputArguments selection = arguments.input;
  selection.track = setup.detector.track;
  if ((arguments.map.empty() && arguments.views.paths.empty()) || selection.scene) {
    const ReadingResult read = for_each_input(arguments.inputs, selection, visit);
    if (read.gave_anything()) output.finish(read.failed);
    return read.check();
  }
  const std::string& path = arguments.inputs.front();
  const auto [input, warnings] = read_single_cloud(path, selection);
  print_warnings(path, warnings);
  visit(path, input);
  output.finish();
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Find quadrics and plan grasps on them");
  command->add_option("INPUT", arguments->inputs, kInputs)->required();
  arguments->planner.add_to(*command, "");
  command->add_option("--json", arguments->json, "Write JSON, an object a line; - is stdout")
      ->type_name("FILE|-");
  command->add_flag("--advise", arguments->advise,
                    "Try other settings and hands where there is no grasp, say what gives one, and "
                    "propose views that would help");
  arguments->views.add_to(*command);
  command
      ->add_option("--map", arguments->map,
                   "Write free and occupied space as an OctoMap; that of the last plan with "
                   "--scene")
      ->type_name("FILE.bt");
  add_choice_option(*command, "--convention", arguments->convention, conventions(),
                    "Add to each grasp's JSON the hand's pose X_CH as this software has it");
  command->get_option("--convention")->needs("--json");
  arguments->input.add_to(*command);
  command->get_option("--scene")->excludes("--view");
  arguments->query.add_to(*command);
  add_robot_option(*command, arguments->known.robot, "the frame of the results");
  add_surroundings_options(*command, arguments->known, "the frame of the results");
  arguments->picture.add_to(*command, "the cloud, the quadrics and the grasps");
  add_report_option(*command, arguments->report, "the clouds, the quadrics and the grasps");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
