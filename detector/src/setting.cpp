#include "quadrille/detector/setting.hpp"

#include <sstream>
#include <stdexcept>

namespace quadrille {
namespace {

template <class Number>
void require_within(const Setting& setting, Number value) {
  if (value >= setting.min && value <= setting.max) return;
  std::ostringstream message;
  message << setting.name << " = " << value << ": must lie between "
          << static_cast<Number>(setting.min) << " and " << static_cast<Number>(setting.max);
  if (*setting.unit != '\0') message << " " << setting.unit;
  throw std::invalid_argument(message.str());
}

}  // namespace

void check_range(const Setting& setting, double value) { require_within(setting, value); }
void check_range(const Setting& setting, int value) { require_within(setting, value); }

}  // namespace quadrille
