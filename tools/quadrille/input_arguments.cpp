#include "quadrille/input_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "cli/process_arguments.hpp"
#include "quadrille/log_input.hpp"

namespace quadrille {

void InputArguments::add_to(CLI::App& command) {
  frames.add_for_inputs_to(command);
  add_channel_option(command, "--channel", channel, "clouds, of a log that has several");
  add_channel_option(command, "--pose-channel", pose_channel,
                     "camera's poses, in logs; results are then in the poses' fixed frame");
  add_channel_option(command, "--robot-channel", robot_channel,
                     "robot's own shapes (quadrille.robot_t), in logs");
  for (const char* rival : {"--viewpoint", "--camera-pose"}) {
    command.get_option("--pose-channel")->excludes(command.get_option(rival));
  }
  command.add_flag(
      "--scene", scene,
      "Take all clouds for views of one scene at rest, in the order in which they came");
}

void InputArguments::check(const std::vector<std::string>& paths) const {
  const bool logs = std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
    return log_name_of(path).has_value();
  });
  frames.check(paths.size());
  if (logs) return;
  for (const auto& [option, name] :
       {std::pair("--channel", &channel), std::pair("--pose-channel", &pose_channel)}) {
    if (name->empty()) continue;
    throw CLI::ValidationError(option, "is for LCM logs, and no input is one");
  }
}

InputArguments InputArguments::of_input(std::size_t n) const {
  InputArguments one = *this;
  one.frames = frames.of_input(n);
  return one;
}

}  // namespace quadrille
