#include "quadrille/plan_command.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/gripper_file.hpp"
#include "picture/picture.hpp"
#include "picture/png.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector_arguments.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/output.hpp"
#include "quadrille/table.hpp"

namespace quadrille {
namespace {

struct PlanArguments {
  std::string input, gripper, json, picture;
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  DetectorArguments detector;
};

const std::map<std::string, UnknownPolicy>& policies() {
  static const std::map<std::string, UnknownPolicy> map = {
      {"obstacle", UnknownPolicy::kObstacle},
      {"target-shadow", UnknownPolicy::kTargetShadow},
      {"free", UnknownPolicy::kFree}};
  return map;
}

Gripper chosen_gripper(const std::string& name_or_path) {
  try {
    return io::load_gripper(name_or_path);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--gripper", error.what());
  }
}

void run(const PlanArguments& arguments) {
  const DetectorOptions detector_options = arguments.detector.options();
  const Gripper gripper = chosen_gripper(arguments.gripper);
  PlanOptions options;
  options.unknown = arguments.unknown;
  JsonLines json(arguments.json);
  const InputCloud input = read_one_cloud(arguments.input);
  const DetectionResult result = detect(input.cloud, detector_options);
  const GraspPlan plan = plan_grasps(input.cloud, result.detections, gripper, options);
  json.write(io::plan_json(input.info, result, plan));
  if (!json.owns_stdout()) print(detection_table(input.info, result) + grasp_table(plan));
  print_warnings(input.info.input, result.warnings);
  print_warnings(input.info.input, plan.warnings);
  if (arguments.picture.empty()) return;
  write_png(arguments.picture,
            draw_picture({input.info.input, input.cloud, result, &plan, &gripper}));
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Find quadrics and plan grasps on them");
  command->add_option("INPUT", arguments->input, "A cloud: .ply or .pcd")->required();
  command->add_option("--gripper", arguments->gripper, "Built-in name, or a TOML file")
      ->required()
      ->type_name("NAME|FILE");
  command->add_option("--unknown", arguments->unknown, "What unobserved space counts as")
      ->transform(CLI::CheckedTransformer(policies()).description(""))
      ->type_name("obstacle|target-shadow|free");
  command->add_option("--json", arguments->json, "Write JSON; - is stdout")->type_name("FILE|-");
  command
      ->add_option("--picture", arguments->picture, "Draw the cloud, the quadrics and the grasps")
      ->type_name("FILE.png");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
