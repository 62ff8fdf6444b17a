#pragma once
// The way of a ship: straight legs between way-points, turns between the legs, a ramped speed.
//
// In a turn by the angle a the heading follows a C2 ramp of the way sailed, a (10 s^3 - 15 s^4 +
// 6 s^5), over a length of 15/8 |a| R: its tightest place has the radius R. The turn leaves one leg
// and joins the next at equal distances from the way-point, which it cuts. The speed is ramped
// alike over time and is the same in turns. Hence the position is C3 in time, velocity and heading
// are C2. After the last way-point the track goes straight on.
#include <array>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"
#include "hawser/values/value_source.hpp"

namespace hawser {

struct WayPointDeck {
  std::vector<double> at;  ///< m
  static Spec<WayPointDeck> spec();
};

struct TrackDeck {
  Located<std::string> name;
  double speed = 0;        ///< m/s
  double start = 0;        ///< s
  double ramp = 100;       ///< s, from rest to speed; 0: at its speed always
  double turn_radius = 0;  ///< m, at the tightest place; needed when there is a turn
  std::vector<WayPointDeck> way_points;
  static Spec<TrackDeck> spec();
};

/// As values: the displacement from the first way-point.
class Track : public ValueSource {
 public:
  /// DeckError when the turns do not fit; what the spec accepts fits.
  explicit Track(const TrackDeck& deck);

  std::array<double, 2> position(double time) const;  ///< m
  std::array<double, 2> velocity(double time) const;  ///< m/s
  std::array<double, 2> course(
      double time) const;                    ///< unit vector; before the start the first leg's
  double distance(double time) const;        ///< m sailed
  double speed(double time) const;           ///< m/s
  double length() const { return length_; }  ///< m, to the last way-point

  int components() const override { return 2; }
  void value(const SpaceTime& at, double* values) const override;
  void time_derivative(const SpaceTime& at, double* rates) const override;
  void gradient(const SpaceTime& at, int component, double* slope) const override;
  bool depends_on_moved_position(int) const override { return false; }
  using ValueSource::depends_on_moved_position;

 private:
  friend struct TrackDeck;
  /// A leg (turn = 0) or a turn.
  struct Piece {
    std::array<double, 2> start{};  // m
    double heading = 0;             // rad, from +x counter-clockwise, at its start
    double turn = 0;                // rad
    double begin = 0, length = 0;   // m of way sailed
  };
  /// "" or what is wrong; `pieces` is filled.
  static std::string plan(const TrackDeck& deck, std::vector<Piece>& pieces);
  static double heading(const Piece& piece, double along);
  static std::array<double, 2> point(const Piece& piece, double along);
  const Piece& piece_at(double distance) const;

  double speed_, start_, ramp_, length_;
  std::vector<Piece> pieces_;
};

}  // namespace hawser
