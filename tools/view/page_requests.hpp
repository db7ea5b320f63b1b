#pragma once

#include <string>
#include <string_view>

#include "view/live/question.hpp"
#include "view/plan_choice.hpp"

namespace quadrille::view {

/// Returns the first value with this name in the query of an address ("name=value&other=value"),
/// decoded from percent signs and pluses; empty if there is none.
std::string query_value(std::string_view query, std::string_view name);

/// Reads the choice from the query of a frame's address, such as
/// "gripper=wsg50&unknown=free&clearance=5".
/// @param gripper  name of the gripper; like the other values, empty if it is not given
/// @param clearance  [mm]
/// @throws std::invalid_argument if the clearance is not a number from 0 to 30
PlanChoice read_choice(const std::string& gripper, const std::string& unknown,
                       const std::string& clearance);

/// Reads the question from the body of a request: {"track", "target", "cloud_utime", "clearance"},
/// with the clearance in millimetres.
/// @throws std::invalid_argument if it is anything else
Question read_question(const std::string& body);

}  // namespace quadrille::view
