#pragma once
// A text file read line by line and word by word; every complaint names the file and the line.
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

  int line() const { return number_; }
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  void skip_blanks();

  std::string path_;
  std::ifstream file_;
  std::string text_;
  std::size_t position_ = 0;
  int number_ = 0;
};

}  // namespace hawser
