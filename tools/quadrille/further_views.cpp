#include "quadrille/further_views.hpp"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/output.hpp"
#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/inputs.hpp"

namespace quadrille {
namespace {

/// A view that is given twice, or is the input itself, adds nothing, and was probably meant to be
/// another file.
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

/// Returns what to say if a view names another frame than the input; empty if it does not.
std::string warning_of_frames(const std::string& input, const std::string& view) {
  if (input.empty() || view.empty() || input == view) return "";
  return "is in frame '" + printable(view) + "', and the input in '" + printable(input) +
         "'; all views must be in one frame, so transform this one";
}

}  // namespace

void ViewArguments::add_to(CLI::App& command) {
  command
      .add_option("--view", paths,
                  "More views of the same scene at rest, in its frame, each with its viewpoint")
      ->type_name("CLOUD");
}

void ViewArguments::check(const std::vector<std::string>& inputs) const {
  if (paths.empty()) return;
  if (may_be_several(inputs)) {
    throw CLI::ValidationError("--view",
                               "takes a single INPUT, and of a log one cloud: clouds.lcm#2");
  }
  refuse_same(inputs.front(), paths);
}

SceneViews all_views(const ViewArguments& arguments, const InputCloud& input,
                     const RobotShapes& robot, const DetectorOptions& options, double unit,
                     std::vector<std::string>* warnings) {
  SceneViews views;
  views.info = input.info;
  if (arguments.paths.empty() && robot.shapes.empty()) {
    views.only = &input.cloud;
    return views;
  }
  InputArguments arguments_of_view;
  arguments_of_view.frames.unit = unit;
  const Eigen::Isometry3d X_KC = input.X_CK.inverse();
  views.several.push_back(robot.taken_from(input.cloud));
  for (const std::string& path : arguments.paths) {
    SingleCloud view = read_single_cloud(path, arguments_of_view);
    if (const std::string other = warning_of_frames(input.cloud.frame, view.input.cloud.frame);
        !other.empty()) {
      view.warnings.push_back(other);
    }
    print_warnings(path, view.warnings);
    add_warnings(path, view.warnings, warnings);
    views.info.points_read += view.input.info.points_read;
    views.info.read_ms += view.input.info.read_ms;
    views.several.push_back(robot.taken_from(moved(std::move(view.input.cloud), X_KC)));
  }
  const std::vector<Eigen::Isometry3d> motions = align_views(&views.several, options);
  for (std::size_t v = 1; v < motions.size(); ++v) {
    views.corrections.push_back({{"input", arguments.paths[v - 1]},
                                 {"correction", io::to_json(input.X_CK * motions[v] * X_KC)}});
  }
  return views;
}

}  // namespace quadrille
