#include "process/runtime/watch/silent_channels.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("a channel on which nothing comes is told once, after a while, with what to do",
          "[process][channels]") {
  const SilentChannels::TimePoint start{};
  SilentChannels silent({{"--in-channel", "POINT_CLOUD"},
                         {"--quadrics-channel", "QUADRICS"},
                         {"--x", "MAYBE", false}},
                        start);
  silent.hear(1);
  CHECK(silent.find_warnings(start + std::chrono::seconds(9)).empty());
  const std::vector<std::string> lines = silent.find_warnings(start + std::chrono::seconds(11));
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].find("POINT_CLOUD") != std::string::npos);
  CHECK(lines[0].find("--in-channel") != std::string::npos);
  CHECK(lines[0].find("quadrille doctor") != std::string::npos);
  CHECK(silent.find_warnings(start + std::chrono::seconds(60)).empty());
}

TEST_CASE("a channel that was heard is never told", "[process][channels]") {
  const SilentChannels::TimePoint start{};
  SilentChannels silent({{"--in-channel", "POINT_CLOUD"}}, start);
  silent.hear(0);
  CHECK(silent.find_warnings(start + std::chrono::hours(1)).empty());
}
