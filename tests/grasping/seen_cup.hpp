#pragma once

#include <optional>

#include "body/find_shell.hpp"
#include "grasping/cup.hpp"

namespace quadrille::test {

inline const Eigen::Vector3d kUp = table_detection().X_CQ.linear().col(2);

/// The wall of a cup, if its mouth is found in what the camera sees.
inline std::optional<Shell> shell_of(const Cup& cup, bool inner) {
  const PointCloud cloud = render(cup);
  const Detection d = wall_detection(cup, inner);
  const Body body = make_body(d).value();
  return find_shell(body, seen_from_inside(d, body), cloud, std::vector{DepthView(cloud)}, kUp, {});
}

}  // namespace quadrille::test
