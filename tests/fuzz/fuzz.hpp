#pragma once
// What a reader that is fuzzed provides (table_fuzz.cpp, mesh_fuzz.cpp). Two programs ask for it:
// libfuzzer.cpp, whose inputs are guided by coverage, and mutants.cpp, whose inputs are the same
// every time.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

enum class Answer { read, refused };

/// To begin with; some of them are read.
std::vector<std::string> good_inputs();

/// broken() when the promise is.
Answer answer_to(const std::string& input);

[[noreturn]] inline void broken(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

template <class Holds>
bool every_line(const std::string& text, const Holds& holds) {
  std::istringstream lines(text);
  bool any = false;
  for (std::string line; std::getline(lines, line); any = true)
    if (!holds(line)) return false;
  return any;
}
