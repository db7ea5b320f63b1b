#include "cli/planner/surroundings_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "cli/number_list.hpp"
#include "io/file_bytes.hpp"
#include "io/planner/octree_file.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

KnownSupport support_of(const std::string& list) {
  const std::vector<double> v = numbers_of("--support", list, 4, "NX,NY,NZ,D");
  const Eigen::Vector3d n(v[0], v[1], v[2]);
  const double norm = n.stableNorm();
  if (!(norm > 0.0)) {
    throw CLI::ValidationError("--support", fmt::format("'{}' has no normal", printable(list)));
  }
  return {n / norm, v[3] / norm};
}

}  // namespace

void add_surroundings_options(CLI::App& app, Surroundings& known, const std::string& frame) {
  app.add_option_function<std::string>(
         "--octomap",
         [&known](const std::string& path) {
           try {
             known.map.tree = io::read_octree(path);
           } catch (const io::FileError& error) {
             throw CLI::ValidationError("--octomap", error.what());
           }
         },
         "Keep the hand off what this map says is occupied, and take what it says is free for free "
         "where no view tells, in " +
             frame)
      ->type_name("FILE.bt|.ot");
  app.add_option_function<std::string>(
         "--support", [&known](const std::string& list) { known.support = support_of(list); },
         "Keep the hand above the plane NX*x + NY*y + NZ*z = D, on which things stand, in " + frame)
      ->type_name("NX,NY,NZ,D");
}

}  // namespace quadrille
