#include "cli/planner/query_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "cli/number_list.hpp"
#include "io/file_bytes.hpp"
#include "io/json/shapes_file.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {
namespace {

Eigen::Vector3d vector_of(const std::vector<double>& v, std::size_t first = 0) {
  return {v[first], v[first + 1], v[first + 2]};
}

Region region_of(const std::string& list) {
  const std::string form = "MINX,MINY,MINZ,MAXX,MAXY,MAXZ";
  const std::vector<double> v = numbers_of("--roi", list, 6, form);
  const Eigen::AlignedBox3d box(vector_of(v), vector_of(v, 3));
  if (box.isEmpty()) {
    throw CLI::ValidationError(
        "--roi",
        fmt::format("'{}' is empty: give the least corner first, {}", printable(list), form));
  }
  return {Eigen::Isometry3d::Identity(), box};
}

Cone cone_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--approach", list, 4, "X,Y,Z,DEGREES");
  const Eigen::Vector3d axis = vector_of(v);
  if (!(axis.stableNorm() > 0.0)) {
    throw CLI::ValidationError("--approach", fmt::format("'{}' has no direction", printable(list)));
  }
  if (!(v[3] > 0.0 && v[3] <= 180.0)) {
    throw CLI::ValidationError(
        "--approach",
        fmt::format("'{}': the angle must be more than 0 and at most 180", printable(list)));
  }
  return {axis.stableNormalized(), v[3] * std::numbers::pi / 180.0};
}

void add_length(CLI::App& app, const std::string& name, double& length, double max,
                const std::string& what) {
  // This check is needed because CLI::Range lets NaN pass.
  const auto check = [max](const std::string& text) {
    double value = 0.0;
    const bool is_good = CLI::detail::lexical_cast(text, value) && value >= 0.0 && value <= max;
    return is_good ? "" : fmt::format("{} is not between 0 and {:g} m", text, max);
  };
  app.add_option(name, length, what)->type_name("M")->check(check);
}

void add_shapes_option(CLI::App& app, const std::string& name, std::vector<CollisionShape>& shapes,
                       const std::string& what) {
  app.add_option_function<std::string>(
         name,
         [name, &shapes](const std::string& path) {
           try {
             shapes.clear();
             for (const SolidShape& shape : io::read_shapes(path)) {
               shapes.push_back(with_geometry(shape));
             }
           } catch (const io::FileError& error) {
             throw CLI::ValidationError(name, error.what());
           }
         },
         what)
      ->type_name("FILE");
}

}  // namespace

void add_approach_option(CLI::App& app, std::optional<Cone>& cone, const std::string& frame) {
  app.add_option_function<std::string>(
         "--approach", [&cone](const std::string& list) { cone = cone_of(list); },
         "Come along this direction, to within an angle, in " + frame)
      ->type_name("X,Y,Z,DEGREES");
}

void add_obstacles_option(CLI::App& app, std::vector<CollisionShape>& obstacles,
                          const std::string& frame) {
  add_shapes_option(
      app, "--obstacles", obstacles,
      "Keep the hand off these shapes too (JSON, as `plan --json` writes shapes), in " + frame);
}

void add_attached_option(CLI::App& app, std::vector<CollisionShape>& attached) {
  add_shapes_option(app, "--attached", attached,
                    "Shapes fixed to the hand, in its frame G, which must not touch anything "
                    "either: a camera on the wrist, or what the hand holds");
}

void QueryArguments::add_to(CLI::App& app) {
  constexpr double kMaxLength = 100.0;
  app.add_option("--target", query_.ids,
                 "Grasp only these quadrics, boxes or bodies, by their numbers")
      ->type_name("ID,...")
      ->delimiter(',');
  app.add_option("--tracks", query_.tracks,
                 "Grasp only what has these tracks; the clouds of a log are tracked")
      ->type_name("TRACK,...")
      ->delimiter(',');
  app.add_option_function<std::string>(
         "--near",
         [this](const std::string& list) {
           query_.near_C = vector_of(numbers_of("--near", list, 3, "X,Y,Z"));
         },
         "Grasp only what is nearest to this point, in the frame of the results [m]")
      ->type_name("X,Y,Z");
  app.add_option_function<std::string>(
         "--roi", [this](const std::string& list) { query_.region = region_of(list); },
         "Grasp only what has its middle in this box, in the frame of the results [m]")
      ->type_name("MINX,...,MAXZ");
  add_length(app, "--min-size", query_.min_size, kMaxLength,
             "Grasp only what has a longest side of so much at least");
  add_length(app, "--max-size", query_.max_size, kMaxLength,
             "Grasp only what has a longest side of so much at most");
  add_length(app, "--min-clearance", query_.min_clearance, GraspQuery::kMaxMinClearance,
             "Keep the hand so far from all but the target");
  add_approach_option(app, query_.approach, "the frame of the results");
  add_obstacles_option(app, query_.obstacles, "the frame of the results");
  add_attached_option(app, query_.attached);
  app.add_option("--best", query_.max_grasps, "Give so many grasps at most")
      ->type_name("N")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
}

GraspQuery QueryArguments::query() const {
  if (query_.min_size > query_.max_size) {
    throw CLI::ValidationError("--min-size", fmt::format("{:g} is more than --max-size {:g}",
                                                         query_.min_size, query_.max_size));
  }
  return query_;
}

}  // namespace quadrille
