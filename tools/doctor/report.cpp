#include "doctor/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/describe.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::doctor {
namespace {

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "ok";
    case Verdict::kWarning:
      return "warning";
    case Verdict::kFailed:
      break;
  }
  return "failed";
}

std::size_t number_of(Verdict verdict, const Findings& findings) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [&](const Finding& found) { return found.verdict == verdict; }));
}

}  // namespace

std::string describe_failure(const Findings& findings) {
  return keeps_clouds_away(findings)
             ? "not all clouds will arrive"
             : "clouds will arrive, but not all of them will get the pose of their camera";
}

std::string to_table(const Findings& findings) {
  std::string table;
  for (const Finding& found : findings) {
    table += fmt::format("{:<8} {:<15} {}\n", to_string(found.verdict), found.check,
                         printable(found.what, kMaxLine));
    if (!found.remedy.empty())
      table += fmt::format("{:<24} -> {}\n", "", printable(found.remedy, kMaxLine));
  }
  const auto failed = number_of(Verdict::kFailed, findings);
  const std::string warnings = io::count_of(number_of(Verdict::kWarning, findings), "warning");
  table += failed == 0
               ? fmt::format("clouds will arrive ({})\n", warnings)
               : fmt::format("{}: {} failed, {}\n", describe_failure(findings), failed, warnings);
  return table;
}

io::Json to_json(const std::string& url, const Findings& findings) {
  io::Json checks = io::Json::array();
  for (const Finding& found : findings) {
    checks.push_back({{"check", found.check},
                      {"verdict", to_string(found.verdict)},
                      {"what", found.what},
                      {"remedy", found.remedy}});
  }
  return {{"version", QUADRILLE_VERSION},
          {"lcm_url", url},
          {"clouds_will_arrive", !keeps_clouds_away(findings)},
          {"checks", checks}};
}

}  // namespace quadrille::doctor
