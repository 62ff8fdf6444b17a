#include "line_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

const char* const blanks = " \t\r";

}  // namespace

// A pipe would have nothing left for the checkpoint, which keeps the mesh, and what never ends
// (such as /dev/zero) would be read for ever.
LineScanner::LineScanner(const std::string& path) : path_(path) {
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  if (std::filesystem::is_directory(status)) throw MeshError(path + " is a folder, no mesh file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw MeshError(path + " is no mesh file but a pipe or a device");
  file_.open(path, std::ios::binary);
  if (!file_) throw MeshError("cannot open the mesh file " + path);
}

bool LineScanner::next() {
  while (std::getline(file_, text_)) {
    ++number_;
    byte_ += static_cast<long long>(text_.size()) + 1;
    position_ = 0;
    skip_blanks();
    if (position_ < text_.size()) return true;
  }
  return false;
}

void LineScanner::next(const std::string& what) {
  if (!next()) fail("the file ends where " + what + " was expected");
}

void LineScanner::skip_blanks() {
  position_ = std::min(text_.find_first_not_of(blanks, position_), text_.size());
}

std::string_view LineScanner::word(const std::string& what) {
  skip_blanks();
  if (position_ == text_.size()) fail("expected " + what + ", found the end of the line");
  const auto end = std::min(text_.find_first_of(blanks, position_), text_.size());
  const auto result = std::string_view(text_).substr(position_, end - position_);
  position_ = end;
  return result;
}

long long LineScanner::integer(const std::string& what) {
  const auto text = word(what);
  long long value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) {
    fail("expected " + what + ", found '" + std::string(text) + "'");
  }
  return value;
}

long long LineScanner::count(const std::string& what) {
  const auto value = integer(what);
  if (value < 0) fail(what + " is negative: " + std::to_string(value));
  return value;
}

double LineScanner::real(const std::string& what) {
  const auto text = word(what);
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value)) {
    fail("expected " + what + ", found '" + std::string(text) + "'");
  }
  return value;
}

std::string LineScanner::quoted(const std::string& what) {
  const auto begin = text_.find('"', position_);
  const auto end = begin == std::string::npos ? begin : text_.find('"', begin + 1);
  if (end == std::string::npos) fail("expected " + what + " in quotation marks");
  position_ = end + 1;
  return text_.substr(begin + 1, end - begin - 1);
}

void LineScanner::end(const std::string& after) {
  skip_blanks();
  if (position_ < text_.size())
    fail("'" + std::string(word(after)) + "' is too much after " + after);
}

void LineScanner::take(void* to, std::streamsize size, const std::string& what) {
  if (!file_.read(static_cast<char*>(to), size))
    fail("the file ends where " + what + " was expected");
  byte_ += size;
}

long long LineScanner::raw_int(const std::string& what) {
  std::int32_t value = 0;
  take(&value, sizeof value, what);
  return value;
}

long long LineScanner::raw_count(const std::string& what) {
  std::int64_t value = 0;
  take(&value, sizeof value, what);
  if (value < 0) fail(what + " is no number that gmsh writes: " + std::to_string(value));
  return value;
}

double LineScanner::raw_real(const std::string& what) {
  double value = 0;
  take(&value, sizeof value, what);
  if (!std::isfinite(value)) fail("expected " + what + ", found " + std::to_string(value));
  return value;
}

void LineScanner::fail(const std::string& sentence) const {
  throw MeshError(path_ +
                  (raw_ ? ": before byte " + std::to_string(byte_)
                        : ":" + std::to_string(std::max(1, number_))) +
                  ": " + sentence);
}

}  // namespace hawser
