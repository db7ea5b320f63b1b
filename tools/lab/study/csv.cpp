#include "lab/study/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "io/file_bytes.hpp"
#include "lab/experiments/table.hpp"

namespace quadrille::study {
namespace {

template <class Number>
bool read_number(const std::string& text, Number* value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, *value);
  return error == std::errc{} && rest == end;
}

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text) {
  std::vector<CsvRow> rows;
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      // Two quotes within a quoted cell stand for one quote.
      const bool doubled = quoted && i + 1 < text.size() && text[i + 1] == '"';
      if (doubled) cells.back() += text[++i];
      if (!doubled) quoted = !quoted;
    } else if (quoted || (c != ',' && c != '\n')) {
      cells.back() += c;
    } else if (c == ',') {
      cells.emplace_back();
    } else {
      rows.push_back({std::move(cells), i + 1});
      cells.assign(1, "");
    }
  }
  return rows;
}

std::string csv_line(const std::vector<std::string>& cells) {
  return experiments::to_csv({"", cells, {}});
}

CsvTable::CsvTable(std::string name, std::string_view text, const std::vector<std::string>& columns)
    : name_(std::move(name)), columns_(columns), rows_(parse_csv(text)) {
  if (rows_.empty() || rows_.front().cells != columns) {
    throw io::FileError(name_, "line 1",
                        "has not the columns of this version's studies; give another file");
  }
  header_end_ = rows_.front().end;
  rows_.erase(rows_.begin());
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].cells.size() == columns.size()) continue;
    throw io::FileError(name_, fmt::format("row {}", row + 1),
                        fmt::format("has {} cells where {} columns are; the file is damaged",
                                    rows_[row].cells.size(), columns.size()));
  }
}

std::size_t CsvTable::end_of(std::size_t count) const {
  return count == 0 ? header_end_ : rows_[count - 1].end;
}

const std::string& CsvTable::cell(std::size_t row, std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return rows_[row].cells[static_cast<std::size_t>(found - columns_.begin())];
}

int CsvTable::count(std::size_t row, std::string_view column) const {
  int value = 0;
  const std::string& text = cell(row, column);
  if (text.empty() || read_number(text, &value)) return value;
  throw io::FileError(name_, place_of(row, column), fmt::format("'{}' is no whole number", text));
}

double CsvTable::number(std::size_t row, std::string_view column) const {
  double value = 0.0;
  const std::string& text = cell(row, column);
  if (read_number(text, &value)) return value;
  throw io::FileError(name_, place_of(row, column), fmt::format("'{}' is no number", text));
}

std::string CsvTable::place_of(std::size_t row, std::string_view column) const {
  return fmt::format("row {}, column {}", row + 1, column);
}

}  // namespace quadrille::study
