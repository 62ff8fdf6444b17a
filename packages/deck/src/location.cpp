#include "hawser/deck/location.hpp"

#include <tuple>

namespace hawser {

std::string Location::text() const {
  if (line == 0) return file.empty() ? "(default)" : file;
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

bool operator<(const Location& a, const Location& b) {
  return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
}

bool operator==(const Location& a, const Location& b) {
  return std::tie(a.file, a.line, a.column) == std::tie(b.file, b.line, b.column);
}

}  // namespace hawser
