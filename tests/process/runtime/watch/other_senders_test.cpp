#include "process/runtime/watch/other_senders.hpp"

#include <unistd.h>

#include <fstream>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>

#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

template <class Status>
std::vector<std::byte> status_of(const std::string& sender) {
  Status status{};
  status.sender = sender;
  return bus::encode(status);
}

}  // namespace

TEST_CASE("a second process on the channel of the status is told of for as long as it is there",
          "[process][status]") {
  OtherSenders others("robot:1:aa");
  const OtherSenders::Clock::time_point start{};
  others.hear("STATUS", status_of<detector_status_t>("robot:1:aa"), start);
  CHECK(others.find_warnings(start).empty());
  others.hear("STATUS", status_of<detector_status_t>("robot:2:bb"), start);
  const auto warnings = others.find_warnings(start + std::chrono::seconds(3));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("robot:2:bb publishes on STATUS too") == 0);
  CHECK(others.find_warnings(start + std::chrono::seconds(6)).empty());
  others.hear("STATUS", status_of<planner_status_t>("robot:3:cc"), start);
  CHECK_FALSE(others.find_warnings(start).empty());
}

TEST_CASE("what is no status is told of as another process, in one printable line",
          "[process][status][hostile]") {
  OtherSenders others("robot:1:aa");
  const OtherSenders::Clock::time_point now{};
  others.hear("STATUS", std::vector<std::byte>(5), now);
  REQUIRE(others.find_warnings(now).size() == 1);
  CHECK(others.find_warnings(now)[0].find("a process of another kind or version") == 0);
  OtherSenders hostile("robot:1:aa");
  for (int n = 0; n < 1000; ++n) {
    hostile.hear("STATUS", status_of<detector_status_t>("\n\x1b" + std::to_string(n)), now);
  }
  REQUIRE(hostile.find_warnings(now).size() == 1);
  CHECK(hostile.find_warnings(now)[0].find("\\x0a\\x1b0 publishes") == 0);
}

TEST_CASE("every process has a sender of its own", "[process][status]") {
  std::ifstream file("/proc/sys/kernel/hostname");
  std::string host;
  file >> host;
  const std::string start = host + ":" + std::to_string(getpid()) + ":";
  CHECK(own_sender().rfind(start, 0) == 0);
  // Processes of two containers may have one name and number.
  const std::string random = own_sender().substr(start.size());
  CHECK(random.size() == 8);
  CHECK(random.find_first_not_of("0123456789abcdef") == std::string::npos);
}

}  // namespace quadrille
