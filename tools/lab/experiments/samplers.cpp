#include "lab/experiments/samplers.hpp"

#include <array>
#include <cmath>

#include "fits/compact_fit.hpp"
#include "fits/taubin_fit.hpp"
#include "search/vote.hpp"
#include "variants/gradient_scales.hpp"
#include "variants/web_vote.hpp"

namespace quadrille::experiments {
namespace {

// Least distance of voters, and of a fourth point, from the plane of the three basis points.
constexpr double kMinHeight = 0.1;

OrientedPointsd random_tuple(const Neighbourhood& from, int count, RandomStream& random) {
  OrientedPointsd tuple(count);
  for (int i = 0; i < count; ++i) {
    const int k = random.below(static_cast<int>(from.points.size()));
    tuple.points.col(i) = from.points.points.col(k);
    tuple.normals.col(i) = from.points.normals.col(k);
  }
  return tuple;
}

VoteOptions vote_options() {
  VoteOptions options;
  options.min_height = kMinHeight;
  options.min_cosine = kSamplerCosine;
  return options;
}

/// How bases of three points become pencils.
struct Three {
  bool solve_lengths;
  bool check;
};

void vote_with_three(const Neighbourhood& from, const OrientedPointsf& voters, const Three& way,
                     RandomStream& random, std::vector<Quadric>* hypotheses) {
  std::array<OrientedPoint, 3> basis;
  for (OrientedPoint& point : basis) {
    point = from.points.at(random.below(static_cast<int>(from.points.size())));
  }
  const auto pencil =
      way.solve_lengths ? make_scaled_pencil(basis, kScaleSoftness) : make_pencil(basis);
  if (!pencil || (way.check && inconsistency(basis) > kMaxInconsistency)) return;
  for (const VotePeak& peak : vote(*pencil, voters, vote_options())) {
    hypotheses->emplace_back(pencil->at(peak.lambda));
  }
}

void vote_with_two(const Neighbourhood& from, const OrientedPointsf& voters, RandomStream& random,
                   std::vector<Quadric>* hypotheses) {
  std::array<OrientedPoint, 2> basis;
  for (OrientedPoint& point : basis) {
    point = from.points.at(random.below(static_cast<int>(from.points.size())));
  }
  const auto web = make_web(basis, kNormalNoise);
  if (!web) return;
  for (const WebPeak& peak : vote(*web, voters, vote_options())) {
    hypotheses->emplace_back(web->at(peak.lambda));
  }
}

/// Returns the soft pencil's quadric of the first three points that passes through the fourth.
std::optional<Quadric> through_four(const OrientedPointsd& points) {
  const auto pencil =
      make_scaled_pencil({points.at(0), points.at(1), points.at(2)}, kScaleSoftness);
  if (!pencil) return std::nullopt;
  const Eigen::Vector4d x = points.points.col(3).homogeneous();
  const double z = pencil->plane.dot(x);
  if (!(std::abs(z) > kMinHeight)) return std::nullopt;
  return Quadric(pencil->at(-x.dot(pencil->Q0 * x) / (z * z)));
}

template <class Fit>
Sampler tuple_sampler(const std::string& name, int count, Fit fit) {
  return {name, [count, fit](const Neighbourhood& from, const OrientedPointsf&,
                             RandomStream& random, std::vector<Quadric>* hypotheses) {
            const auto Q = fit(random_tuple(from, count, random));
            if (Q) hypotheses->push_back(*Q);
          }};
}

}  // namespace

std::vector<Sampler> all_samplers() {
  using P = const OrientedPointsd&;
  const auto three = [](const Three& way) {
    return [way](const Neighbourhood& from, const OrientedPointsf& voters, RandomStream& random,
                 std::vector<Quadric>* hypotheses) {
      vote_with_three(from, voters, way, random, hypotheses);
    };
  };
  return {
      {kThreeName, three({true, true})},
      {"3 points, vote", three({true, false})},
      {"3 points, common scale, vote, consistency test", three({false, true})},
      {"2 points, vote in 3 dimensions", vote_with_two},
      tuple_sampler("4 points, compact", 4, [](P p) { return fit_compact(p); }),
      tuple_sampler("4 points, closed form", 4, through_four),
      tuple_sampler("9 points, Taubin", 9, [](P p) { return fit_taubin(p); }),
  };
}

}  // namespace quadrille::experiments
