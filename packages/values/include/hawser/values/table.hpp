#pragma once
// Values measured or forecast elsewhere, as a CSV file whose columns are named by quantity and unit
// (doc/tables.md):
//
//   time_h,velocity_x_m_per_s,velocity_y_m_per_s        time_s,x_km,y_km,speed_kn,direction_deg
//   0,0,-0.5                                            0,-5,-6,0.9,180
//   1,0.1,-0.45                                         ...
//
// Time and place (where the moving point is now), each at most once, are what the values depend on;
// the rows fill a grid: every time with every x with every y. Linear between, or smoothed over
// time; there is no value outside. A table of positions gives a point's displacement.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hawser/values/column.hpp"
#include "hawser/values/smoothing_spline.hpp"
#include "hawser/values/table_deck.hpp"
#include "hawser/values/value_source.hpp"

namespace hawser {

class Table : public ValueSource {
 public:
  /// Reads `text`, the content of the file that `deck` names. Null after a fault, each of which is
  /// told with file, line and column.
  static std::shared_ptr<const Table> read(const std::string& text, const TableDeck& deck,
                                           const WantedValues& wanted, Diagnostics& diagnostics);

  int components() const override { return components_; }
  void value(const SpaceTime& at, double* values) const override;
  void time_derivative(const SpaceTime& at, double* rates) const override;
  void gradient(const SpaceTime& at, int component, double* slope) const override;
  bool depends_on_moved_position(int component) const override;
  using ValueSource::depends_on_moved_position;
  Span span() const override { return span_of(t); }
  Span reach(int axis) const override { return span_of(x + axis); }
  bool places_a_point() const override { return is_position_ && !relative_; }

 private:
  friend class TableReader;
  Table() = default;

  enum Variable { t, x, y, z, variables };
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

  Span span_of(int variable) const;
  Places locate(const SpaceTime& at) const;
  /// Interpolates; along `slope_along`, if it is a variable, the slope instead.
  double interpolate(const Places& places, int component, int slope_along) const;
  void smooth(double period);
  /// Displacements from now on count from the value at t = 0, or the nearest time that there is.
  void count_from_start();

  std::string file_;
  std::array<Axis, variables> axes_;
  int components_ = 0;
  std::vector<double> values_;            // [row of the grid][component]
  std::vector<SmoothingSpline> splines_;  // per component; empty: linear
  bool is_position_ = false;              // values are where a point is, of which it starts at X
  std::size_t first_component_ = 0;       // of those of the field
  bool relative_ = false;
  std::vector<double> start_;  // per component, from where values count
};

}  // namespace hawser
