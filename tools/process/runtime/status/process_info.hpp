#pragma once

#include <Eigen/Geometry>
#include <lcmtypes/quadrille/process_t.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/process_arguments.hpp"
#include "io/settings/setting_text.hpp"
#include "process/runtime/poses/cloud_frames.hpp"

namespace quadrille {

/// Settings as text, for comparison.
class SettingsText {
 public:
  void add(const std::string& name, const std::string& value) {
    text_ += name + "=" + value + "\n";
  }

  /// Adds all fields that the options' visit() lists.
  template <class Options>
  void add_all(const Options& options) {
    Options::visit(options, [&](const auto& field, const Setting& setting) {
      add(setting.name, io::toml_of(field));
    });
  }

  void add_channels(const std::vector<NamedChannel>& channels);

  /// @param X_WK  pose of a camera at rest, if there is one
  void add_frames(const CloudFrames& frames, const std::optional<Eigen::Isometry3d>& X_WK);

  /// Returns 16 hexadecimal digits, which are the same for equal settings.
  std::string hash() const;

 private:
  std::string text_;
};

/// Describes this process and the resources that it uses now.
/// @param settings  value of SettingsText::hash()
process_t describe_process(const std::string& settings);

}  // namespace quadrille
