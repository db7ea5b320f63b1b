#include "process/runtime/watch/channel_census.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

TEST_CASE("a channel without events is named with those that had some", "[process][log]") {
  ChannelCensus census;
  for (const char* channel : {"CAMERA", "POSE", "CAMERA"}) census.add(channel);
  CHECK(census.find_missing({{"--in-channel", "CAMERA"}}).empty());
  const auto lines = census.find_missing({{"--a", "CAMERA"}, {"--b", "POINT_CLOUD"}});
  CHECK(lines == std::vector<std::string>{"no event on POINT_CLOUD; the log holds CAMERA (2), POSE "
                                          "(1); name the channel with --b"});
}

TEST_CASE("a prefix that is in the way is told", "[process][log]") {
  const auto advice = [](const std::string& held) {
    ChannelCensus census;
    census.add(held);
    return census.find_missing({{"--a", "R2/CLOUD"}}, "R2/").at(0);
  };
  CHECK(advice("CLOUD") ==
        "no event on R2/CLOUD; the log holds CLOUD (1); none begins with R2/: leave out "
        "--channel-prefix");
  CHECK(advice("R2/CAMERA") ==
        "no event on R2/CLOUD; the log holds R2/CAMERA (1); name the channel with --a, without "
        "R2/");
}

TEST_CASE("a channel that has events is told with the option that renames it", "[process][log]") {
  ChannelCensus census;
  for (const char* channel : {"QUADRICS", "CAMERA", "QUADRICS", "STATUS"}) census.add(channel);
  CHECK(census.find_taken({{"--a", "QUADRICS"}, {"--b", "BOXES"}, {"--c", "STATUS"}}) ==
        "QUADRICS (2; --a), STATUS (1; --c)");
  CHECK(census.find_taken({{"--b", "BOXES"}}).empty());
}

TEST_CASE("an empty log is told from a channel that is named wrong", "[process][log]") {
  const auto lines = ChannelCensus().find_missing({{"--a", "A"}});
  CHECK(lines == std::vector<std::string>{"no event on A; the log holds no events at all"});
}

TEST_CASE("names of any bytes are told in one line that a message can hold",
          "[process][log][hostile]") {
  ChannelCensus census;
  census.add(std::string("A\0\n\xff", 4));
  census.add(std::string(900, 'B'));
  const auto lines = census.find_missing({{"--a", "C"}});
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].find("A\\x00\\x0a\\xff (1), BBB") != std::string::npos);
  CHECK(lines[0].size() < 200);
}

TEST_CASE("a log of very many channels gives a line of bounded length", "[process][log]") {
  ChannelCensus census;
  for (int i = 0; i < 100; ++i) census.add("CHANNEL_" + std::to_string(i));
  const auto lines = census.find_missing({{"--a", "A"}});
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].find(" and 88 more; name") != std::string::npos);
}

}  // namespace
}  // namespace quadrille
