#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "log/event_log.hpp"
#include "process/runtime/run.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/file_size_limit.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEventBytes = 100000;

/// Answers each event on IN with one as large on OUT.
class EchoNode : public Node {
 public:
  EchoNode(bus::Publish publish, std::function<void()> on_event)
      : publish_(std::move(publish)), on_event_(std::move(on_event)) {}

  std::vector<InChannel> in_channels() const override { return {{"--in", "IN"}}; }
  std::optional<Job> receive(const std::string& channel, std::span<const std::byte>) override {
    if (on_event_) on_event_();
    if (channel != "IN") return std::nullopt;
    return Job{0, [this] { publish_("OUT", std::vector<std::byte>(kEventBytes)); }};
  }
  std::string publish_status(const RunState& run) override {
    for (const std::string& warning : run.warnings) {
      publish_("STATUS", std::as_bytes(std::span(warning)));
    }
    return {};
  }
  std::string summary() const override { return ""; }

 private:
  const bus::Publish publish_;
  const std::function<void()> on_event_;
};

/// Answers each event on IN once the log is two microseconds further, and at its end.
class PatientEchoNode : public EchoNode {
 public:
  explicit PatientEchoNode(bus::Publish publish) : EchoNode(std::move(publish), nullptr) {}

  std::optional<Job> receive(const std::string& channel,
                             std::span<const std::byte> bytes) override {
    waiting_.push_back({now_, *EchoNode::receive(channel, bytes)});
    return std::nullopt;
  }
  std::vector<Job> find_due_jobs(Time now) override {
    now_ = now;
    std::vector<Job> jobs;
    while (!waiting_.empty() && now - waiting_.front().first >= Time(2)) {
      jobs.push_back(waiting_.front().second);
      waiting_.pop_front();
    }
    return jobs;
  }

 private:
  Time now_{};
  std::deque<std::pair<Time, Job>> waiting_;
};

/// A log of six large events, and one to write.
class LogFolder {
 public:
  LogFolder() {
    bus::LogWriter log(in());
    for (int n = 1; n <= 6; ++n) log.write(n, "IN", std::vector<std::byte>(kEventBytes));
    log.flush();
  }
  std::string in() const { return folder_.path("in.lcm"); }
  std::string out() const { return folder_.path("out.lcm"); }

  /// What the run throws; empty for nothing.
  std::string error_of_run(bool copy = false, std::function<void()> on_event = nullptr) const {
    ProcessArguments arguments;
    arguments.in_log = in();
    arguments.out_log = out();
    arguments.copy_input = copy;
    return test::error_of([&] {
      run_on_log(arguments, [&](bus::Publish publish) {
        return std::make_unique<EchoNode>(std::move(publish), on_event);
      });
    });
  }

  std::map<std::string, int> written() const {
    std::map<std::string, int> events;
    bus::LogReader log(out());
    while (const auto event = log.next()) ++events[event->channel];
    return events;
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(fs::path(in()).parent_path()), {}));
  }

 private:
  test::TempFolder folder_;
};

}  // namespace

TEST_CASE("a log that is cut short while it is replayed ends the run with an error",
          "[process][log]") {
  const LogFolder logs;
  const std::string error =
      logs.error_of_run(false, [&] { fs::resize_file(logs.in(), 3 * kEventBytes / 2); });
  CHECK(error.find("in.lcm: cut short while it was read: after 1 of 6 events") !=
        std::string::npos);
  CHECK(error.find("out.lcm holds only what came of these") != std::string::npos);
  CHECK(logs.written() == std::map<std::string, int>{{"OUT", 1}, {"STATUS", 1}});
}

TEST_CASE("in a replay the log's own times tell what is due, and its end ends all waiting",
          "[process][log]") {
  const LogFolder logs;
  ProcessArguments arguments;
  arguments.in_log = logs.in();
  arguments.out_log = logs.out();
  arguments.copy_input = true;
  run_on_log(arguments, [&](bus::Publish publish) {
    return std::make_unique<PatientEchoNode>(std::move(publish));
  });
  std::vector<std::pair<std::string, std::int64_t>> events;
  bus::LogReader log(logs.out());
  while (const auto event = log.next()) events.emplace_back(event->channel, event->utime);
  CHECK(events == std::vector<std::pair<std::string, std::int64_t>>{{"IN", 1},
                                                                    {"IN", 2},
                                                                    {"IN", 3},
                                                                    {"OUT", 3},
                                                                    {"IN", 4},
                                                                    {"OUT", 4},
                                                                    {"IN", 5},
                                                                    {"OUT", 5},
                                                                    {"IN", 6},
                                                                    {"OUT", 6},
                                                                    {"OUT", 6},
                                                                    {"OUT", 6}});
}

TEST_CASE("a log that does not fit on the disk leaves nothing under its name", "[process][log]") {
  const bool copy = GENERATE(false, true), was_there = GENERATE(false, true);
  const LogFolder logs;
  if (was_there) REQUIRE(logs.error_of_run().empty());
  const std::size_t files = logs.files();
  {
    const test::FileSizeLimit limit(3 * kEventBytes);
    const std::string error = logs.error_of_run(copy);
    CHECK(error.find(logs.out() + ": cannot be written (File too large)") == 0);
  }
  CHECK(fs::exists(logs.out()) == was_there);
  CHECK(logs.files() == files);
  if (was_there) CHECK(logs.written() == std::map<std::string, int>{{"OUT", 6}});
}

TEST_CASE("all events are copied, whatever bytes the names of their channels have",
          "[process][log]") {
  const LogFolder logs;
  std::map<std::string, int> all = {{"IN", 2}, {"\xff\xfe", 1}, {"A\nB", 1}, {{"A\0B", 3}, 1}};
  {
    bus::LogWriter log(logs.in());
    for (const auto& [name, count] : all) {
      for (int n = 0; n < count; ++n) log.write(1, name, std::vector<std::byte>(5));
    }
  }
  CHECK(logs.error_of_run(true).empty());
  all["OUT"] = 2;
  CHECK(logs.written() == all);
}

}  // namespace quadrille
