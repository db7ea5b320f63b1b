#pragma once

#include <string>

#include "doctor/finding.hpp"
#include "io/json/json.hpp"

namespace quadrille::doctor {

/// Returns what will not arrive, in words, if something failed.
std::string describe_failure(const Findings& findings);

/// Returns a readable report: a line for each finding with its remedy below it, and at the end
/// whether clouds will arrive.
std::string to_table(const Findings& findings);

/// Returns {"version", "lcm_url", "clouds_will_arrive", "checks": [{"check", "verdict", "what",
/// "remedy"}]}.
io::Json to_json(const std::string& url, const Findings& findings);

}  // namespace quadrille::doctor
