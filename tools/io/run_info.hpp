#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json.hpp"

namespace quadrille::io {

/// How a result came about, so that its JSON stands alone.
struct RunInfo {
  std::uint64_t seed = 0;
  /// By their keys in configuration files, those that differ from their defaults.
  Json settings = Json::object();
  /// Name of the hand; empty where none is planned for.
  std::string gripper;
  /// Sentences.
  std::vector<std::string> warnings;
};

}  // namespace quadrille::io
