#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace quadrille::doctor {

/// The result of a check. Only failures prevent clouds from being answered.
enum class Verdict { kOk, kWarning, kFailed };

/// The finding of one check.
struct Finding {
  Verdict verdict = Verdict::kOk;
  /// Name of the check, in one or two words.
  std::string check;
  /// The finding itself, with its numbers.
  std::string what;
  /// The command to type, or the change to make; empty if none is needed.
  std::string remedy = {};
};

using Findings = std::vector<Finding>;

inline bool has_failure(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& found) { return found.verdict == Verdict::kFailed; });
}

/// The check of the camera's poses, on which clouds do not depend.
inline constexpr const char* kPoseCheck = "poses";

/// Returns true if something failed on which clouds depend.
inline bool keeps_clouds_away(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& found) {
    return found.verdict == Verdict::kFailed && found.check != kPoseCheck;
  });
}

}  // namespace quadrille::doctor
