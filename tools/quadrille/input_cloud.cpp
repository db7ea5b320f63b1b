#include "quadrille/input_cloud.hpp"

#include "run/clock.hpp"

namespace quadrille {

void InputCloud::describe(const std::string& name, std::chrono::steady_clock::time_point start) {
  info = {name, cloud.frame, cloud.read, bus::ms_since(start), X_CK * cloud.viewpoint};
}

}  // namespace quadrille
