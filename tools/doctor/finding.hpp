#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace quadrille::doctor {

/// How a check ended. Only failures keep clouds from being answered.
enum class Verdict { kOk, kWarning, kFailed };

/// What one check found.
struct Finding {
  Verdict verdict = Verdict::kOk;
  /// The check, in one word or two.
  std::string check;
  /// What is there, with its numbers.
  std::string what;
  /// What to type, or to change; empty if nothing needs to.
  std::string remedy = {};
};

using Findings = std::vector<Finding>;

inline bool has_failure(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& found) { return found.verdict == Verdict::kFailed; });
}

}  // namespace quadrille::doctor
