#include "src/terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace hawser {
namespace {

// mpirun gives its ranks a terminal of their own, even when what it passes on goes to a file.
bool on_a_terminal() {
  const char* const kind = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && kind != nullptr && std::string(kind) != "dumb" &&
         std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMI_SIZE") == nullptr;
}

bool colours_wanted() {  // no-color.org
  const char* const refused = std::getenv("NO_COLOR");
  return refused == nullptr || *refused == '\0';
}

const char* code(Colour colour) {
  switch (colour) {
    case Colour::good: return "\033[32m";
    case Colour::warning: return "\033[33m";
    case Colour::bad: return "\033[31m";
    default: return "";
  }
}

}  // namespace

Terminal::Terminal() : is_terminal_(on_a_terminal()), coloured_(is_terminal_ && colours_wanted()) {}

Terminal::~Terminal() {
  wipe();
  std::fflush(stdout);
}

void Terminal::wipe() {
  if (has_bar_) std::fputs("\r\033[K", stdout);
  has_bar_ = false;
}

void Terminal::line(const std::string& text, Colour colour) {
  wipe();
  std::fflush(stdout);
  std::FILE* const stream = colour == Colour::bad ? stderr : stdout;
  if (coloured_ && colour != Colour::plain)
    std::fprintf(stream, "%s%s\033[0m\n", code(colour), text.c_str());
  else
    std::fprintf(stream, "%s\n", text.c_str());
  std::fflush(stream);
}

void Terminal::bar(double done, const std::string& text) {
  if (!is_terminal_) return;
  constexpr int width = 30;
  const int full = static_cast<int>(done * width);
  wipe();
  std::fprintf(stdout, "[%s%s] %3.0f %%  %s", std::string(full, '#').c_str(),
               std::string(width - full, '.').c_str(), 100 * done, text.c_str());
  std::fflush(stdout);
  has_bar_ = true;
}

}  // namespace hawser
