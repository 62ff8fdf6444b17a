#pragma once
// Standard output, and standard error for what is bad: lines, and on a terminal colours and a bar
// that stays the last line.
#include <string>

namespace hawser {

enum class Colour { plain, good, warning, bad };

class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void line(const std::string& text, Colour colour = Colour::plain);
  /// Nothing where there is no terminal. `done` in [0, 1].
  void bar(double done, const std::string& text);

 private:
  void wipe();
  bool is_terminal_, coloured_;
  bool has_bar_ = false;
};

}  // namespace hawser
