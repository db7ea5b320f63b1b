#include "quadrille/plan_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/choice_option.hpp"
#include "cli/detector_arguments.hpp"
#include "cli/output.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "cli/planner/query_arguments.hpp"
#include "cli/report_option.hpp"
#include "io/file_bytes.hpp"
#include "io/json/settings_json.hpp"
#include "io/new_file.hpp"
#include "io/planner/config.hpp"
#include "io/planner/octree_bytes.hpp"
#include "io/planner/plan_json.hpp"
#include "io/run_info.hpp"
#include "picture/picture.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/command_report.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/conventions.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/picture_option.hpp"
#include "quadrille/table.hpp"
#include "quadrille/tracking.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille {
namespace {

struct PlanArguments {
  std::string json, map, report;
  PictureArguments picture;
  std::vector<std::string> inputs, views;
  DetectorArguments detector;
  PlannerArguments planner;
  InputArguments input;
  QueryArguments query;
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

// A view that is given twice, or is the input itself, adds nothing, and was probably meant to be
// another file.
void refuse_same(const std::string& input, const std::vector<std::string>& views) {
  std::vector<std::string> seen = {input};
  for (const std::string& path : views) {
    for (const std::string& other : seen) {
      std::error_code missing;  // ignored, since reading the file will report it
      if (path == other || std::filesystem::equivalent(path, other, missing)) {
        throw io::FileError(path, "", "is given twice; each --view must be another cloud");
      }
    }
    seen.push_back(path);
  }
}

/// Reads the other views, each with the viewpoint that its file names.
/// @param X_KC  pose of their frame C in the working frame K
/// @param warnings  receives warnings about the views
std::vector<PointCloud> read_views(const std::vector<std::string>& paths,
                                   const Eigen::Isometry3d& X_KC,
                                   std::vector<std::string>* warnings) {
  std::vector<PointCloud> views;
  for (const std::string& path : paths) {
    SingleCloud view = read_single_cloud(path);
    print_warnings(path, view.warnings);
    add_warnings(path, view.warnings, warnings);
    views.push_back(moved(std::move(view.input.cloud), X_KC));
  }
  return views;
}

/// @param X_CK  pose of the map's frame K in the frame C in which it is written
void write_map(const std::string& path, const OccupancyGrid& space, const Eigen::Isometry3d& X_CK,
               io::NewFile& file) {
  const bool moves = !X_CK.matrix().isIdentity(0.0);
  std::ofstream stream(file.path(), std::ios::binary);
  stream << io::octree_bytes(*(moves ? space.moved(X_CK) : space).to_octree());
  stream.close();
  if (!stream) throw io::FileError(path, "", "cannot be written; check the space left");
  file.commit();
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
  setup.options = arguments.planner.overrule(setup.config.planner);
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
  std::optional<io::NewFile> map;
  CommandReport report;
};

/// Writes and prints the detections and the plan, in the cloud's own frame.
/// @param info  information about the run, with the warnings so far
void put_out(const PlanArguments& arguments, const PlanSetup& setup, const InputCloud& input,
             io::RunInfo info, const DetectionResult& result, const GraspPlan& plan,
             PlanOutput* output) {
  for (const auto& warnings : {result.warnings, without(plan.warnings, result.warnings)}) {
    info.warnings.insert(info.warnings.end(), warnings.begin(), warnings.end());
    print_warnings(input.info.input, warnings);
  }
  // If nothing was found, warnings about the cloud are the likely reason.
  GraspPlan nothing;
  nothing.warnings = result.warnings;
  const bool is_found = !result.detections.empty() || !plan.warnings.empty();
  io::Json object = io::plan_json(input.info, info, result, plan);
  object["query"] = io::to_json(arguments.query.query());
  if (arguments.advise) object["remedies"] = io::to_json(plan.remedies);
  if (arguments.convention) add_hands(plan, setup.gripper, *arguments.convention, &object);
  output->json.write(object);
  if (!output->json.owns_stdout()) {
    const Paint paint = Paint::of_stdout();
    print(detection_table(input.info, result, paint) +
          grasp_table(is_found ? plan : nothing, setup.options.unknown, arguments.advise, paint));
  }
  // The plan's warnings say why there is none.
  if (output->map && plan.space) write_map(arguments.map, *plan.space, input.X_CK, *output->map);
}

void plan_cloud(const PlanArguments& arguments, const PlanSetup& setup, const std::string& path,
                const InputCloud& input, Tracking* tracking, PlanOutput* output) {
  io::RunInfo info = setup.info;
  info.warnings.insert(info.warnings.end(), input.warnings.begin(), input.warnings.end());
  DetectionResult found = detect(input.cloud, setup.detector.options);
  tracking->add_to(input, path, &found.detections);
  // Detections are rounded as quadrille-grasp-planner would receive them, so that both plan the
  // same grasps to the last bit.
  const std::vector<Detection> detections = bus::as_received(found.detections);
  const GraspQuery query =
      moved(completed(arguments.query.query(), setup.options), input.X_CK.inverse());
  const std::vector<PointCloud> views =
      read_views(arguments.views, input.X_CK.inverse(), &info.warnings);
  const std::vector<Box> boxes = bus::as_received(found.boxes);
  const std::vector<SceneBody> bodies = bus::as_received(found.bodies);
  const GraspScene asked(input.cloud, detections, setup.gripper, setup.options, views, boxes,
                         bodies);
  GraspPlan planned = asked.plan_from_start(query);
  if (arguments.advise) {
    planned.remedies = find_remedies(planned, input.cloud, detections, setup.gripper, setup.options,
                                     views, query, boxes, bodies);
  }
  found.boxes = planned.boxes;
  // All detections were obstacles, but only those that were asked for are shown.
  std::erase_if(found.detections, [](const Detection& d) { return !is_reported(d); });
  std::erase_if(found.boxes, [](const Box& box) { return !is_reported(box); });
  DetectionResult result = found;
  result.detections = moved(std::move(result.detections), input.X_CK);
  result.boxes = moved(std::move(result.boxes), input.X_CK);
  result.bodies = moved(std::move(result.bodies), input.X_CK);
  put_out(arguments, setup, input, std::move(info), result, moved(planned, input.X_CK), output);
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

/// Refuses several inputs if views or a map are given, since those belong to one scene.
void check_single_scene(const PlanArguments& arguments) {
  if (arguments.inputs.size() == 1) return;
  const std::string option = !arguments.map.empty() ? "--map" : "--view";
  if (arguments.map.empty() && arguments.views.empty()) return;
  throw CLI::ValidationError(option, "takes a single INPUT; plan for one after the other");
}

void run(const PlanArguments& arguments) {
  arguments.input.check(arguments.inputs);
  check_single_scene(arguments);
  const PlanSetup setup = setup_of(arguments);
  arguments.query.query();
  refuse_same(arguments.inputs.front(), arguments.views);
  PlanOutput output{JsonLines(arguments.json),
                    PicturePaths(arguments.picture.path, may_be_several(arguments.inputs)),
                    {},
                    CommandReport(arguments.report, arguments.inputs, setup.config)};
  if (!arguments.map.empty()) output.map.emplace(arguments.map);
  Tracking tracking(setup.detector.track, false);
  const auto visit = [&](const std::string& path, const InputCloud& input) {
    plan_cloud(arguments, setup, path, input, &tracking, &output);
  };
  if (arguments.map.empty() && arguments.views.empty()) {
    const ReadingResult read = for_each_input(arguments.inputs, arguments.input, visit);
    if (read.gave_anything()) {
      output.json.finish();
      output.report.finish(read.failed);
    }
    return read.check();
  }
  const std::string& path = arguments.inputs.front();
  const auto [input, warnings] = read_single_cloud(path, arguments.input);
  print_warnings(path, warnings);
  visit(path, input);
  output.json.finish();
  output.report.finish();
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
                    "Try other settings and hands where there is no grasp, and say what gives one");
  command->add_option("--view", arguments->views, "More views of the same scene, in its frame")
      ->type_name("CLOUD");
  command->add_option("--map", arguments->map, "Write free and occupied space as an OctoMap")
      ->type_name("FILE.bt");
  add_choice_option(*command, "--convention", arguments->convention, conventions(),
                    "Add to each grasp's JSON the hand's pose X_CH as this software has it");
  command->get_option("--convention")->needs("--json");
  arguments->input.add_to(*command);
  arguments->query.add_to(*command);
  arguments->picture.add_to(*command, "the cloud, the quadrics and the grasps");
  add_report_option(*command, arguments->report, "the clouds, the quadrics and the grasps");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
