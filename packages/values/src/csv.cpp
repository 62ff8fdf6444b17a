#include "hawser/values/csv.hpp"

#include <algorithm>

#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

int characters(const std::string& text, std::size_t end) {
  return static_cast<int>(std::count_if(text.begin(),
                                        text.begin() + static_cast<std::ptrdiff_t>(end),
                                        [](char c) { return !is_continuation(c); }));
}

CsvLine cells_of(const std::string& text, int number) {
  CsvLine line{number, {}};
  int column = 1;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string cell = text.substr(begin, end - begin);
    const std::size_t blanks = std::min(cell.find_first_not_of(" \t\r"), cell.size());
    line.cells.push_back({trimmed(cell), column + static_cast<int>(blanks)});
    column += characters(cell, cell.size()) + 1;
    begin = end + 1;
  }
  return line;
}

/// What is wrong with a file as a whole; "" for a text of lines.
std::string fault_of_file(const std::string& text) {
  const auto begins = [&](const char* bytes) { return text.rfind(bytes, 0) == 0; };
  if (begins("\xEF\xBB\xBF"))
    return "the file begins with a byte-order mark, which hides the first column's name; save it "
           "as UTF-8 without one";
  if (begins("\xFF\xFE") || begins("\xFE\xFF"))
    return "the file is in UTF-16; save it as UTF-8 without a byte-order mark";
  if (begins("PK\x03\x04"))
    return "the file is a spreadsheet or an archive; save it as comma-separated values (CSV)";
  if (text.find('\0') != std::string::npos)
    return "the file is no text, it holds bytes that are zero; save it as comma-separated values "
           "(CSV)";
  const std::size_t lone = text.find('\r');
  if (lone != std::string::npos && text.find('\n') == std::string::npos)
    return "its lines end with a carriage return alone; save it with line feeds";
  return "";
}

struct Separator {
  char character;
  const char* name;
};
constexpr Separator others[] = {{';', "';'"}, {'\t', "tabulators"}, {'|', "'|'"}};

/// What a line has that belongs in no table; "" and `at` untouched when there is nothing.
std::string fault_of_line(const std::string& line, std::size_t& at) {
  for (const Separator& other : others) {
    const std::size_t found = trimmed(line).find(other.character);
    if (found == std::string::npos) continue;
    at = line.find(other.character);
    return std::string("values are set apart by commas, and here by ") + other.name +
           "; replace them" +
           (line.find(',') == std::string::npos ? ""
                                                : ", and write numbers with a point, 0.5 for 0,5");
  }
  const std::size_t quote = line.find_first_of("\"'`");
  if (quote == std::string::npos) return "";
  at = quote;
  return "a table has no quotes, around names or numbers; leave them away";
}

std::string fault_of_count(const CsvLine& line, std::size_t columns) {
  const std::size_t count = line.cells.size();
  std::string sentence = std::to_string(count) + (count == 1 ? " value" : " values") + ", but " +
                         std::to_string(columns) + (columns == 1 ? " column" : " columns");
  if (count == columns + 1 && line.cells.back().text.empty())
    return sentence + "; a comma stands at the end of the line";
  if (count == 2 * columns || count == 2 * columns - 1)
    return sentence + "; numbers are written with a point, 0.5 and not 0,5";
  return sentence;
}

}  // namespace

Csv read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  Csv csv{file, {}, {}};
  const std::string of_file = fault_of_file(text);
  if (!of_file.empty()) {
    diagnostics.error({file, 1, 1}, of_file);
    return csv;
  }
  int number = 0, told = 0;
  for (std::size_t begin = 0; begin < text.size() && told < most_told;) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string content = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const std::string bare = trimmed(content);
    if (bare.empty() || bare[0] == '#') continue;
    std::size_t at = 0;
    const std::string fault = fault_of_line(content, at);
    if (!fault.empty()) {
      diagnostics.error({file, number, characters(content, at) + 1}, fault);
      return csv;  // the cells are not to be told apart
    }
    CsvLine line = cells_of(content, number);
    if (csv.header.number == 0) {
      csv.header = std::move(line);
    } else if (line.cells.size() == csv.header.cells.size()) {
      csv.rows.push_back(std::move(line));
    } else {
      const std::size_t last = std::min(line.cells.size(), csv.header.cells.size() + 1) - 1;
      diagnostics.error(csv.place(line, last), fault_of_count(line, csv.header.cells.size()));
      ++told;
    }
  }
  if (csv.header.number == 0)
    diagnostics.error({file, 1, 1},
                      "the table is empty; its first line names the columns, such as "
                      "time_s,velocity_x_m_per_s, and its rows follow");
  else if (csv.rows.empty() && told == 0)
    diagnostics.error({file, csv.header.number, 1},
                      "the table has no rows, only a line with the columns' names");
  return csv;
}

}  // namespace hawser
