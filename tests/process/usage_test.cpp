// Options that contradict each other, or that LCM would take and then not work with.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "process/detector/command_line.hpp"
#include "process/planner/command_line.hpp"
#include "support/catch.hpp"
#include "support/environment_variable.hpp"

namespace quadrille {
namespace {

/// What is wrong with a command line; empty if nothing is.
template <class CommandLine>
std::string usage_error(const std::string& arguments) {
  CLI::App app;
  const CommandLine command_line(app);
  try {
    app.parse(arguments);
    command_line.settings();
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "";
}

const auto detector_error = usage_error<DetectorCommandLine>;
const auto planner_error = usage_error<PlannerCommandLine>;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("two kinds of messages on one channel are refused", "[process][usage]") {
  CHECK(holds(detector_error("--in-channel A --out-channel A"),
              "--out-channel: 'A' is the channel of --in-channel too"));
  CHECK(holds(detector_error("--status-channel QUADRICS"), "the channel of --out-channel too"));
  CHECK(holds(detector_error("--in-channel QUADRI.*"), "--out-channel: 'QUADRICS' is"));
  CHECK(holds(planner_error("--grasps-channel QUADRICS"), "the channel of --quadrics-channel too"));
  CHECK(holds(planner_error("--request-channel GRASPS"), "--request-channel: 'GRASPS' is"));
  CHECK(detector_error("--in-channel CAMERA_.* --out-channel Q").empty());
  CHECK(planner_error("--cloud-channel A").empty());
}

TEST_CASE("addresses that reach nobody are refused", "[process][usage]") {
  const std::string udp = "udpm://239.255.76.67:7667?ttl=";
  for (const auto& error_of : {detector_error, planner_error}) {
    CHECK(
        holds(error_of("--lcm-url memq://"), "--lcm-url: LCM address 'memq://': memq reaches no"));
    CHECK(holds(error_of("--lcm-url file://a.lcm"), "--in-log"));
    for (const std::string ttl : {"300", "-1", "256", "one", "", "1x"}) {
      CAPTURE(ttl);
      CHECK(holds(error_of("--lcm-url " + udp + ttl), "ttl = '" + ttl + "' must be 0"));
    }
    for (const std::string ttl : {"0", "1", "255"})
      CHECK(error_of("--lcm-url " + udp + ttl).empty());
  }
  for (const auto& error_of : {detector_error, planner_error}) {
    CHECK(holds(error_of("--lcm-url udpm://10.0.0.1:7667"), "10.0.0.1 is no multicast address"));
    CHECK(holds(error_of("--lcm-url udpm://nowhere"), "'nowhere' must be ADDRESS:PORT"));
    CHECK(holds(error_of("--lcm-url pigeon://"), "LCM has no 'pigeon'"));
    CHECK(holds(error_of("--lcm-url " + udp + "0&recv_buf_size=x"), "recv_buf_size = 'x' must"));
    CHECK(holds(error_of("--lcm-url tcpq:// --accept-from local"), "--accept-from: "));
    CHECK(error_of("--lcm-url udpm://").empty());
  }
  const test::EnvironmentVariable url("LCM_DEFAULT_URL", "memq://");
  CHECK(holds(detector_error(""), "LCM_DEFAULT_URL: LCM address 'memq://'"));
  CHECK(detector_error("--lcm-url tcpq://").empty());
  CHECK(detector_error("--in-log a.lcm --out-log b.lcm").empty());
}

TEST_CASE("a pattern is no camera with a pose", "[process][usage]") {
  CHECK(holds(detector_error("--in-channel C_.* --pose-channel POSE"), "poses are those of one"));
  CHECK(holds(detector_error("--in-channel C_("), "is no regular expression"));
}

TEST_CASE("an empty list of senders does not stand for everyone", "[process][usage]") {
  CLI::App app;
  const DetectorCommandLine command_line(app);
  std::string said;
  try {
    app.parse(std::vector<std::string>{"", "--accept-from"});  // the last one first
  } catch (const CLI::ParseError& error) {
    said = error.what();
  }
  CHECK(holds(said, "names nobody"));
  CHECK(detector_error("--accept-from local").empty());
}

}  // namespace quadrille
