#include "quadrille/bus/event_log.hpp"

#include <filesystem>
#include <fstream>

#include "contains.hpp"
#include "quadrille/bus/replay.hpp"
#include "samples.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::bus {
namespace {

namespace fs = std::filesystem;

/// A file in a folder of its own that goes with it.
class TemporaryFile {
 public:
  std::string path() const { return folder_.path("x.lcm"); }

 private:
  test::TempFolder folder_;
};

void write_three(const std::string& path) {
  LogWriter writer(path);
  for (int i = 1; i <= 3; ++i) {
    writer.write(1000 * i, "A", std::vector<std::byte>(10, std::byte(i)));
  }
  writer.flush();
}

/// The events of write_three() take as many bytes each.
constexpr std::uintmax_t kEventBytes = 28 + 1 + 10;

int count_replayed(const std::string& path) {
  int events = 0;
  replay_log(path, [&](const std::string&, std::span<const std::byte> bytes) {
    ++events;
    CHECK(bytes.front() == std::byte(events));
  });
  return events;
}

TEST_CASE("a log gives back what was written, in order", "[bus][log]") {
  const TemporaryFile file;
  write_three(file.path());
  LogReader reader(file.path());
  CHECK(reader.survey().events == 3);
  CHECK_FALSE(reader.survey().defect);
  for (int i = 1; i <= 3; ++i) {
    const auto event = reader.next();
    REQUIRE(event);
    CHECK(event->utime == 1000 * i);
    CHECK(event->channel == "A");
    CHECK(event->bytes.size() == 10);
    CHECK(event->bytes[9] == std::byte(i));
  }
  CHECK_FALSE(reader.next());
  CHECK(count_replayed(file.path()) == 3);
}

TEST_CASE("a log cut short anywhere gives its whole events", "[bus][log][hostile]") {
  const TemporaryFile file;
  for (std::uintmax_t size = 1; size < 3 * kEventBytes; ++size) {
    write_three(file.path());
    fs::resize_file(file.path(), size);
    if (size < kEventBytes && size < 4) {
      // Not even the mark of an event.
      CHECK_THROWS_AS(survey_log(file.path()), std::runtime_error);
      continue;
    }
    if (size < 28) continue;
    const auto whole = static_cast<std::int64_t>(size / kEventBytes);
    LogReader reader(file.path());
    CHECK(reader.survey().events == whole);
    CHECK(reader.survey().defect.has_value() == (size % kEventBytes != 0));
    std::int64_t read = 0;
    while (reader.next()) ++read;
    CHECK(read == whole);
    CHECK(count_replayed(file.path()) == whole);
  }
}

TEST_CASE("an empty log has no events", "[bus][log]") {
  const TemporaryFile file;
  std::ofstream(file.path()).close();
  CHECK(survey_log(file.path()).events == 0);
  CHECK(count_replayed(file.path()) == 0);
}

TEST_CASE("what is no log is refused with its name", "[bus][log][hostile]") {
  const TemporaryFile file;
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("no such file"));
  std::ofstream(file.path()) << "ply\nformat ascii 1.0\nend_header\n";
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("is not an LCM log"));
  CHECK_THROWS_WITH(survey_log("/"), test::contains("is not a file"));
}

TEST_CASE("absurd lengths in a log are refused with their offset", "[bus][log][hostile]") {
  const TemporaryFile file;
  const std::size_t member = GENERATE(20, 24);
  const std::int32_t length = GENERATE(0x7fffffff, -1, INT32_MIN);
  write_three(file.path());
  std::vector<std::byte> number(4);
  test::put_int32(number, 0, length);
  std::fstream log(file.path(), std::ios::in | std::ios::out | std::ios::binary);
  log.seekp(static_cast<std::streamoff>(kEventBytes + member));
  log.write(reinterpret_cast<const char*>(number.data()), 4);
  log.close();
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("damaged at byte 39"));
  CHECK_THROWS_AS(replay_log(file.path(), {}), std::runtime_error);
}

TEST_CASE("what a handler throws ends a replay", "[bus][log]") {
  const TemporaryFile file;
  write_three(file.path());
  CHECK_THROWS_WITH(
      replay_log(file.path(), [](const std::string&, auto) { throw std::runtime_error("stop"); }),
      "stop");
}

TEST_CASE("a log is not written over itself", "[bus][log]") {
  const TemporaryFile file;
  write_three(file.path());
  CHECK_THROWS_AS(check_different_files(file.path(), file.path()), std::runtime_error);
  CHECK_NOTHROW(check_different_files(file.path(), file.path() + "2"));
}

TEST_CASE("a log that cannot be written is an error", "[bus][log]") {
  CHECK_THROWS_AS(LogWriter("/nonexistent/x.lcm"), std::runtime_error);
  const TemporaryFile file;
  LogWriter writer(file.path());
  CHECK_THROWS_AS(writer.write(0, "", {}), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::bus
