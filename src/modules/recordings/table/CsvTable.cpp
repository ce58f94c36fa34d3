#include "recordings/table/CsvTable.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <charconv>
#include <cmath>
#include <csv.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace naocal {

namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const auto begin = text.find_first_not_of(blank), end = text.find_last_not_of(blank);
  return begin == std::string_view::npos ? "" : std::string{text.substr(begin, end - begin + 1)};
}

bool isUtf8(const std::string& text) {
  namespace utf = boost::locale::utf;
  for (auto at = text.begin(); at != text.end();) {
    if (!utf::is_valid_codepoint(utf::utf_traits<char>::decode(at, text.end()))) {
      return false;
    }
  }
  return true;
}

/// ISO 8859-1, whose letters are the first code points, in UTF-8.
std::string toUtf8(const std::string& latin) {
  std::string text;
  text.reserve(latin.size() + latin.size() / 8);
  for (const char letter : latin) {
    boost::locale::utf::utf_traits<char>::encode(static_cast<unsigned char>(letter), std::back_inserter(text));
  }
  return text;
}

/// Number of words between spaces.
std::size_t countWords(std::string_view line) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool isBlank = line[i] == ' ' || line[i] == '\r';
    count += !isBlank && (i == 0 || line[i - 1] == ' ') ? 1 : 0;
  }
  return count;
}

std::string_view lineAt(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// The separator that the first line has most of. Spaces, if it has no other and the second line has as many words.
char separatorOf(std::string_view text) {
  const std::string_view line = lineAt(text, 0);
  constexpr std::array candidates{',', ';', '\t'};
  const bool hasOther =
      std::any_of(candidates.begin(), candidates.end(), [&](char one) { return line.find(one) != line.npos; });
  if (!hasOther && line.size() < text.size()) {
    const std::size_t words = countWords(line);
    if (words > 1 && words == countWords(lineAt(text, line.size() + 1))) {
      return ' ';
    }
  }
  return *std::max_element(candidates.begin(), candidates.end(), [&](char one, char other) {
    return std::count(line.begin(), line.end(), one) < std::count(line.begin(), line.end(), other);
  });
}

/// The text with one space between words, and none at the ends of lines.
std::string withSingleSpaces(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char letter : text) {
    const bool isEnd = letter == '\n' || letter == '\r';
    if (isEnd && !result.empty() && result.back() == ' ') {
      result.pop_back();
    }
    const bool isLeading = result.empty() || result.back() == '\n' || result.back() == ' ';
    if (letter != ' ' || !isLeading) {
      result += letter;
    }
  }
  if (!result.empty() && result.back() == ' ') {
    result.pop_back();
  }
  return result;
}

/// Rows as the parser hands them out.
struct ParsedRows {
  std::vector<std::vector<std::string>> rows{{}};
  bool isTooLarge = false;
};

void endCell(void* cell, std::size_t size, void* to) {
  auto& parsed = *static_cast<ParsedRows*>(to);
  if (parsed.rows.back().size() > mostTableColumns || parsed.rows.size() > mostCaptures + 2) {
    parsed.isTooLarge = true;
    return;
  }
  parsed.rows.back().push_back(trimmed({static_cast<const char*>(cell), size}));
}

void endRow(int /*terminator*/, void* to) {
  auto& parsed = *static_cast<ParsedRows*>(to);
  if (!parsed.isTooLarge) {
    parsed.rows.emplace_back();
  }
}

ParsedRows parseRows(std::string_view text, char separator, const std::string& file) {
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) {
    throw std::bad_alloc{};
  }
  const std::unique_ptr<csv_parser, decltype(&csv_free)> cleanup{&parser, &csv_free};
  csv_set_delim(&parser, static_cast<unsigned char>(separator));
  ParsedRows parsed;
  const bool isParsed = csv_parse(&parser, text.data(), text.size(), endCell, endRow, &parsed) == text.size() &&
                        csv_fini(&parser, endCell, endRow, &parsed) == 0;
  if (!isParsed) {
    throw InputError{fmt::format("{}, row {}: expected comma-separated values, found broken quotes ({})", file,
                                 parsed.rows.size(), csv_strerror(csv_error(&parser)))};
  }
  if (parsed.isTooLarge) {
    throw InputError{
        fmt::format("{}: expected at most {} rows and {} columns, found more", file, mostCaptures, mostTableColumns)};
  }
  parsed.rows.pop_back(); // begun after the last row
  return parsed;
}

} // namespace

CsvTable::CsvTable(const std::string& text, std::string file) : file_{std::move(file)} {
  const std::string converted = isUtf8(text) ? "" : toUtf8(text);
  std::string_view content{converted.empty() ? text : converted};
  for (const std::string_view prefix : {"\xef\xbb\xbf", "#", " "}) { // byte order mark, numpy's comment
    if (content.starts_with(prefix)) {
      content.remove_prefix(prefix.size());
    }
  }
  separator_ = separatorOf(content);
  const std::string spaced = separator_ == ' ' ? withSingleSpaces(content) : "";
  std::vector<std::vector<std::string>> rows =
      parseRows(separator_ == ' ' ? std::string_view{spaced} : content, separator_, file_).rows;
  if (rows.empty()) {
    throw InputError{fmt::format("{}: expected a row of column names, found an empty file", file_)};
  }
  names_ = std::move(rows.front());
  checkNames();
  cells_.assign(std::make_move_iterator(rows.begin() + 1), std::make_move_iterator(rows.end()));
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    if (cells_[row].size() != names_.size()) {
      throw InputError{fmt::format("{}: expected {} cells, as there are columns, found {}", where(row), names_.size(),
                                   cells_[row].size())};
    }
  }
  if (cells_.empty()) {
    throw InputError{fmt::format("{}: expected readings below the row of names, found none", file_)};
  }
}

void CsvTable::checkNames() const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i].empty()) {
      throw InputError{fmt::format("{}, row 1: expected a name for column {}, found none", file_, i + 1)};
    }
  }
}

bool CsvTable::isUnique(const std::string& name) const {
  return std::count(names_.begin(), names_.end(), name) == 1;
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    throw InputError{
        fmt::format("{}: expected a column \"{}\", found {}", file_, printableText(name, 80),
                    printableText(fmt::format("{}", fmt::join(closestNames(name, names_, 8), ", ")), 400))};
  }
  if (std::find(found + 1, names_.end(), name) != names_.end()) {
    throw InputError{fmt::format("{}, row 1: expected one column \"{}\", as it is used, found two; rename one", file_,
                                 printableText(name, 80))};
  }
  return static_cast<std::size_t>(found - names_.begin());
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  std::string cell = cells_[row][column];
  std::string lower = cell;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (cell.empty() || lower == "nan") {
    return std::nullopt;
  }
  if (separator_ != ',' && cell.find('.') == std::string::npos) {
    std::replace(cell.begin(), cell.end(), ',', '.');
  }
  const char* begin = cell.data() + (cell.front() == '+' ? 1 : 0);
  const char* const end = cell.data() + cell.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value)) {
    throw InputError{fmt::format("{}, column \"{}\": expected a number, found \"{}\"", where(row),
                                 printableText(names_[column], 80), printableText(cells_[row][column], 40))};
  }
  return value;
}

std::string CsvTable::where(std::size_t row) const {
  return fmt::format("{}, row {}", file_, row + 2);
}

} // namespace naocal
