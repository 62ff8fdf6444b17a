#include "hawser/output/history.hpp"

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "src/files.hpp"

namespace hawser {
namespace {

std::string header_line(const std::vector<Column>& columns) {
  std::string line;
  for (const Column& column : columns) {
    line += (line.empty() ? "" : ",") + quantity_name(column);
  }
  return line + "\n";
}

// Header and rows up to the given time; a last row cut short by a kill has no line end and goes.
std::string kept(const std::string& path, const std::string& header, double until) {
  std::string text = header;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  if (line + "\n" != header) return text;                   // other columns: not this history
  const double tolerance = 1e-9 * (1.0 + std::abs(until));  // times are printed with 12 digits
  while (std::getline(file, line) && !file.eof()) {
    if (std::strtod(line.c_str(), nullptr) <= until + tolerance) text += line + "\n";
  }
  return text;
}

}  // namespace

std::string quantity_name(const Column& column) {
  if (column.unit.empty() || column.unit == "1") return column.name;
  std::string name = column.name + "_";
  for (const char c : column.unit) {
    if (c == '/') {
      name += name.back() == '_' ? "per_" : "_per_";
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ' || c == '*') {
      name += '_';
    }  // the ^ of a power is left out: m^2 is m2
  }
  return name;
}

History::History(const Communicator& communicator, std::string path, std::vector<Column> columns,
                 std::optional<double> keep_until)
    : communicator_(communicator), path_(std::move(path)), column_count_(columns.size()) {
  communicator_.on_root([&] {
    const std::string header = header_line(columns);
    write_atomically(path_, keep_until ? kept(path_, header, *keep_until) : header);
    file_.reset(std::fopen(path_.c_str(), "a"));
    if (!file_) throw_cannot("write", path_, errno);
  });
}

void History::append(const std::vector<double>& rows) {
  if (rows.size() % column_count_ != 0) throw std::logic_error("history: a row of another length");
  communicator_.on_root([&] {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool ends_row = (i + 1) % column_count_ == 0;
      std::fprintf(file_.get(), "%.12g%c", rows[i], ends_row ? '\n' : ',');
    }
    if (std::fflush(file_.get()) != 0) throw_cannot("write", path_, errno);
  });
}

}  // namespace hawser
