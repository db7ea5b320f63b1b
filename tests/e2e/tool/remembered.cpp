#include <cstdio>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <stdexcept>

#include "log/event_log.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

struct Counts {
  long plans = 0, grasps = 0;
  /// Hands that were refused because they would pass through unknown space.
  long unknown = 0;
};

Counts count_in(const std::string& path) {
  Counts counts;
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel != "GRASPS") continue;
    grasps_t message;
    const int size = static_cast<int>(event->bytes.size());
    if (message.decode(event->bytes.data(), 0, size) != size) {
      throw std::runtime_error(path + ": a message of grasps cannot be decoded");
    }
    ++counts.plans;
    counts.grasps += message.num_grasps;
    for (const count_t& entry : message.rejected) {
      if (entry.name == "unknown") counts.unknown += static_cast<long>(entry.count);
    }
  }
  return counts;
}

}  // namespace

void check_remembered(const std::string& remembering, const std::string& forgetful) {
  const Counts with = count_in(remembering), without = count_in(forgetful);
  std::printf(
      "%ld plans with %ld grasps, %ld hands refused as unknown; without memory %ld plans, "
      "%ld grasps, %ld refused\n",
      with.plans, with.grasps, with.unknown, without.plans, without.grasps, without.unknown);
  if (with.plans < 2 || with.plans != without.plans) {
    throw std::runtime_error("the logs do not hold plans on the same clouds");
  }
  if (!(without.unknown > 0 && with.unknown < without.unknown)) {
    throw std::runtime_error("what was remembered made no more space known");
  }
}

}  // namespace quadrille::e2e
