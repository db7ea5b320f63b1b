#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>

#include "io/file_bytes.hpp"
#include "process/runtime/status/exposition.hpp"
#include "process/runtime/status/process_info.hpp"
#include "process/runtime/status/rate.hpp"
#include "process/runtime/status/stages.hpp"
#include "process/runtime/status/stats_file.hpp"
#include "process/runtime/watch/sequence_gaps.hpp"
#include "quadrille/detector/options.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

TEST_CASE("what a source counted and never came is missing", "[process][status]") {
  SequenceGaps gaps;
  for (const int seq : {7, 8, 11, 12}) gaps.add("left", seq);
  CHECK(gaps.missing() == 2);
  // Another source has numbers of its own.
  for (const int seq : {100, 101}) gaps.add("right", seq);
  gaps.add("left", 13);
  CHECK(gaps.missing() == 2);
}

TEST_CASE("a source that does not count or begins anew lacks nothing", "[process][status]") {
  SequenceGaps gaps;
  for (const int seq : {0, 0, 0}) gaps.add("still", seq);
  for (const int seq : {500, 1, 2, 3}) gaps.add("restarted", seq);
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  for (const std::int32_t seq : {-kMax - 1, kMax, -kMax - 1}) gaps.add("hostile", seq);
  CHECK(gaps.missing() == 0);
  // Frames without end take no memory, and those that are known go on.
  for (int i = 0; i < 1000; ++i) gaps.add("frame " + std::to_string(i), i);
  gaps.add("restarted", 5);
  CHECK(gaps.missing() == 1);
}

TEST_CASE("a rate is the mean of the last ten seconds", "[process][status]") {
  using std::chrono::seconds;
  Rate rate;
  const Rate::Clock::time_point start;
  CHECK(rate.update(0, start) == 0.0);
  CHECK(rate.update(30, start + seconds(1)) == Approx(30.0));
  for (int s = 2; s <= 20; ++s) rate.update(30 * s, start + seconds(s));
  // Nothing comes any more.
  for (int s = 21; s <= 25; ++s) rate.update(600, start + seconds(s));
  CHECK(rate.update(600, start + seconds(26)) == Approx(12.0));
}

TEST_CASE("equal settings have equal hashes and others do not", "[process][status]") {
  const auto hash_of = [](const DetectorOptions& options) {
    SettingsText text;
    text.add_all(options);
    return text.hash();
  };
  DetectorOptions other;
  other.seed += 1;
  CHECK(hash_of({}) == hash_of({}));
  CHECK(hash_of({}) != hash_of(other));
}

TEST_CASE("a process knows its memory and files", "[process][status]") {
  const process_t before = describe_process("0");
  const std::vector<char> memory(64 << 20, 1);
  std::ifstream one("/dev/null"), two("/dev/null");
  const process_t after = describe_process("0");
  CHECK(after.resident_bytes - before.resident_bytes > (48 << 20));
  CHECK(after.peak_bytes >= after.resident_bytes);
  CHECK(after.open_files == before.open_files + 2);
  CHECK(memory.back() == 1);
}

count_t counted(const std::string& name, std::int64_t count) {
  count_t entry;
  entry.name = name;
  entry.count = count;
  return entry;
}

TEST_CASE("an exposition is what Prometheus reads", "[process][status]") {
  Stages stages({"detect"});
  for (int ms = 1; ms <= 100; ++ms) stages.add("detect", ms);
  CHECK_THROWS_AS(stages.add("dream", 1.0), std::out_of_range);
  Exposition out("quadrille_test", {{"channel", "CAMERA"}});
  out.add_counter("clouds", "Clouds.", 7);
  out.add_counters("refused", "Refused.", {counted("cut \"short\"\n", 3)});
  out.add_stages(stages.to_message());
  out.add_process(describe_process("0"));
  const std::string& text = out.text();
  CHECK(text.find("# TYPE quadrille_test_clouds_total counter\n"
                  "quadrille_test_clouds_total{channel=\"CAMERA\"} 7\n") != std::string::npos);
  CHECK(text.find("_refused_total{channel=\"CAMERA\",reason=\"cut \\\"short\\\"\\n\"} 3\n") !=
        std::string::npos);
  CHECK(text.find("_stage_seconds{channel=\"CAMERA\",stage=\"detect\",quantile=\"0.5\"} 0.05\n") !=
        std::string::npos);
  CHECK(text.find("_stage_seconds_sum{channel=\"CAMERA\",stage=\"detect\"} 5.05\n") !=
        std::string::npos);
  CHECK(text.find("_stage_seconds_count{channel=\"CAMERA\",stage=\"detect\"} 100\n") !=
        std::string::npos);
  // The grammar of the format.
  const std::regex kLine(
      R"(# (HELP [a-z_]+ .+|TYPE [a-z_]+ (counter|gauge|summary))|)"
      R"([a-z_]+(\{[a-z_]+="([^"\\]|\\.)*"(,[a-z_]+="([^"\\]|\\.)*")*\})? [-+.e0-9]+)");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(std::regex_match(line, kLine));
  }
}

TEST_CASE("the file of statistics is always whole and alone", "[process][status]") {
  const test::TempFolder folder;
  const std::string path = folder.path("stats.prom");
  StatsFile file(path);
  file.write("one 1\n");
  std::ifstream kept(path);
  file.write("two 2\n");
  // Who had it open still reads the old one whole: it was replaced, not written over.
  std::string word;
  kept >> word;
  CHECK(word == "one");
  CHECK(test::content_of(path) == "two 2\n");
  const std::filesystem::directory_iterator files(std::filesystem::path(path).parent_path());
  CHECK(std::distance(begin(files), end(files)) == 1);
  CHECK_THROWS_AS(StatsFile("/nonexistent/stats.prom"), io::FileError);
}

TEST_CASE("a file of statistics is that of one process", "[process][status]") {
  const test::TempFolder folder;
  const std::string path = folder.path("stats.prom");
  {
    StatsFile file(path);
    CHECK_THROWS_AS(StatsFile(path), io::FileError);
    // The one that took the first one's place is held too.
    file.write("one 1\n");
    CHECK_THROWS_AS(StatsFile(path), io::FileError);
    CHECK(test::content_of(path) == "one 1\n");
    const StatsFile other(folder.path("other.prom"));
  }
  // Who has ended holds nothing.
  CHECK_NOTHROW(StatsFile(path));
}

}  // namespace
}  // namespace quadrille
