#include "quadrille/scene_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/choice_option.hpp"
#include "cli/output.hpp"
#include "cli/seed_option.hpp"
#include "io/describe.hpp"
#include "lab/scene/scene.hpp"
#include "lab/scene/scene_files.hpp"

namespace quadrille {
namespace {

struct SceneArguments {
  std::string out;
  scene::SceneOptions options;
  bool labels = false;
};

const Choices<scene::Family>& scene_families() {
  static const Choices<scene::Family> choices = {{"easy", scene::Family::kEasy},
                                                 {"medium", scene::Family::kMedium},
                                                 {"hard", scene::Family::kHard},
                                                 {"tabletop", scene::Family::kTabletop}};
  return choices;
}

void run(const SceneArguments& arguments) {
  const scene::Scene made = scene::make_scene(arguments.options);
  scene::write_scene(arguments.out, made, arguments.labels);
  print(fmt::format("{}: {} points, {}; truth in {}\n", arguments.out, made.view.points.size(),
                    io::count_of(static_cast<std::size_t>(scene::count_quadrics(made)), "quadric"),
                    scene::truth_path(arguments.out)));
}

}  // namespace

void add_scene_command(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments>();
  CLI::App* command = app.add_subcommand("scene", "Render a depth-camera scene with its truth");
  command->add_option("OUT", arguments->out, "The cloud to write (.ply)")
      ->required()
      ->check(CLI::Validator(
          [](const std::string& path) {
            return path.ends_with(".ply") ? std::string() : "'" + path + "' must end in .ply";
          },
          ""));
  add_choice_option(*command, "--family", arguments->options.family, scene_families(),
                    "How hard the scene is");
  add_seed_option(*command, arguments->options.seed, "the scene");
  command->add_flag("--labels", arguments->labels,
                    "Also write the surface and the true normal of each point");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
