#include "quadrille/try_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

namespace quadrille {
namespace {

using physics::Attempt;
using physics::Outcome;

/// Number of grasps by outcome.
struct Count {
  int tried = 0;
  std::map<Outcome, int> ends;

  void add(const Attempt& attempt) {
    ++ends[attempt.outcome];
    tried += attempt.outcome != Outcome::kUntried;
  }
  int held() const {
    const auto found = ends.find(Outcome::kHeld);
    return found == ends.end() ? 0 : found->second;
  }
  std::string others() const {
    std::vector<std::string> parts;
    for (const auto& [outcome, count] : ends) {
      if (outcome != Outcome::kHeld)
        parts.push_back(fmt::format("{} {}", count, to_string(outcome)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }
};

double percent_held(const Count& count) {
  return count.tried > 0 ? 100.0 * count.held() / count.tried : 0.0;
}

std::string line_of(const std::string& name, const Count& count) {
  const std::string others = count.others();
  return fmt::format("  {:<24} {:>4} of {:>4} held ({:.1f} %){}{}\n", name, count.held(),
                     count.tried, percent_held(count), others.empty() ? "" : ", ", others);
}

std::vector<std::string> row_of(const std::string& name, const Count& count) {
  return {name, fmt::format("{} of {}", count.held(), count.tried),
          fmt::format("{:.1f} %", percent_held(count)), count.others()};
}

io::Json json_of(const Count& count) {
  io::Json json = {{"tried", count.tried}, {"held", count.held()}};
  for (const auto& [outcome, number] : count.ends) {
    if (outcome != Outcome::kHeld) json[to_string(outcome)] = number;
  }
  return json;
}

/// Counts of all attempts, of the first of each target, and of the latter by type.
struct Summary {
  Count all, first;
  std::map<std::string, Count> by_type;

  explicit Summary(const std::vector<Attempt>& attempts) {
    for (const Attempt& attempt : attempts) {
      all.add(attempt);
      if (!attempt.first) continue;
      first.add(attempt);
      by_type[attempt.type].add(attempt);
    }
  }
};

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

// A lost object shows no value: it falls far, and the distance is of no interest.
std::string shown(const Attempt& attempt, double value) {
  const bool lost = attempt.outcome == Outcome::kDropped || attempt.outcome == Outcome::kMissed;
  return lost ? "-" : fmt::format("{:.1f}", value);
}

std::string painted(Outcome outcome, const Paint& paint) {
  if (outcome == Outcome::kHeld) return paint.good(to_string(outcome));
  return outcome == Outcome::kUntried ? to_string(outcome) : paint.bad(to_string(outcome));
}

}  // namespace

std::string attempt_table(const std::string& input, const std::vector<Attempt>& attempts,
                          const Paint& paint) {
  std::string text = input + ":\n";
  if (attempts.empty()) return text + "  no grasps to try\n";
  text += paint.head(fmt::format("  {:>6} {:>5} {:<22} {:>8} {:>7} {:>8}  {}", "target", "score",
                                 "object", "width/mm", "slip/mm", "turn/deg", "outcome")) +
          "\n";
  for (const Attempt& a : attempts) {
    text += fmt::format("  {:>6} {:>5.2f} {:<22} {:>8.1f} {:>7} {:>8}  {}{}\n", a.target, a.score,
                        a.type, 1000.0 * a.width, shown(a, 1000.0 * a.trial.slip),
                        shown(a, degrees(a.trial.rotation)), painted(a.outcome, paint),
                        a.first ? "" : " (not the target's first)");
  }
  return text;
}

std::string attempt_summary(const std::vector<Attempt>& attempts) {
  const Summary summary(attempts);
  std::string text =
      "in all:\n" + line_of("grasps", summary.all) + line_of("first of each target", summary.first);
  for (const auto& [type, count] : summary.by_type) text += line_of("- " + type, count);
  return text;
}

view::ReportTable attempt_summary_table(const std::vector<Attempt>& attempts) {
  const Summary summary(attempts);
  view::ReportTable table{"Tried", {"", "held", "", "others"}, {}};
  table.rows.push_back(row_of("grasps", summary.all));
  table.rows.push_back(row_of("first of each target", summary.first));
  for (const auto& [type, count] : summary.by_type) table.rows.push_back(row_of(type, count));
  return table;
}

io::Json attempts_json(const std::string& input, const std::vector<Attempt>& attempts) {
  io::Json rows = io::Json::array();
  for (const Attempt& a : attempts) {
    rows.push_back({{"target", a.target},
                    {"first", a.first},
                    {"score", a.score},
                    {"width", a.width},
                    {"object", a.object},
                    {"type", a.type},
                    {"outcome", to_string(a.outcome)},
                    {"touched", a.trial.touched},
                    {"lifted", a.trial.lifted},
                    {"slip", a.trial.slip},
                    {"rotation", a.trial.rotation},
                    {"held", a.trial.held}});
  }
  const Summary summary(attempts);
  io::Json by_type = io::Json::object();
  for (const auto& [type, count] : summary.by_type) by_type[type] = json_of(count);
  return {{"input", input},
          {"grasps", rows},
          {"summary",
           {{"all", json_of(summary.all)}, {"first", json_of(summary.first)}, {"types", by_type}}}};
}

}  // namespace quadrille
