#include "log/event_log.hpp"

#include <filesystem>
#include <fstream>

#include "contains.hpp"
#include "log_files.hpp"

namespace quadrille::bus {
namespace {

namespace fs = std::filesystem;

TEST_CASE("a log gives back what was written, in order", "[bus][log]") {
  const test::TemporaryLog file;
  test::write_three(file.path());
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
}

TEST_CASE("a log cut short anywhere gives its whole events", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  for (std::uintmax_t size = 1; size < 3 * test::kEventBytes; ++size) {
    test::write_three(file.path());
    fs::resize_file(file.path(), size);
    if (size < test::kEventBytes && size < 4) {
      // Not even the mark of an event.
      CHECK_THROWS_AS(LogReader(file.path()), std::runtime_error);
      continue;
    }
    if (size < 28) continue;
    const auto whole = static_cast<std::int64_t>(size / test::kEventBytes);
    LogReader reader(file.path());
    CHECK(reader.survey().events == whole);
    CHECK(reader.survey().defect.has_value() == (size % test::kEventBytes != 0));
    std::int64_t read = 0;
    while (reader.next()) ++read;
    CHECK(read == whole);
  }
}

TEST_CASE("an empty log has no events", "[bus][log]") {
  const test::TemporaryLog file;
  std::ofstream(file.path()).close();
  CHECK(LogReader(file.path()).survey().events == 0);
}

TEST_CASE("what is no log is refused with its name", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  CHECK_THROWS_WITH(LogReader(file.path()), test::contains("no such file"));
  std::ofstream(file.path()) << "ply\nformat ascii 1.0\nend_header\n";
  CHECK_THROWS_WITH(LogReader(file.path()), test::contains("is not an LCM log"));
  CHECK_THROWS_WITH(LogReader("/"), test::contains("is not a file"));
}

/// Puts bytes into a file at an offset.
void overwrite(const std::string& path, std::uintmax_t offset, const std::string& bytes) {
  std::fstream log(path, std::ios::in | std::ios::out | std::ios::binary);
  log.seekp(static_cast<std::streamoff>(offset));
  log << bytes;
}

using Times = std::vector<std::int64_t>;

/// The times of the events that a log gives.
Times times_of(const std::string& path) {
  Times times;
  for (LogReader log(path); const auto event = log.next();) times.push_back(event->utime);
  return times;
}

std::string defect_of(const std::string& path) {
  return LogReader(path).survey().defect.value_or("");
}

TEST_CASE("absurd lengths in a log are told with their offset, and passed over",
          "[bus][log][hostile]") {
  const test::TemporaryLog file;
  const std::string length = GENERATE(as<std::string>{}, "\x7f\xff\xff\xff", "\xff\xff\xff\xff",
                                      "\x80" + std::string(3, '\0'));
  const std::size_t member = GENERATE(20, 24), event = GENERATE(0, 1, 2);
  test::write_three(file.path());
  overwrite(file.path(), event * test::kEventBytes + member, length);
  Times left = {1000, 2000, 3000};
  left.erase(left.begin() + static_cast<std::ptrdiff_t>(event));
  CHECK(times_of(file.path()) == left);
  const auto defect = LogReader(file.path()).survey().defect;
  REQUIRE(defect);
  CHECK(*defect == "damaged at byte " + std::to_string(event * test::kEventBytes) +
                       ": 39 bytes are no event; all events before and behind are used; copy the "
                       "log again");
}

TEST_CASE("behind each damaged byte of a log its events are found again", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  // The first four bytes are how logs are told from other files.
  for (std::uintmax_t at = 4; at < 3 * test::kEventBytes; ++at) {
    INFO("byte " << at);
    test::write_three(file.path());
    overwrite(file.path(), at, "\x07");
    const std::uintmax_t begin = at / test::kEventBytes * test::kEventBytes, member = at - begin;
    // Numbers, times, names and data may be any bytes; with less data an event is still one.
    const bool in_mark = member < 4, shorter = member == 27;
    const bool longer = member >= 20 && member < 27;
    CHECK(times_of(file.path()).size() == (in_mark || longer ? 2 : 3));
    const std::string defect = defect_of(file.path());
    const bool looks_cut = longer && member >= 23 && begin == 2 * test::kEventBytes;
    const std::string where = std::to_string(begin + (shorter ? 36 : 0)) + ":";
    if (in_mark || longer || shorter) {
      CHECK_THAT(defect,
                 test::contains((looks_cut ? "cut short at byte " : "damaged at byte ") + where));
    } else {
      CHECK(defect.empty());
    }
  }
}

TEST_CASE("foreign bytes between events are passed over, whatever they look like",
          "[bus][log][hostile]") {
  const test::TemporaryLog file;
  test::write_three(file.path());
  const std::string whole = test::content_of(file.path());
  const std::string mark = whole.substr(0, 4), header = whole.substr(0, 28);
  const std::string foreign =
      GENERATE_COPY(std::string(200000, '\0'), mark, mark + mark + "x", header + "A");
  std::ofstream(file.path(), std::ios::binary)
      << whole.substr(0, test::kEventBytes) << foreign << whole.substr(test::kEventBytes);
  CHECK(times_of(file.path()) == Times{1000, 2000, 3000});
  CHECK_THAT(
      defect_of(file.path()),
      test::contains("damaged at byte 39: " + std::to_string(foreign.size()) + " bytes are"));
}

TEST_CASE("an event whose data holds a whole log is one event", "[bus][log]") {
  const test::TemporaryLog file;
  test::write_three(file.path());
  const std::string inner = test::content_of(file.path());
  {
    LogWriter log(file.path());
    for (int i = 1; i <= 2; ++i) log.write(i, "LOGS", std::as_bytes(std::span(inner)));
  }
  CHECK(times_of(file.path()) == Times{1, 2});
}

TEST_CASE("a log that ends in zeros, as after a loss of power, is told as damaged there",
          "[bus][log][hostile]") {
  const test::TemporaryLog file;
  test::write_three(file.path());
  fs::resize_file(file.path(), 3 * test::kEventBytes + GENERATE(5, 27, 28, 5000));
  CHECK(times_of(file.path()) == Times{1000, 2000, 3000});
  CHECK_THAT(defect_of(file.path()), test::contains("damaged at byte 117:"));
}

TEST_CASE("no event is passed over for its channel's name", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  const std::vector<std::string> names = {"A", "A\nB", "\xff\xfe", std::string("A\0B", 3),
                                          std::string(999, '\x80')};
  {
    LogWriter log(file.path());
    for (const std::string& name : names) log.write(1, name, std::vector<std::byte>(4));
  }
  std::vector<std::string> found;
  for (LogReader log(file.path()); const auto event = log.next();) found.push_back(event->channel);
  CHECK(found == names);
}

TEST_CASE("a log that is cut short while it is read is told of", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  {
    // An event is longer than what is read ahead.
    LogWriter log(file.path());
    for (int i = 1; i <= 3; ++i) log.write(i, "A", std::vector<std::byte>(100000));
  }
  LogReader log(file.path());
  CHECK(log.next());
  fs::resize_file(file.path(), 150000);
  CHECK_FALSE(log.next());
  CHECK(log.survey().events == 3);
  CHECK(log.survey().defect == "cut short while it was read: after 1 of 3 events");
}

TEST_CASE("a log is not written over itself", "[bus][log]") {
  const test::TemporaryLog file;
  test::write_three(file.path());
  CHECK_THROWS_AS(check_different_files(file.path(), file.path()), std::runtime_error);
  CHECK_NOTHROW(check_different_files(file.path(), file.path() + "2"));
}

TEST_CASE("a log that cannot be written is an error", "[bus][log]") {
  CHECK_THROWS_AS(LogWriter("/nonexistent/x.lcm"), std::runtime_error);
  const test::TemporaryLog file;
  LogWriter writer(file.path());
  CHECK_THROWS_AS(writer.write(0, "", {}), std::invalid_argument);
}

}  // namespace
}  // namespace quadrille::bus
