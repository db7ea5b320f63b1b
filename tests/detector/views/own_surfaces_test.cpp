#include "views/own_surfaces.hpp"

#include <numeric>

#include "detector/pipe.hpp"
#include "support/catch.hpp"
#include "views/joined_samples.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A candidate on consecutive samples.
Candidate candidate_on(int from, int to) {
  Candidate candidate;
  candidate.region.resize(static_cast<std::size_t>(to - from));
  std::iota(candidate.region.begin(), candidate.region.end(), from);
  return candidate;
}

}  // namespace

TEST_CASE("a view that saw two surfaces tells them apart from a third that runs over both",
          "[views]") {
  const SurfaceSamples one = pipe();
  const std::vector<const SurfaceSamples*> views = {&one, &one};
  const std::vector<int> first_cells = {0, one.size()};
  const SurfaceSamples both = joined_samples(views, first_cells, 0.0);
  const int n = one.size();
  // The first view saw two halves, the second view the whole.
  const std::vector<Candidate> found = {candidate_on(0, n / 2), candidate_on(n / 2, n),
                                        candidate_on(n, 2 * n)};
  const OwnSurfaces own(both, found);
  CHECK(own.tell_apart(candidate_on(0, 2 * n).region));
  // Three fifths of each half are most of it, two fifths of the second half are not.
  CHECK(own.tell_apart(candidate_on(n / 5, n / 2 + 3 * n / 10).region));
  CHECK_FALSE(own.tell_apart(candidate_on(n / 5, n / 2 + n / 5).region));
  CHECK_FALSE(own.tell_apart(candidate_on(0, n / 2).region));
  CHECK_FALSE(own.tell_apart(candidate_on(n, 2 * n).region));
  CHECK_FALSE(OwnSurfaces(both, {}).tell_apart(candidate_on(0, 2 * n).region));
  // Two views that each saw one half do not contradict the whole.
  const OwnSurfaces halves(both, {candidate_on(0, n / 2), candidate_on(n + n / 2, 2 * n)});
  CHECK_FALSE(halves.tell_apart(candidate_on(0, 2 * n).region));
}
