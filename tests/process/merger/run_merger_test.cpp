#include "process/merger/run_merger.hpp"

#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/tcpq_server.hpp"

namespace quadrille {
namespace {

TEST_CASE("a merger whose server is gone ends, and says so", "[process][shard]") {
  const test::TcpqServer server;
  MergerSettings settings;
  settings.process.lcm_url = server.url();
  // On a busy machine it may want to publish its status before it knows.
  CHECK_THROWS_WITH(run_merger(settings),
                    test::contains("the connection is lost") || test::contains("cannot publish"));
}

}  // namespace
}  // namespace quadrille
