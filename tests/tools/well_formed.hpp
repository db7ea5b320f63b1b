#pragma once

#include <string>
#include <vector>

namespace quadrille::test {

inline int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// A simple check of an SVG document: every tag is closed in turn, quotes are paired, and & begins
/// an entity. The declaration of XML before it is not checked.
inline bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  const std::size_t begin = xml.find("<svg ");
  for (std::size_t at = begin; (at = xml.find_first_of("<&", at)) != std::string::npos;) {
    const std::size_t end = xml.find(xml[at] == '<' ? '>' : ';', at);
    if (end == std::string::npos) return false;
    const std::string inside = xml.substr(at + 1, end - at - 1);
    const bool entity = xml[at] == '&';
    at = end + 1;
    if (inside.empty() || inside.find('<') != std::string::npos) return false;
    if (entity) {
      if (inside.find_first_of(" \"") != std::string::npos) return false;
    } else if (count(inside, "\"") % 2 != 0) {
      return false;
    } else if (inside.front() == '/') {
      if (open.empty() || open.back() != inside.substr(1)) return false;
      open.pop_back();
    } else if (inside.back() != '/') {
      open.push_back(inside.substr(0, inside.find(' ')));
    }
  }
  return open.empty() && begin != std::string::npos;
}

}  // namespace quadrille::test
