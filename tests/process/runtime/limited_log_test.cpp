#include "process/runtime/limited_log.hpp"

#include <stdexcept>

#include "process/logged_lines.hpp"
#include "process/runtime/node.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

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
  const test::LoggedLines log;
  for (int n = 0; n < 3000; ++n) {
    node.work({n, [] { throw std::runtime_error("cannot be encoded"); }});
  }
  const auto seconds = std::chrono::steady_clock::now() - start;
  CHECK(node.failed() == 3000);
  CHECK(log.count() <= 2 + seconds / std::chrono::seconds(1));
  CHECK(log.have("cloud 0: cannot be encoded\n"));
}

TEST_CASE("a record tells how many it stands for, if it does for more", "[process][log]") {
  LimitedLog limited;
  const test::LoggedLines log;
  const LimitedLog::Clock::time_point start;
  for (int n = 0; n < 8; ++n) limited.warning("cut short", start);
  limited.warning("cut short", start + std::chrono::seconds(1));
  limited.warning("cut short", start + std::chrono::seconds(2));
  CHECK(log.count() == 3);
  CHECK(log.have("cut short; 7 more since the last record\n"));
}

}  // namespace quadrille
