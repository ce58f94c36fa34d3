#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

inline constexpr std::size_t mostTableColumns = 2000;

/// A table of text cells below a row of names.
class CsvTable {
public:
  /// Parses comma-separated values (RFC 4180). Also accepts what spreadsheets and numpy write: semicolons, tabs
  /// or spaces instead of commas, a byte order mark, ISO 8859-1 instead of UTF-8, "# " before the names. Throws
  /// InputError with `file`, row, expected and found: no names, an empty name, rows of another length, broken quotes,
  /// too many rows or columns.
  CsvTable(const std::string& text, std::string file);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return cells_.size(); }

  /// Index of the column of this name. Throws InputError naming the closest names, and for a name of two columns.
  std::size_t column(const std::string& name) const;
  /// Whether one column alone has this name.
  bool isUnique(const std::string& name) const;

  const std::string& text(std::size_t row, std::size_t column) const { return cells_[row][column]; }
  /// The cell as number; absent if it is empty or "nan". A decimal comma is accepted where commas do not separate.
  /// Throws InputError for anything else.
  std::optional<double> number(std::size_t row, std::size_t column) const;

  /// "TABLE.csv, row 7": counted from 1, the names' row included.
  std::string where(std::size_t row) const;

private:
  void checkNames() const;

  std::string file_;
  char separator_ = ',';
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> cells_;
};

} // namespace naocal
