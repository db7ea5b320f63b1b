#include "lab/experiments/table.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace quadrille::experiments {
namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::string markdown_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? std::string("\\|") : std::string(1, c);
    line += " |";
  }
  return line + "\n";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (!line.empty()) line += ',';
    line += quoted(cell);
  }
  line += '\n';
  return line;
}

}  // namespace

void Table::add(std::vector<std::string> row) {
  if (row.size() != columns.size()) {
    throw std::invalid_argument(
        fmt::format("a row of {} cells in a table of {} columns", row.size(), columns.size()));
  }
  rows.push_back(std::move(row));
}

std::string number(double value) { return fmt::format("{:.4g}", value); }

std::string to_markdown(const Table& table) {
  std::string text = table.title.empty() ? "" : "## " + table.title + "\n\n";
  text += markdown_line(table.columns);
  text += markdown_line(std::vector<std::string>(table.columns.size(), "---"));
  for (const auto& row : table.rows) text += markdown_line(row);
  return text;
}

std::string to_csv(const Table& table) {
  std::string text = csv_line(table.columns);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

}  // namespace quadrille::experiments
