#include "quadrille/bus/replay.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "contains.hpp"
#include "log_files.hpp"

namespace quadrille::bus {
namespace {

namespace fs = std::filesystem;
using test::TemporaryLog;
using test::write_three;

std::vector<std::int64_t> replayed_times(const std::string& path) {
  std::vector<std::int64_t> utimes;
  replay_log(path, [&](const LogReader::Event& event) { utimes.push_back(event.utime); });
  return utimes;
}

TEST_CASE("a replay hands over every event with its own time", "[bus][log]") {
  const TemporaryLog file;
  write_three(file.path());
  int events = 0;
  const LogSurvey survey = replay_log(file.path(), [&](const LogReader::Event& event) {
    ++events;
    CHECK(event.utime == 1000 * events);
    CHECK(event.channel == "A");
    CHECK(event.bytes.size() == 10);
    CHECK(event.bytes.front() == std::byte(events));
  });
  CHECK(events == 3);
  CHECK(survey.events == 3);
}

TEST_CASE("no event is passed over for its channel's name", "[bus][log][hostile]") {
  const TemporaryLog file;
  const std::vector<std::string> names = {"A", "A\nB", "\xff\xfe", std::string("A\0B", 3),
                                          std::string(999, '\x80')};
  {
    LogWriter log(file.path());
    for (const std::string& name : names) log.write(1, name, std::vector<std::byte>(4));
  }
  std::vector<std::string> replayed;
  replay_log(file.path(),
             [&](const LogReader::Event& event) { replayed.push_back(event.channel); });
  CHECK(replayed == names);
}

TEST_CASE("a log that is cut short while it is replayed is told of", "[bus][log][hostile]") {
  const TemporaryLog file;
  {
    // More than is read ahead.
    LogWriter log(file.path());
    for (int i = 1; i <= 3; ++i) log.write(i, "A", std::vector<std::byte>(100000));
  }
  int events = 0;
  const LogSurvey survey = replay_log(file.path(), [&](const LogReader::Event&) {
    ++events;
    fs::resize_file(file.path(), 150000);
  });
  CHECK(events == 1);
  CHECK(survey.events == 3);
  REQUIRE(survey.defect);
  CHECK(*survey.defect == "cut short while it was read: after 1 of 3 events");
}

TEST_CASE("a log cut short is replayed up to the cut", "[bus][log][hostile]") {
  const TemporaryLog file;
  write_three(file.path());
  fs::resize_file(file.path(), 3 * test::kEventBytes - 1);
  CHECK(replayed_times(file.path()) == std::vector<std::int64_t>{1000, 2000});
  fs::resize_file(file.path(), test::kEventBytes - 1);
  CHECK(replayed_times(file.path()).empty());
}

TEST_CASE("nothing comes from an empty log", "[bus][log]") {
  const TemporaryLog file;
  std::ofstream(file.path()).close();
  CHECK(replayed_times(file.path()).empty());
}

TEST_CASE("a replay goes on behind damaged bytes", "[bus][log][hostile]") {
  const TemporaryLog file;
  write_three(file.path());
  std::fstream log(file.path(), std::ios::in | std::ios::out | std::ios::binary);
  // The length of the second event's data.
  log.seekp(static_cast<std::streamoff>(test::kEventBytes + 24));
  log.write("\xff\xff\xff\xff", 4);
  log.close();
  CHECK(replayed_times(file.path()) == std::vector<std::int64_t>{1000, 3000});
}

TEST_CASE("what a handler throws ends a replay", "[bus][log]") {
  const TemporaryLog file;
  write_three(file.path());
  CHECK_THROWS_WITH(
      replay_log(file.path(), [](const LogReader::Event&) { throw std::runtime_error("stop"); }),
      "stop");
}

}  // namespace
}  // namespace quadrille::bus
