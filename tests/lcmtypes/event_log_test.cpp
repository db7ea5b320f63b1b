#include "quadrille/bus/event_log.hpp"

#include <filesystem>
#include <fstream>

#include "contains.hpp"
#include "log_files.hpp"
#include "samples.hpp"

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
      CHECK_THROWS_AS(survey_log(file.path()), std::runtime_error);
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
  CHECK(survey_log(file.path()).events == 0);
}

TEST_CASE("what is no log is refused with its name", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("no such file"));
  std::ofstream(file.path()) << "ply\nformat ascii 1.0\nend_header\n";
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("is not an LCM log"));
  CHECK_THROWS_WITH(survey_log("/"), test::contains("is not a file"));
}

TEST_CASE("absurd lengths in a log are refused with their offset", "[bus][log][hostile]") {
  const test::TemporaryLog file;
  const std::size_t member = GENERATE(20, 24);
  const std::int32_t length = GENERATE(0x7fffffff, -1, INT32_MIN);
  test::write_three(file.path());
  std::vector<std::byte> number(4);
  test::put_int32(number, 0, length);
  std::fstream log(file.path(), std::ios::in | std::ios::out | std::ios::binary);
  log.seekp(static_cast<std::streamoff>(test::kEventBytes + member));
  log.write(reinterpret_cast<const char*>(number.data()), 4);
  log.close();
  CHECK_THROWS_WITH(survey_log(file.path()), test::contains("damaged at byte 39"));
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
