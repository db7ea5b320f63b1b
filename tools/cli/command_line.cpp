#include "cli/command_line.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

namespace quadrille {
namespace {

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("_-./,:=+@%#").find(c) != std::string_view::npos;
}

}  // namespace

std::string in_quotes(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  return text + "'";
}

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line;
  for (std::string word; std::getline(file, word, '\0');) {
    // The program's name is given without its folder.
    if (line.empty()) word = word.substr(word.rfind('/') + 1);
    line += (line.empty() ? "" : " ") + in_quotes(word);
  }
  return line;
}

}  // namespace quadrille
