#include "quadrille/detect_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/detector_arguments.hpp"
#include "picture/picture.hpp"
#include "picture/png.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/inputs.hpp"
#include "quadrille/output.hpp"
#include "quadrille/picture_option.hpp"
#include "quadrille/table.hpp"

namespace quadrille {
namespace {

struct DetectArguments {
  std::vector<std::string> inputs;
  std::string json, picture;
  DetectorArguments detector;
};

void run(const DetectArguments& arguments) {
  const DetectorOptions options = arguments.detector.options();
  const bool several = arguments.inputs.size() > 1 || is_log(arguments.inputs.front());
  PicturePaths pictures(arguments.picture, several);
  JsonLines json(arguments.json);
  for (const std::string& path : arguments.inputs) {
    const auto warnings = for_each_cloud(path, [&](const InputCloud& input) {
      const DetectionResult result = detect(input.cloud, options);
      json.write(io::detect_json(input.info, result));
      if (!json.owns_stdout()) print(detection_table(input.info, result));
      print_warnings(input.info.input, result.warnings);
      if (!pictures.wanted()) return;
      write_png(pictures.next(path), draw_picture({input.info.input, input.cloud, result}));
    });
    print_warnings(path, warnings);
  }
  json.finish();
}

}  // namespace

void add_detect_command(CLI::App& app) {
  auto arguments = std::make_shared<DetectArguments>();
  CLI::App* command = app.add_subcommand("detect", "Find the quadrics of point clouds");
  command->add_option("INPUT", arguments->inputs, "Clouds: .ply, .pcd or an LCM log")->required();
  command->add_option("--json", arguments->json, "Write JSON, an object a line; - is stdout")
      ->type_name("FILE|-");
  add_picture_option(*command, arguments->picture, "the cloud and the quadrics");
  arguments->detector.add_to(*command);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace quadrille
