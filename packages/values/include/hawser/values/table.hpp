#pragma once
// Values measured or forecast elsewhere, as a CSV file:
//
//   t_s,velocity_x,velocity_y        t_s,x_m,y_m,velocity_x,velocity_y
//   0,0,-0.5                         0,-5000,-6000,0,-0.5
//   3600,0.1,-0.45                   ...
//
// The first line names the columns: t (s), x and y (m, where the moving point is now), each at most
// once; every further column is a component, in its order. A name may end in its unit: t or t_s.
// The rows, in any order, fill a grid: every t with every x with every y. Linear between; there is
// no value outside.
#include <array>
#include <string>
#include <vector>

#include "hawser/values/value_source.hpp"

namespace hawser {

class Table : public ValueSource {
 public:
  /// `file` appears in messages. Throws DeckError "file:line: what is wrong".
  Table(const std::string& text, const std::string& file);

  int components() const override { return components_; }
  void value(const SpaceTime& at, double* values) const override;
  void time_derivative(const SpaceTime& at, double* rates) const override;
  void gradient(const SpaceTime& at, int component, double* slope) const override;
  bool depends_on_moved_position(int component) const override;
  using ValueSource::depends_on_moved_position;

 private:
  enum Variable { t, x, y, variables };
  struct Axis {
    std::vector<double> knots;  // increasing; empty: no such column
    std::size_t stride = 0;     // in values_, in rows
  };
  /// The cell that holds a value, and the place in it.
  struct Place {
    std::size_t first = 0;
    double share = 0;  // 0 at the first knot, 1 at the next
    double width = 0;  // of the cell; 0: one knot only
  };
  using Places = std::array<Place, variables>;

  Places locate(const SpaceTime& at) const;
  /// Interpolates; along `slope_along`, if it is a variable, the slope instead.
  double interpolate(const Places& places, int component, int slope_along) const;

  std::string file_;
  std::array<Axis, variables> axes_;
  int components_ = 0;
  std::vector<double> values_;  // [row of the grid][component]
};

}  // namespace hawser
