#include "process/runtime/node.hpp"

#include <stdexcept>

#include "support/catch.hpp"

namespace quadrille {
namespace {

class IdleNode : public Node {
 public:
  std::vector<InChannel> in_channels() const override { return {}; }
  std::optional<Job> receive(const std::string&, std::span<const std::byte>) override { return {}; }
  std::string publish_status(const RunState&) override { return {}; }
  std::string summary() const override { return {}; }
};

TEST_CASE("a job that fails is counted, and the next one is done", "[process]") {
  IdleNode node;
  int done = 0;
  node.work({1, [&] { ++done; }});
  CHECK(node.failed() == 0);
  node.work({2, [] { throw std::runtime_error("a failure of the test"); }});
  node.work({3, [&] { ++done; }});
  CHECK(node.failed() == 1);
  CHECK(done == 2);
}

}  // namespace
}  // namespace quadrille
