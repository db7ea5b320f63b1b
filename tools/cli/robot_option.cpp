#include "cli/robot_option.hpp"

#include <CLI/CLI.hpp>

#include "io/file_bytes.hpp"
#include "io/json/shapes_file.hpp"

namespace quadrille {

void add_robot_option(CLI::App& app, RobotShapes& robot, const std::string& frame) {
  app.add_option_function<std::string>(
         "--robot",
         [&robot](const std::string& path) {
           try {
             robot = io::read_robot(path);
           } catch (const io::FileError& error) {
             throw CLI::ValidationError("--robot", error.what());
           }
         },
         "Drop the points on these shapes of the robot (JSON, as `plan --json` writes shapes), "
         "in " +
             frame)
      ->type_name("FILE");
}

}  // namespace quadrille
