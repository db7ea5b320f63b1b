#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json/json.hpp"

namespace quadrille::io {

/// How a result came about, so that its JSON can be understood alone.
struct RunInfo {
  std::uint64_t seed = 0;
  /// Settings that differ from their defaults, by their keys in configuration files.
  Json settings = Json::object();
  /// Name of the gripper; empty if nothing is planned.
  std::string gripper;
  /// Warnings, each a sentence.
  std::vector<std::string> warnings;
};

}  // namespace quadrille::io
