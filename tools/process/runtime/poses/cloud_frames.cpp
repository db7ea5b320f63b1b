#include "process/runtime/poses/cloud_frames.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/choice_option.hpp"
#include "cli/unit_option.hpp"

namespace quadrille {

void CloudFrames::add_to(CLI::App& app) {
  Choices<CloudFrame> choices;
  for (const auto& [word, frame] : words_of(CloudFrame{})) choices.emplace_back(word, frame);
  add_choice_option(app, "--cloud-frame", clouds, choices,
                    "Frame of the clouds: the camera's (default), or the fixed one of its poses");
  add_choice_option(app, "--result-frame", results, choices,
                    "Frame of the results; by default that of the clouds");
  add_unit_option(app, unit);
}

void check_poses(const CloudFrames& frames, bool fixed, const std::string& pose_channel,
                 const std::vector<std::string>& channels) {
  if (std::find(channels.begin(), channels.end(), pose_channel) != channels.end()) {
    throw CLI::ValidationError("--pose-channel",
                               "must not be the channel of the clouds or the quadrics");
  }
  if (frames.need_pose() && !fixed && pose_channel.empty()) {
    throw CLI::ValidationError(
        frames.clouds == CloudFrame::kWorld ? "--cloud-frame" : "--result-frame",
        "the fixed frame needs the camera's pose; give --pose-channel or --camera-pose");
  }
}

}  // namespace quadrille
