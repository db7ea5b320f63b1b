#include "quadrille/command_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "cli/command_line.hpp"

namespace quadrille {
namespace {

/// Without the folders, which concern nobody who gets the page.
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
    : several_(may_be_several(inputs)) {
  if (path.empty()) return;
  file_.emplace(path, title_of(inputs), command_line(), io::to_toml(settings));
}

void CommandReport::add(const InputCloud& input, view::Scene scene) {
  scene.name = name_of(input.info.input);
  scene.utime = input.utime;
  scene.warnings.insert(scene.warnings.begin(), input.warnings.begin(), input.warnings.end());
  file_->report().add_scene(scene, several_);
}

void CommandReport::add_table(view::ReportTable table) {
  file_->report().add_table(std::move(table));
}

void CommandReport::finish() {
  if (file_) file_->finish();
}

}  // namespace quadrille
