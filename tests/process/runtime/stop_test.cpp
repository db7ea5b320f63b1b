// A process ends soon after it was told to, whatever it is at.
#include "run/stop.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>

#include "log/event_log.hpp"
#include "process/runtime/run.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

constexpr int kEndsItself = 3;

/// Each message on IN makes it write one on OUT; the third such job goes on for a minute.
class SleepyNode : public Node {
 public:
  explicit SleepyNode(bus::Publish publish) : publish_(std::move(publish)) {}

  std::vector<InChannel> in_channels() const override { return {{"--in", "IN"}}; }
  std::optional<Job> receive(const std::string&, std::span<const std::byte>) override {
    return Job{0, [this, number = ++received_] { work(number); }};
  }
  std::string publish_status(const RunState&) override {
    publish_("STATUS", kByte);
    // On the bus nobody else sends.
    if (received_ < 3) publish_("IN", kByte);
    return {};
  }
  std::string summary() const override { return ""; }

 private:
  void work(int number) {
    publish_("OUT", kByte);
    if (number != 3) return;
    kill(getpid(), SIGTERM);
    std::this_thread::sleep_for(std::chrono::minutes(1));
  }

  static inline const std::vector<std::byte> kByte{std::byte{1}};
  const bus::Publish publish_;
  std::atomic<int> received_{0};
};

/// How a process of its own ends that runs the node, and after how many seconds.
struct End {
  int status = -1;
  double seconds = 0.0;
};

/// @param said  file for what it logs
End run_in_child(const std::string& said, const std::function<void(const NodeMaker&)>& run) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    // Tests log to the standard output. Without a buffer nothing is lost at a sudden end.
    if (std::freopen(said.c_str(), "w", stdout) == nullptr) std::_Exit(kEndsItself);
    std::setvbuf(stdout, nullptr, _IONBF, 0);
    std::fclose(stderr);
    bus::install_stop_signals();
    try {
      run([](bus::Publish publish) { return std::make_unique<SleepyNode>(std::move(publish)); });
    } catch (const std::exception&) {
    }
    std::_Exit(kEndsItself);
  }
  End end;
  waitpid(child, &end.status, 0);
  end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return end;
}

// The signal comes at once in replay, and on the bus with the third status, after two seconds; then
// it is a second to the end. The rest is for busy machines.
constexpr double kMaxSeconds = 8.0;

}  // namespace

TEST_CASE("on the bus a job without end is given up when the process is stopped",
          "[process][fork]") {
  const test::TempFolder folder;
  const End end = run_in_child(folder.path("said"), [](const NodeMaker& make_node) {
    ProcessArguments arguments;
    arguments.lcm_url = "memq://";
    run_on_bus(arguments, make_node);
  });
  REQUIRE(WIFEXITED(end.status));
  CHECK(WEXITSTATUS(end.status) == 0);
  CHECK(end.seconds < kMaxSeconds);
}

TEST_CASE("a replay that is stopped in a job without end keeps what came before",
          "[process][log][fork]") {
  const test::TempFolder folder;
  ProcessArguments arguments;
  arguments.in_log = folder.path("in.lcm");
  arguments.out_log = folder.path("out.lcm");
  {
    bus::LogWriter log(arguments.in_log);
    for (int n = 1; n <= 6; ++n) log.write(n, "IN", std::vector<std::byte>(100));
    log.flush();
  }
  const End end = run_in_child(
      folder.path("said"), [&](const NodeMaker& make_node) { run_on_log(arguments, make_node); });
  REQUIRE(WIFEXITED(end.status));
  CHECK(WEXITSTATUS(end.status) == 1);
  CHECK(end.seconds < kMaxSeconds);
  std::ifstream file(folder.path("said"));
  const std::string said{std::istreambuf_iterator<char>(file), {}};
  CHECK(said.find("stopped before the end of the log, after 2 of 6 events") != std::string::npos);
  bus::LogReader log(arguments.out_log);
  int answers = 0;
  while (const auto event = log.next()) answers += event->channel == "OUT";
  CHECK(answers == 3);
}

}  // namespace quadrille
