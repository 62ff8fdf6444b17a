#pragma once
// A file read line by line and word by word, and where it holds raw bytes number by number; every
// complaint names the file and the line, or the byte.
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace hawser {

class LineScanner {
 public:
  explicit LineScanner(const std::string& path);

  bool next();                         ///< to the next line that is not blank; false at the end
  void next(const std::string& what);  ///< the same, where the file must not end

  // The words of the current line, from left to right; `what` says what is expected.
  std::string_view word(const std::string& what);
  long long integer(const std::string& what);
  long long count(const std::string& what);  ///< an integer that is not negative
  double real(const std::string& what);      ///< finite
  std::string quoted(const std::string& what);
  void end(const std::string& after);  ///< refuses further words on this line

  // Numbers as they are in memory, from behind the current line on; they must be finite.
  long long raw_int(const std::string& what);    ///< 4 bytes
  long long raw_count(const std::string& what);  ///< 8 bytes without a sign
  double raw_real(const std::string& what);
  /// Complaints name the byte from now on.
  void expect_raw() { raw_ = true; }

  int line() const { return raw_ ? 0 : number_; }  ///< 0: not to be told in a binary file
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  void skip_blanks();
  void take(void* to, std::streamsize size, const std::string& what);

  std::string path_;
  std::ifstream file_;
  std::string text_;
  std::size_t position_ = 0;
  int number_ = 0;
  long long byte_ = 0;
  bool raw_ = false;
};

}  // namespace hawser
