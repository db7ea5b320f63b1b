#include "io/hash.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("hashes are those of XXH3", "[tools]") {
  // What `xxhsum -H3` prints of nothing, and of the letters abc.
  CHECK(io::hash_text("") == "2d06800538d394c2");
  CHECK(io::hash_text("abc") == "78af5f94892f3950");
}
