#pragma once

#include <string>
#include <string_view>

#include "view/plan_choice.hpp"
#include "view/question.hpp"

namespace quadrille::view {

/// The first value of that name in the query of an address ("name=value&other=value"), decoded from
/// percent signs and pluses; empty if there is none.
std::string query_value(std::string_view query, std::string_view name);

/// The choice in the query of a frame's address, such as "gripper=wsg50&unknown=free&clearance=5".
/// @param gripper    its values, empty where they are not given
/// @param clearance  [mm]
/// @throws std::invalid_argument if the clearance is no number from 0 to 30
PlanChoice read_choice(const std::string& gripper, const std::string& unknown,
                       const std::string& clearance);

/// The question in the body of a request: {"track", "target", "cloud_utime", "clearance"}, the
/// clearance in millimetres.
/// @throws std::invalid_argument if it is anything else
Question read_question(const std::string& body);

}  // namespace quadrille::view
