#pragma once

#include <string>

#include "doctor/finding.hpp"
#include "io/json.hpp"

namespace quadrille::doctor {

/// For people: a line for each finding, below it what to type, and at the end whether clouds will
/// arrive.
std::string to_table(const Findings& findings);

/// {"version", "lcm_url", "clouds_will_arrive", "checks": [{"check", "verdict", "what", "remedy"}]}
io::Json to_json(const std::string& url, const Findings& findings);

}  // namespace quadrille::doctor
