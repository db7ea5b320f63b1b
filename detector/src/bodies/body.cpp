#include "quadrille/detector/body.hpp"

#include "quadrille/detector/detection.hpp"

namespace quadrille {

std::string_view to_string(BodyKind kind) {
  switch (kind) {
    case BodyKind::kSingle:
      return "single";
    case BodyKind::kRevolution:
      return "revolution";
    case BodyKind::kBox:
      return "box";
    case BodyKind::kLump:
      break;
  }
  return "lump";
}

std::vector<SceneBody> moved(std::vector<SceneBody> bodies, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return bodies;
  for (SceneBody& body : bodies) body.X_CB = rounded(X_FC * body.X_CB);
  return bodies;
}

}  // namespace quadrille
