#pragma once
// The numbers of a MSH file, which are words of lines or raw bytes.
#include <string>

#include "line_scanner.hpp"

namespace hawser {

/// Text until read_binary(); then numbers within sections are raw, and lines mean nothing there.
class MshScanner : public LineScanner {
 public:
  using LineScanner::LineScanner;

  /// Behind the line of the format. `size_tags`: numbers of nodes and elements have 8 bytes (MSH
  /// 4).
  void read_binary(bool size_tags) {
    expect_raw();
    if (raw_int("the number one") != 1)
      fail(
          "the file was written on a machine of the other byte order; write it as ASCII "
          "(Mesh.Binary = 0)");
    binary_ = true;
    size_tags_ = size_tags;
  }
  bool is_binary() const { return binary_; }
  /// For what is text in any file.
  LineScanner& text() { return *this; }

  /// What stands on a line of its own in text.
  void record(const std::string& what) {
    if (!binary_) next(what);
  }
  void end_record(const std::string& after) {
    if (!binary_) end(after);
  }
  long long integer(const std::string& what) {
    return binary_ ? raw_int(what) : LineScanner::integer(what);
  }
  /// gmsh's size_t.
  long long count(const std::string& what) {
    return binary_ ? raw_count(what) : LineScanner::count(what);
  }
  /// The number of a node or element.
  long long tag(const std::string& what) { return size_tags_ ? raw_count(what) : integer(what); }
  double real(const std::string& what) {
    return binary_ ? raw_real(what) : LineScanner::real(what);
  }

 private:
  bool binary_ = false, size_tags_ = false;
};

}  // namespace hawser
