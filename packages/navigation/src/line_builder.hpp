#pragma once
// Collects the positions of a file in the order in which they stand in it.
#include <map>

#include "hawser/navigation/navigation_line.hpp"

namespace hawser {

class LineBuilder {
 public:
  LineBuilder(std::string file, std::string format, Diagnostics& diagnostics)
      : diagnostics_(diagnostics) {
    line_.file = std::move(file);
    line_.format = std::move(format);
  }

  NavigationLine& line() { return line_; }
  /// What follows belongs to this shot; one that was there already is a fault.
  void shot(int number, double time, const Location& where);
  /// Of the last shot. NaN where it is not known.
  void receiver(int number, const Place& place, double depth, const Location& where);
  /// Receivers ascend by number; what is missing is NaN. Faults of the line as a whole.
  NavigationLine finish();

 private:
  struct Position {
    Place place;
    double depth;
  };
  Diagnostics& diagnostics_;
  NavigationLine line_;
  std::map<int, std::size_t> shots_;                // number to place in the line
  std::vector<std::map<int, Position>> positions_;  // per shot, by receiver
};

}  // namespace hawser
