#pragma once
// Where something was written, so that every later complaint can point at it.
#include <string>

namespace hawser {

struct Location {
  std::string file;
  int line = 0;    ///< from 1; 0: not written in any file (a default)
  int column = 0;  ///< from 1, in characters

  std::string text() const;  ///< "file:line:column"; without a line just the file, or "(default)"
};

bool operator<(const Location& a, const Location& b);
bool operator==(const Location& a, const Location& b);

/// A value and the place where it was given, for checks that only a later layer can make
/// ("region 'x' is not in the mesh").
template <class T>
struct Located {
  T value{};
  Location location{};

  operator const T&() const { return value; }
  const T& operator*() const { return value; }
  const T* operator->() const { return &value; }
};

}  // namespace hawser
