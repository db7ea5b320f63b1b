#include "doctor/advise_channel.hpp"

#include <fmt/format.h>

namespace quadrille::doctor {

std::string advise_channel(const std::string& detector_option, const std::string& planner_option,
                           const std::string& channel, const std::string& prefix) {
  const bool begins = !prefix.empty() && channel.starts_with(prefix);
  std::string advice =
      fmt::format("quadrille-detector {0} {2}, quadrille-grasp-planner {1} {2}", detector_option,
                  planner_option, begins ? channel.substr(prefix.size()) : channel);
  if (prefix.empty()) return advice;
  return fmt::format("{}, {} --channel-prefix {}", advice, begins ? "with" : "without", prefix);
}

}  // namespace quadrille::doctor
