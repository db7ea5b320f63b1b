#include "quadrille/command_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "cli/command_line.hpp"
#include "cli/output.hpp"

namespace quadrille {
namespace {

/// Returns the name of an input without its folders, for titles.
std::string name_of(const std::string& input) {
  return std::filesystem::path(input).filename().string();
}

std::string title_of(const std::vector<std::string>& inputs) {
  if (inputs.size() == 1) return name_of(inputs.front());
  return fmt::format("{} and {} more", name_of(inputs.front()), inputs.size() - 1);
}

}  // namespace

CommandReport::CommandReport(const std::string& path, const std::vector<std::string>& inputs,
                             const io::Config& settings)
    : path_(path), several_(may_be_several(inputs)) {
  if (path.empty()) return;
  file_.emplace(path, title_of(inputs), command_line(), io::to_toml(settings));
}

void CommandReport::add(const InputCloud& input, view::Scene scene) {
  scene.name = name_of(input.info.input);
  scene.utime = input.utime;
  scene.warnings.insert(scene.warnings.begin(), input.warnings.begin(), input.warnings.end());
  file_->report().add_scene(scene, several_);
}

void CommandReport::finish(std::size_t failed) {
  if (!file_) return;
  if (failed > 0) {
    file_->report().add_note(fmt::format("{} more inputs could not be read", failed));
  }
  const std::string left_out = file_->report().left_out();
  if (!left_out.empty()) print_warnings(path_, {left_out});
  file_->finish();
}

}  // namespace quadrille
