#include "process/runtime/limited_log.hpp"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "process/runtime/node.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// Returns the records that are logged during a call.
template <class Call>
std::string logged_by(Call&& call) {
  std::ostringstream log;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("", std::make_shared<spdlog::sinks::ostream_sink_mt>(log)));
  call();
  spdlog::set_default_logger(before);
  return log.str();
}

struct IdleNode : Node {
  std::vector<InChannel> in_channels() const override { return {}; }
  std::optional<Job> receive(const std::string&, std::span<const std::byte>) override { return {}; }
  std::string publish_status(const RunState&) override { return {}; }
  std::string summary() const override { return ""; }
};

}  // namespace

TEST_CASE("thousands of clouds that fail give some lines", "[process][log]") {
  IdleNode node;
  const auto start = std::chrono::steady_clock::now();
  const std::string log = logged_by([&] {
    for (int n = 0; n < 3000; ++n) {
      node.work({n, [] { throw std::runtime_error("cannot be encoded"); }});
    }
  });
  const auto seconds = std::chrono::steady_clock::now() - start;
  CHECK(node.failed() == 3000);
  CHECK(std::count(log.begin(), log.end(), '\n') <= 2 + seconds / std::chrono::seconds(1));
  CHECK(log.find("cloud 0: cannot be encoded\n") != std::string::npos);
}

TEST_CASE("a record tells how many it stands for, if it does for more", "[process][log]") {
  LimitedLog log;
  const LimitedLog::Clock::time_point start;
  const std::string text = logged_by([&] {
    for (int n = 0; n < 8; ++n) log.warning("cut short", start);
    log.warning("cut short", start + std::chrono::seconds(1));
    log.warning("cut short", start + std::chrono::seconds(2));
  });
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
  CHECK(text.find("cut short; 7 more since the last record\n") != std::string::npos);
}

}  // namespace quadrille
