#pragma once

#include <lcmtypes/quadrille/stage_t.hpp>
#include <string>
#include <utility>
#include <vector>

#include "run/durations.hpp"

namespace quadrille {

/// Durations of the stages of a process's work.
class Stages {
 public:
  /// @param names  names in the order in which they are reported
  explicit Stages(const std::vector<std::string>& names);

  /// @param ms  a further duration of the stage [ms]
  /// @throws std::out_of_range if there is no such stage
  void add(const std::string& name, double ms);

  std::vector<stage_t> to_message() const;

 private:
  std::vector<std::pair<std::string, bus::Durations>> stages_;
};

}  // namespace quadrille
