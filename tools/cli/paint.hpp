#pragma once

#include <string>

namespace quadrille {

/// Adds colours to text for people, or none.
class Paint {
 public:
  explicit Paint(bool is_on) : is_on_(is_on) {}

  /// Returns colours if the standard output is a terminal that has them, and NO_COLOR is empty
  /// (https://no-color.org).
  static Paint of_stdout();

  std::string head(const std::string& text) const;
  /// Paints text that is less important.
  std::string faint(const std::string& text) const;
  std::string good(const std::string& text) const;
  std::string bad(const std::string& text) const;

 private:
  bool is_on_;
};

}  // namespace quadrille
