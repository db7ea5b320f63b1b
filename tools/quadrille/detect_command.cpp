#include "quadrille/detect_command.hpp"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/detector_arguments.hpp"
#include "cli/output.hpp"
#include "cli/report_option.hpp"
#include "cli/robot_option.hpp"
#include "io/json/settings_json.hpp"
#include "io/planner/config.hpp"
#include "io/run_info.hpp"
#include "picture/picture.hpp"
#include "poses/robot_state.hpp"
#include "quadrille/command_report.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/further_views.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/lasting_scene.hpp"
#include "quadrille/picture_option.hpp"
#include "quadrille/table.hpp"
#include "quadrille/tracking.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille {
namespace {

struct DetectArguments {
  std::vector<std::string> inputs;
  std::string json, report;
  PictureArguments picture;
  bool track = false;
  DetectorArguments detector;
  InputArguments input;
  ViewArguments views;
  /// In the frame of the results.
  RobotShapes robot;
};

io::RunInfo run_info(const DetectorSetup& setup) {
  io::RunInfo run;
  run.seed = setup.options.seed;
  run.settings = io::changed_settings(setup.options, setup.track);
  return run;
}

/// Adds the warnings about one cloud to those of the run.
io::RunInfo with_warnings(io::RunInfo run, const std::vector<std::string>& more) {
  run.warnings.insert(run.warnings.end(), more.begin(), more.end());
  return run;
}

void run(const DetectArguments& arguments) {
  arguments.input.check(arguments.inputs);
  arguments.views.check(arguments.inputs);
  io::Config settings = io::load_config(arguments.detector.config);
  const io::DetectorConfig& of_detector = settings;
  const DetectorSetup setup = arguments.detector.overrule(of_detector);
  settings.detector = setup.options;
  const io::RunInfo info = run_info(setup);
  PicturePaths pictures(arguments.picture.path, may_be_several(arguments.inputs));
  JsonLines json(arguments.json);
  CommandReport report(arguments.report, arguments.inputs, settings);
  Tracking tracking(setup.track, arguments.track || arguments.input.scene);
  LastingScene scene(arguments.input.scene, false, setup.options);
  const auto put_out = [&](const std::string& path, const InputCloud& input,
                           const SceneViews& views, const DetectionResult& found,
                           std::size_t told) {
    DetectionResult result = found;
    result.detections = moved(std::move(result.detections), input.X_CK);
    result.boxes = moved(std::move(result.boxes), input.X_CK);
    result.bodies = moved(std::move(result.bodies), input.X_CK);
    const io::RunInfo whole = with_warnings(with_warnings(info, input.warnings), result.warnings);
    io::Json object = io::detect_json(views.info, whole, result);
    if (!views.corrections.empty()) object["views"] = views.corrections;
    json.write(object);
    if (!json.owns_stdout()) {
      print(detection_table(views.info, result, Paint::of_stdout()));
    }
    // Those about the views, which come first, have been printed with their names.
    result.warnings.erase(result.warnings.begin(),
                          result.warnings.begin() + static_cast<std::ptrdiff_t>(told));
    print_warnings(input.info.input, result.warnings);
    if (!pictures.wanted()) return;
    arguments.picture.write(pictures.next(path), {input.info.input, input.cloud, found});
  };
  const auto detect_and_put_out = [&](const std::string& path, InputCloud input) {
    std::vector<std::string> warnings;
    const RobotShapes robot = joined(moved(arguments.robot, input.X_CK.inverse()), input.robot);
    SceneViews views = all_views(arguments.views, input, robot, setup.options,
                                 arguments.input.frames.unit, &warnings);
    DetectionResult result = scene.lasts() ? scene.detect(&input, path, robot, nullptr)
                                           : detect_views(views.clouds(), setup.options);
    views.info.viewpoint = input.X_CK * input.cloud.viewpoint;
    result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
    // The tracks of a numbered cloud begin with the clouds before it.
    tracking.add_to(input, path, &result);
    if (!input.asked) return;
    std::erase_if(result.detections, [](const Detection& d) { return !is_reported(d); });
    std::erase_if(result.boxes, [](const Box& box) { return !is_reported(box); });
    put_out(path, input, views, result, warnings.size());
    if (report.wanted()) report.add(input, view::scene_of_result(input.cloud, result, input.X_CK));
  };
  InputArguments selection = arguments.input;
  selection.track = setup.track;
  const ReadingResult read = for_each_input(arguments.inputs, selection, detect_and_put_out);
  if (read.gave_anything()) json.finish();
  if (read.gave_anything()) report.finish(read.failed);
  read.check();
}

}  // namespace

void add_detect_command(CLI::App& app) {
  auto arguments = std::make_shared<DetectArguments>();
  CLI::App* command = app.add_subcommand("detect", "Find the quadrics of point clouds");
  command->add_option("INPUT", arguments->inputs, kInputs)->required();
  command->add_option("--json", arguments->json, "Write JSON, an object a line; - is stdout")
      ->type_name("FILE|-");
  command->add_flag("--track", arguments->track,
                    "Take files for successive views of a camera at rest; logs always are");
  arguments->views.add_to(*command);
  arguments->input.add_to(*command);
  command->get_option("--scene")->excludes("--view");
  add_robot_option(*command, arguments->robot, "the frame of the results");
  arguments->picture.add_to(*command, "the cloud and the quadrics");
  add_report_option(*command, arguments->report, "the clouds and the quadrics");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
