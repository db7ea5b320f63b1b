#include "link/channel_pattern.hpp"

#include <stdexcept>

#include "support/catch.hpp"

namespace quadrille::bus {

TEST_CASE("a name matches itself alone, also with a dot in it", "[bus][channel]") {
  const ChannelPattern name("CAMERA.1");
  CHECK_FALSE(name.is_pattern());
  CHECK(name.matches("CAMERA.1"));
  CHECK_FALSE(name.matches("CAMERA_1"));
  CHECK_FALSE(name.matches("CAMERA.12"));
}

TEST_CASE("a pattern matches whole names", "[bus][channel]") {
  const ChannelPattern pattern("LEFT|RIGHT|CAMERA_[0-9]+");
  CHECK(pattern.is_pattern());
  for (const char* name : {"LEFT", "RIGHT", "CAMERA_12"}) CHECK(pattern.matches(name));
  for (const char* name : {"LEFT_2", "A_RIGHT", "CAMERA_", ""}) CHECK_FALSE(pattern.matches(name));
  CHECK_FALSE(ChannelPattern(".*").matches(std::string(100000, 'A')));
}

TEST_CASE("what is neither a name nor a pattern is refused", "[bus][channel]") {
  for (const std::string wrong : {"", "A B", "CAMERA_(", "[", "*A"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(ChannelPattern(wrong), std::invalid_argument);
  }
  CHECK_THROWS_AS(ChannelPattern(std::string(300, '*')), std::invalid_argument);
  CHECK_THROWS_AS(ChannelPattern(std::string(64, 'A')), std::invalid_argument);
}

TEST_CASE("a text becomes a pattern that matches it alone", "[bus][channel]") {
  for (const std::string text : {"robot.1/", "a+b", "x(y)[z]{2}|^$\\*?"}) {
    const ChannelPattern pattern(pattern_of(text) + "(CLOUD|CLOUDS)");
    CAPTURE(text);
    CHECK(pattern.matches(text + "CLOUD"));
    CHECK(pattern.matches(text + "CLOUDS"));
    CHECK_FALSE(pattern.matches(text));
    CHECK_FALSE(pattern.matches("robotx1/CLOUD"));
  }
}

}  // namespace quadrille::bus
