#include "process/runtime/respawn.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

using Ms = std::chrono::milliseconds;

TEST_CASE("who has worked is started anew at once, who dies early ever later", "[process]") {
  Backoff backoff;
  CHECK(backoff.next(Ms(5000)) == Ms(0));
  std::vector<std::int64_t> pauses;
  for (int i = 0; i < 12; ++i) pauses.push_back(backoff.next(Ms(10)).count());
  CHECK(pauses ==
        std::vector<std::int64_t>{0, 50, 100, 200, 400, 800, 1600, 3200, 5000, 5000, 5000, 5000});
  CHECK(backoff.next(Ms(1000)) == Ms(0));
  CHECK(backoff.next(Ms(10)) == Ms(0));
}

TEST_CASE("the pause stays bounded however often a process dies", "[process]") {
  Backoff backoff;
  for (int i = 0; i < 1000; ++i) CHECK(backoff.next(Ms(0)) <= Backoff::kMax);
}

}  // namespace
}  // namespace quadrille
