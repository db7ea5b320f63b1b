#include "quadrille/further_views.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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

double count_finite(const PointCloud& cloud) {
  return static_cast<double>(std::count_if(cloud.points.begin(), cloud.points.end(),
                                           [](const Eigen::Vector3f& p) { return p.allFinite(); }));
}

// Largest share of a view's points that may lie where another view looks through. With poses that
// are right to 1.5 mm and 0.15 degrees it is up to .06 in simulated stereo kitchens. A view that
// could not be brought onto the others, as all of these could, has no excuse for so many.
constexpr double kMostSeenThrough = 0.1, kMostOfUnaligned = 0.01;

/// Returns what to say of a view that does not fit the others; empty if it does.
/// @param through  share of its points that lie where another view looks through
/// @param aligned  false if it could not be brought onto the others
std::string misfit_of(double through, bool aligned) {
  if (through <= (aligned ? kMostSeenThrough : kMostOfUnaligned)) return "";
  return fmt::format(
      "{:.0f} % of its points lie where another view looks through, so these views do not fit; "
      "check that all are in one frame, and where their sensors stood",
      100.0 * through);
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
  std::vector<double> before;
  for (const PointCloud& cloud : views.several) before.push_back(count_finite(cloud));
  const std::vector<Eigen::Isometry3d> motions = align_views(&views.several, options);
  for (std::size_t v = 0; v < motions.size(); ++v) {
    const double left = count_finite(views.several[v]);
    const bool aligned = v == 0 || !motions[v].matrix().isIdentity(0.0);
    const std::string misfit = misfit_of(before[v] > 0.0 ? 1.0 - left / before[v] : 0.0, aligned);
    if (misfit.empty()) continue;
    const std::string& path = v == 0 ? input.info.input : arguments.paths[v - 1];
    print_warnings(path, {misfit});
    add_warnings(path, {misfit}, warnings);
  }
  for (std::size_t v = 1; v < motions.size(); ++v) {
    views.corrections.push_back({{"input", arguments.paths[v - 1]},
                                 {"correction", io::to_json(input.X_CK * motions[v] * X_KC)}});
  }
  return views;
}

}  // namespace quadrille
