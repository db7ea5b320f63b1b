#include "quadrille/view_command.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/detector_arguments.hpp"
#include "cli/frame_arguments.hpp"
#include "cli/output.hpp"
#include "cli/planner/planner_arguments.hpp"
#include "cli/process_arguments.hpp"
#include "io/planner/config.hpp"
#include "io/planner/gripper_file.hpp"
#include "link/url.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/input_arguments.hpp"
#include "quadrille/log_scenes.hpp"
#include "quadrille/remembered_frames.hpp"
#include "run/stop.hpp"
#include "view/http/request_guard.hpp"
#include "view/live/live_backend.hpp"
#include "view/live/scene_frames.hpp"
#include "view/log/log_backend.hpp"
#include "view/scene/scene_of_cloud.hpp"
#include "view/server.hpp"

namespace quadrille {
namespace {

struct ViewArguments {
  std::string in_log, channel;
  ProcessArguments bus;
  view::LiveChannels channels;
  view::ServerOptions server{"127.0.0.1", 8765};
  view::PackLimits limits;
  bool open = false, allow_requests = false;
  DetectorArguments detector;
  PlannerArguments planner;
  FrameArguments frames;
};

view::PlanSetup setup_of(const ViewArguments& arguments) {
  const io::Config config = io::load_config(arguments.detector.config);
  const DetectorSetup detector = arguments.detector.overrule_for_planning(config);
  return {detector.options,
          arguments.planner.overrule(config.planner, arguments.detector.threads),
          arguments.planner.gripper(),
          {},
          {},
          arguments.limits};
}

/// Returns the gripper that messages name: a built-in one, or that of --gripper.
std::optional<Gripper> find_gripper(const Gripper& given, const std::string& name) {
  if (name == given.name) return given;
  const std::vector<std::string> names = io::gripper_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) return std::nullopt;
  return io::load_gripper(name);
}

/// Returns the setup with the choices of the page.
/// @throws std::invalid_argument if there is no such gripper or policy
view::PlanSetup chosen(view::PlanSetup setup, const view::PlanChoice& choice) {
  if (!choice.gripper.empty()) {
    const std::optional<Gripper> gripper = find_gripper(setup.gripper, choice.gripper);
    if (!gripper) throw std::invalid_argument("gripper: there is none of that name");
    setup.gripper = *gripper;
  }
  bool known = choice.unknown.empty();
  for (const auto& [word, policy] : words_of(UnknownPolicy{})) {
    if (choice.unknown != word) continue;
    setup.plan.unknown = policy;
    known = true;
  }
  if (!known) throw std::invalid_argument("unknown: there is no such policy");
  setup.query.min_clearance = choice.min_clearance;
  return setup;
}

/// Returns the names of the built-in grippers and that of --gripper.
std::vector<std::string> known_grippers(const std::string& given) {
  std::vector<std::string> names = io::gripper_names();
  if (std::find(names.begin(), names.end(), given) == names.end()) names.push_back(given);
  return names;
}

/// The inputs of a log whose camera moves.
InputArguments moving_inputs(const ViewArguments& arguments) {
  InputArguments inputs;
  inputs.frames = arguments.frames;
  inputs.channel = arguments.channel;
  inputs.pose_channel = arguments.channels.poses;
  inputs.robot_channel = arguments.channels.robot;
  const io::Config config = io::load_config(arguments.detector.config);
  inputs.track = arguments.detector.overrule_for_planning(config).track;
  return inputs;
}

std::unique_ptr<view::Backend> open_in_log(const ViewArguments& arguments) {
  const view::PlanSetup setup = setup_of(arguments);
  const ChooseSetup choose = [setup](const view::PlanChoice& choice) {
    return chosen(setup, choice);
  };
  const view::MakeScene make_scene =
      arguments.channels.poses.empty()
          ? scenes_alone(arguments.frames, choose)
          : scenes_in_memory({arguments.in_log, moving_inputs(arguments), setup.detector}, choose);
  view::LogFrames frames(arguments.in_log, arguments.channel, arguments.frames.unit,
                         arguments.channels.robot);
  std::vector<std::string> warnings;
  if (frames.defect()) warnings.push_back(*frames.defect());
  if (auto refused = frames.robot_refusals().warning(arguments.channels.robot)) {
    warnings.push_back(*std::move(refused));
  }
  print_warnings(arguments.in_log, warnings);
  return std::make_unique<view::LogBackend>(std::move(frames), known_grippers(setup.gripper.name),
                                            make_scene, arguments.limits);
}

/// Yields to the processes of the robot if the processor is busy.
void step_back() {
  constexpr int kNiceness = 10;
  setpriority(PRIO_PROCESS, 0, kNiceness);
}

std::unique_ptr<view::Backend> open_bus(const ViewArguments& arguments) {
  // This must happen before threads are started, since they inherit the priority.
  step_back();
  view::LiveChannels channels = arguments.channels;
  channels.unit = arguments.frames.unit;
  view::LiveChannels::visit_inputs(
      channels, [&](std::string& channel) { channel = arguments.bus.prefixed(channel); });
  channels.requests = arguments.bus.prefixed(channels.requests);
  const std::string url = bus::resolve_url(arguments.bus.lcm_url);
  bus::check_live(bus::parse_url(url));
  const auto find = [given = arguments.planner.gripper()](const std::string& name) {
    return find_gripper(given, name);
  };
  return std::make_unique<view::LiveBackend>(url, channels, find, arguments.allow_requests,
                                             arguments.limits);
}

/// Opens an address in the user's browser, if there is one.
void open_browser(std::string address) {
  std::string program = "xdg-open";
  char* const line[] = {program.data(), address.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, line, environ) != 0) {
    print_warnings("--open", {"there is no xdg-open here; open the address by hand"});
    return;
  }
  std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

/// Refuses two kinds of messages on one channel.
/// @throws CLI::ValidationError
void check_channels(const view::LiveChannels& channels) {
  check_distinct({{"--cloud-channel", channels.cloud},
                  {"--quadrics-channel", channels.quadrics},
                  {"--boxes-channel", channels.boxes},
                  {"--bodies-channel", channels.bodies},
                  {"--body-tracks-channel", channels.body_tracks},
                  {"--grasps-channel", channels.grasps},
                  {"--occupancy-channel", channels.occupancy},
                  {"--robot-channel", channels.robot},
                  {"--obstacles-channel", channels.obstacles},
                  {"--detector-status", channels.detector_status},
                  {"--planner-status", channels.planner_status},
                  {"--request-channel", channels.requests},
                  {"--pose-channel", channels.poses}});
}

void run(const ViewArguments& arguments) {
  check_channels(arguments.channels);
  const std::unique_ptr<view::Backend> backend =
      arguments.in_log.empty() ? open_bus(arguments) : open_in_log(arguments);
  bus::install_stop_signals();
  const view::Server server(*backend, arguments.server);
  if (!view::is_loopback(arguments.server.bind_address)) {
    print_warnings("--bind",
                   {arguments.allow_requests
                        ? "all who reach this machine can look at the clouds, and ask the "
                          "planner"
                        : "all who reach this machine can look at the clouds"});
  }
  print(fmt::format("quadrille view: {} (Ctrl-C ends it)\n", server.address()));
  if (arguments.open) open_browser(server.address());
  while (!bus::stop_requested()) {
    backend->check();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

/// Refuses a cloud file, which is not a log but can be made into one.
std::string check_log(const std::string& path) {
  const std::string suffix = CLI::detail::to_lower(std::filesystem::path(path).extension());
  const std::set<std::string> clouds = {".ply", ".pcd", ".xyz", ".txt", ".npy", ".npz", ".gz"};
  if (!clouds.contains(suffix)) return "";
  return fmt::format("'{0}' is a cloud, not a log; make one with: quadrille log clouds.lcm {0}",
                     path);
}

/// Adds the options for a camera that moves, which are those of the processes.
void add_pose_options(CLI::App& command, view::LiveChannels& channels) {
  add_channel_option(command, "--pose-channel", channels.poses,
                     "camera's poses in the fixed frame, of type bot_core.pose_t");
  command
      .add_option_function<std::string>(
          "--cloud-frame",
          [&channels](const std::string& name) {
            channels.cloud_in_world = name == view::kWorldFrame;
          },
          "Frame of the clouds: the camera's, or the fixed frame of its poses")
      ->check(CLI::IsMember({view::kCameraFrame, view::kWorldFrame}))
      ->default_str(view::kCameraFrame)
      ->needs("--pose-channel")
      ->excludes("--in-log");
}

}  // namespace

void add_view_command(CLI::App& app) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command = app.add_subcommand("view", "Show clouds, quadrics and grasps in the browser");
  command
      ->add_option("--in-log,log", arguments->in_log,
                   "LCM log whose clouds to work on and show; else what comes over LCM")
      ->type_name("LOG")
      ->check(CLI::Validator(check_log, ""));
  command->add_option("--port", arguments->server.port, "Port to listen on; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--bind", arguments->server.bind_address, "Address to listen on")
      ->type_name("ADDRESS")
      ->capture_default_str();
  command->add_flag("--open", arguments->open, "Open the page in the browser");
  command
      ->add_flag("--allow-requests", arguments->allow_requests,
                 "Let the page ask the planner for grasps on an object")
      ->excludes("--in-log");
  command->add_option("--max-points", arguments->limits.points, "Points of a cloud to show")
      ->check(CLI::Range(1000, 1000000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("-l,--lcm-url", arguments->bus.lcm_url, "LCM address; else LCM_DEFAULT_URL")
      ->excludes("--in-log");
  command
      ->add_option("--channel-prefix", arguments->bus.channel_prefix,
                   "Begins the names of all channels")
      ->type_name("NAME");
  view::LiveChannels& channels = arguments->channels;
  add_channel_option(*command, "--cloud-channel", channels.cloud, "clouds");
  add_channel_option(*command, "--quadrics-channel", channels.quadrics, "quadrics");
  add_channel_option(*command, "--boxes-channel", channels.boxes, "boxes");
  add_channel_option(*command, "--bodies-channel", channels.bodies, "bodies");
  add_channel_option(*command, "--body-tracks-channel", channels.body_tracks, "tracks of bodies");
  add_channel_option(*command, "--grasps-channel", channels.grasps, "grasps");
  add_channel_option(*command, "--occupancy-channel", channels.occupancy, "occupancy");
  add_channel_option(*command, "--robot-channel", channels.robot, "robot's own shapes");
  add_channel_option(*command, "--obstacles-channel", channels.obstacles, "obstacles");
  add_pose_options(*command, channels);
  add_channel_option(*command, "--detector-status", channels.detector_status, "detector's status");
  add_channel_option(*command, "--planner-status", channels.planner_status, "planner's status");
  add_channel_option(*command, "--request-channel", channels.requests, "requests");
  arguments->planner.add_to(*command, "franka");
  add_channel_option(*command, "--channel", arguments->channel,
                     "clouds, of a log that has several");
  arguments->frames.add_to(*command);
  for (const char* rival : {"--viewpoint", "--camera-pose"}) {
    command->get_option("--pose-channel")->excludes(command->get_option(rival));
  }
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
