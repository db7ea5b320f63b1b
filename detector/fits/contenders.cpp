#include "fits/contenders.hpp"

#include "fits/bayesian_fit.hpp"
#include "fits/compact_fit.hpp"
#include "fits/distance_fit.hpp"
#include "fits/full_fit.hpp"
#include "fits/gradient_one_fit.hpp"
#include "fits/likelihood_fit.hpp"
#include "fits/primal_dual_fit.hpp"
#include "fits/tangent_fit.hpp"
#include "fits/taubin_fit.hpp"
#include "fits/three_level_fit.hpp"
#include "fits/three_point_fit.hpp"
#include "fits/two_point_fit.hpp"
#include "fits/type_constrained_fit.hpp"

namespace quadrille {
namespace {

using Points = const OrientedPointsd&;

Contender primal_dual(std::string_view name, const PrimalDual& kind) {
  return {name,        "paper, figure 2a",
          kind.points, true,
          false,       [kind](Points p) { return fit_primal_dual(p, kind); }};
}

std::optional<Quadric> quadric_of(const std::optional<MinimalFit>& fit) {
  return fit ? std::optional<Quadric>(fit->Q) : std::nullopt;
}

}  // namespace

std::vector<Contender> contenders(QuadricType type) {
  return {
      {"full", "paper, eq. 4", 4, false, false, [](Points p) { return fit_full(p); }},
      {"compact", "paper, eq. 5", 4, false, false, [](Points p) { return fit_compact(p); }},
      {"three_and_one", "paper, theorem 3", 4, true, false,
       [](Points p) { return quadric_of(fit_three_points(p)); }},
      {"two_and_three", "paper, eq. 7", 5, true, false,
       [](Points p) { return quadric_of(fit_two_points(p)); }},
      primal_dual("pd_0", kPrimalDual[0]),
      primal_dual("pd_1", kPrimalDual[1]),
      primal_dual("pd_2", kPrimalDual[2]),
      primal_dual("pd_3", kPrimalDual[3]),
      {"taubin", "Taubin 1991", 9, false, false, [](Points p) { return fit_taubin(p); }},
      {"gradient_one", "Tasdizen et al. 2000", 4, false, false,
       [](Points p) { return fit_gradient_one(p); }},
      {"three_level", "Blane et al. 2000", 4, false, false,
       [](Points p) { return fit_three_level(p); }},
      {"type_constrained", "Andrews, Sequin 2013", 9, false, false,
       [type](Points p) { return fit_of_type(p, type); }},
      {"bayesian", "Beale et al. 2016", 4, false, false, [](Points p) { return fit_bayesian(p); }},
      {"first_order_distance", "Gauss-Newton", 9, false, false,
       [](Points p) { return fit_first_order_distance(p); }},
      {"orthogonal_distance", "Gauss-Newton", 9, false, false,
       [](Points p) { return fit_orthogonal_distance(p); }},
      {"tangent", "eq. 4 without its scales", 4, false, true,
       [](Points p) { return fit_tangent(p); }},
      {"likelihood", "points and normals", 4, false, true,
       [](Points p) { return fit_likelihood(p); }},
  };
}

const Contender* find_contender(const std::vector<Contender>& contenders, std::string_view name) {
  for (const Contender& contender : contenders) {
    if (contender.name == name) return &contender;
  }
  return nullptr;
}

}  // namespace quadrille
