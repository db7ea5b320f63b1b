#include "body/diagonal_quadric.hpp"

namespace quadrille {

DiagonalQuadric quadric_of(const Body& body) {
  using Profile = Body::Profile;
  DiagonalQuadric q{{1.0 / (body.a * body.a), 1.0 / (body.b * body.b), 0.0}, {0, 0, 0}, -1.0};
  switch (body.profile) {
    case Profile::kLinear:
      q.M.z() = -1.0;
      q.k = 0.0;
      break;
    case Profile::kRoot:
      q.g.z() = -1.0;
      q.k = 0.0;
      break;
    case Profile::kHyperbola:
      q.M.z() = -1.0 / (body.c * body.c);
      break;
    case Profile::kSheet:
      q.M.z() = -1.0 / (body.c * body.c);
      q.k = 1.0;
      break;
    case Profile::kEllipse:
      q.M.z() = 1.0 / (body.c * body.c);
      break;
    default:
      break;
  }
  return q;
}

}  // namespace quadrille
