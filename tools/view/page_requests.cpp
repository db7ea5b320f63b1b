#include "view/page_requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/json/json.hpp"
#include "quadrille/grasping/grasp_query.hpp"

namespace quadrille::view {
namespace {

constexpr double kMillimetre = 1e-3;

double metres_of(double clearance) {
  if (!(clearance >= 0.0 && kMillimetre * clearance <= GraspQuery::kMaxMinClearance)) {
    throw std::invalid_argument(fmt::format("clearance: is a number of millimetres from 0 to {}",
                                            GraspQuery::kMaxMinClearance / kMillimetre));
  }
  return kMillimetre * clearance;
}

/// Decodes percent signs and pluses as browsers encode them; a percent sign without a number stays.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char* const digits = text.data() + at + 1;
    unsigned char code = 0;
    if (text[at] == '%' && at + 2 < text.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      plain += static_cast<char>(code);
      at += 2;
    } else {
      plain += text[at] == '+' ? ' ' : text[at];
    }
  }
  return plain;
}

/// Reads a whole number that is not negative; 0 if it is missing.
template <class Integer>
Integer whole(const io::Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end()) return 0;
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<Integer>::max());
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kMax) {
    throw std::invalid_argument(std::string(name) + ": is a whole number, not negative");
  }
  return found->get<Integer>();
}

}  // namespace

std::string query_value(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    const std::size_t equals = std::min(pair.find('='), pair.size());
    if (decoded(pair.substr(0, equals)) == name) {
      return decoded(pair.substr(std::min(equals + 1, pair.size())));
    }
    query.remove_prefix(std::min(pair.size() + 1, query.size()));
  }
  return "";
}

PlanChoice read_choice(const std::string& gripper, const std::string& unknown,
                       const std::string& clearance) {
  PlanChoice choice{gripper, unknown, 0.0};
  if (clearance.empty()) return choice;
  double value = 0.0;
  const char* const end = clearance.data() + clearance.size();
  const auto [last, error] = std::from_chars(clearance.data(), end, value);
  if (error != std::errc{} || last != end) value = -1.0;
  choice.min_clearance = metres_of(value);
  return choice;
}

Question read_question(const std::string& body) {
  const io::Json json = io::Json::parse(body, nullptr, false);
  if (!json.is_object()) throw std::invalid_argument("a question is a JSON object");
  Question question;
  question.track = whole<std::int32_t>(json, "track");
  question.target = whole<std::int32_t>(json, "target");
  question.cloud_utime = whole<std::int64_t>(json, "cloud_utime");
  if (question.track == 0 && question.target == 0) {
    throw std::invalid_argument("a question names a track or a target");
  }
  const auto clearance = json.find("clearance");
  if (clearance == json.end()) return question;
  question.min_clearance = metres_of(clearance->is_number() ? clearance->get<double>() : -1.0);
  return question;
}

}  // namespace quadrille::view
