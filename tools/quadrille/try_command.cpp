#include "quadrille/try_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/detector_arguments.hpp"
#include "cli/output.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "cli/progress_line.hpp"
#include "cli/report_option.hpp"
#include "io/file_bytes.hpp"
#include "io/planner/config.hpp"
#include "lab/physics/attempts.hpp"
#include "lab/physics/plan_file.hpp"
#include "quadrille/command_report.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/try_table.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille {
namespace {

struct TryArguments {
  std::vector<std::string> inputs;
  std::string json, report;
  bool exact = false, only_first = false;
  DetectorArguments detector;
  PlannerArguments planner;
  physics::TrialOptions trial;
};

/// The settings that are the same for all inputs.
struct Job {
  Gripper gripper;
  DetectorOptions detector;
  PlanOptions plan;
  /// All settings, including those of the command line.
  io::Config config;
};

Job job_of(const TryArguments& arguments) {
  const Gripper gripper = arguments.planner.gripper();
  io::Config config = io::load_config(arguments.detector.config);
  const DetectorSetup setup = arguments.detector.overrule_for_planning(config);
  config.detector = setup.options;
  config.planner = arguments.planner.overrule(config.planner, arguments.detector.threads);
  return {gripper, config.detector, config.planner, config};
}

/// A plan to be tried, and the detections on which it was made.
struct Planned {
  InputCloud input;
  /// The detections; those of a plan from a file have only id and quadric.
  std::vector<Detection> detections;
  std::vector<SceneBody> bodies;
  GraspPlan plan;
};

Planned plan_on(const std::string& path, const physics::TrueScene& truth,
                const TryArguments& arguments, const Job& job) {
  auto [input, warnings] = read_single_cloud(path);
  print_warnings(path, warnings);
  std::vector<Detection> detections = truth.detections;
  std::optional<std::vector<Box>> boxes;
  std::vector<SceneBody> bodies;
  if (!arguments.exact) {
    DetectionResult found = detect(input.cloud, job.detector);
    detections = std::move(found.detections);
    boxes = std::move(found.boxes);
    bodies = std::move(found.bodies);
  }
  GraspPlan plan =
      plan_grasps(input.cloud, detections, job.gripper, job.plan, {}, {}, std::move(boxes), bodies);
  return {std::move(input), std::move(detections), std::move(bodies), std::move(plan)};
}

/// Returns the outcome of each grasp; empty for those that were not tried.
std::vector<std::string> outcomes_of(const std::vector<Grasp>& grasps,
                                     const std::vector<physics::Attempt>& attempts,
                                     bool only_first) {
  std::vector<std::string> outcomes;
  std::set<int> seen;
  auto attempt = attempts.begin();
  for (const Grasp& grasp : grasps) {
    const bool tried = seen.insert(grasp.target).second || !only_first;
    outcomes.push_back(tried && attempt != attempts.end() ? to_string((attempt++)->outcome) : "");
  }
  return outcomes;
}

void report_on(const Planned& planned, bool from_file, std::vector<std::string> outcomes,
               const Job& job, CommandReport* report) {
  const PointCloud& cloud = planned.input.cloud;
  DetectionResult found;
  found.boxes = planned.plan.boxes;
  if (!from_file) found.detections = planned.detections;
  const auto still = Eigen::Isometry3d::Identity();
  view::Scene scene = view::scene_of_result(cloud, found, still);
  scene.outcomes = std::move(outcomes);
  view::add_plan(
      GraspScene(cloud, found.detections, job.gripper, job.plan, {}, found.boxes, planned.bodies),
      {}, planned.plan, job.gripper, job.plan.unknown, still, {}, &scene);
  report->add(planned.input, std::move(scene));
}

std::vector<physics::Attempt> attempts_on(const std::string& input, const TryArguments& arguments,
                                          const Job& job, CommandReport* report) {
  physics::TrueScene truth;
  Planned planned;
  const bool from_file = input.ends_with(".json");
  if (from_file) {
    physics::PlanFile file = physics::read_plan(input);
    truth = physics::read_true_scene(file.cloud);
    if (report->wanted()) planned.input = read_single_cloud(file.cloud).input;
    planned.detections = std::move(file.detections);
    planned.plan.grasps = std::move(file.grasps);
  } else {
    truth = physics::read_true_scene(input);
    planned = plan_on(input, truth, arguments, job);
  }
  const std::vector<Grasp>& grasps = planned.plan.grasps;
  ProgressLine line;
  std::vector<physics::Attempt> attempts = physics::try_grasps(
      grasps, physics::seen_quadrics(planned.detections), truth, job.gripper, arguments.trial,
      arguments.only_first, [&](double share) { line.show(share); });
  if (report->wanted()) {
    report_on(planned, from_file, outcomes_of(grasps, attempts, arguments.only_first), job, report);
  }
  return attempts;
}

void run(const TryArguments& arguments) {
  const std::string missing = physics::missing_physics();
  if (!missing.empty()) throw std::runtime_error(missing);
  const Job job = job_of(arguments);
  JsonLines json(arguments.json);
  CommandReport report(arguments.report, arguments.inputs, job.config);
  std::vector<physics::Attempt> all;
  std::size_t failed = 0;
  for (const std::string& input : arguments.inputs) {
    std::vector<physics::Attempt> attempts;
    try {
      attempts = attempts_on(input, arguments, job, &report);
    } catch (const io::FileError& error) {
      if (arguments.inputs.size() == 1) throw;
      // An input that cannot be read must not prevent the others from being processed.
      fmt::print(stderr, "quadrille: {}\n", printable(error.what(), kMaxLine));
      ++failed;
      continue;
    }
    json.write(attempts_json(input, attempts));
    if (!json.owns_stdout()) {
      print(attempt_table(input, attempts, Paint::of_stdout()));
    }
    all.insert(all.end(), attempts.begin(), attempts.end());
  }
  if (failed < arguments.inputs.size()) {
    json.finish();
    if (!json.owns_stdout()) print(attempt_summary(all));
    if (report.wanted()) report.add_table(attempt_summary_table(all));
    report.finish(failed);
  }
  if (failed > 0) {
    throw std::runtime_error(
        fmt::format("{} of {} inputs could not be tried", failed, arguments.inputs.size()));
  }
}

std::string check_input(const std::string& path) {
  if (path.ends_with(".ply") || path.ends_with(".json")) return "";
  return "'" + path + "' is neither a .ply cloud with its truth nor a plan in .json";
}

}  // namespace

void add_try_command(CLI::App& app) {
  auto arguments = std::make_shared<TryArguments>();
  CLI::App* command =
      app.add_subcommand("try", "Try planned grasps on the true objects of generated scenes");
  command
      ->add_option("INPUT", arguments->inputs,
                   "Clouds of quadrille scene (.ply) to plan on, or plans (.json)")
      ->required()
      ->check(CLI::Validator(check_input, ""));
  arguments->planner.add_to(*command, "");
  command->add_flag("--exact", arguments->exact, "Plan on the true quadrics, not on detected ones");
  command->add_flag("--first", arguments->only_first, "Only the best grasp of each target");
  command->add_option("--friction", arguments->trial.friction, "Of pads and objects")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command->add_option("--density", arguments->trial.density, "Of objects [kg/m3]")
      ->check(CLI::Range(1.0, 30000.0))
      ->capture_default_str();
  command->add_option("--force", arguments->trial.force, "Closing force [N]; 0: the gripper's own")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_option("--json", arguments->json, "Write JSON; - is stdout")->type_name("FILE|-");
  add_report_option(*command, arguments->report, "the scenes, the grasps and what came of them");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
