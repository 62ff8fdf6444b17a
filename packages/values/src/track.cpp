#include "hawser/values/track.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/constants.hpp"
#include "hawser/base/error.hpp"
#include "hawser/deck/ramp.hpp"

namespace hawser {
namespace {

constexpr double steepest_ramp = 1.875;  // of 10 s^3 - 15 s^4 + 6 s^5, at s = 1/2

/// The turn from one heading to another, in (-pi, pi].
double turn_between(double from, double to) { return std::remainder(to - from, 2 * pi); }

}  // namespace

Spec<WayPointDeck> WayPointDeck::spec() {
  return Spec<WayPointDeck>("way-point", "A point of a track.")
      .attribute("at", &WayPointDeck::at, "m", required() && length(2) && any(), "Where it is.");
}

Spec<TrackDeck> TrackDeck::spec() {
  using P = TrackDeck;
  return Spec<P>("track", "A way through way-points at a constant speed, smoothed in its turns.")
      .attribute("name", &P::name, required(), "What conditions and <tow> call it.")
      .attribute("speed", &P::speed, "m/s", required() && positive(), "On legs and in turns.")
      .attribute("start", &P::start, "s", any(), "When it sets out from the first way-point.")
      .attribute("ramp", &P::ramp, "s", non_negative(),
                 "Time from rest to its speed; 0 for one that is at its speed before the start, "
                 "too, and passes the first way-point then.")
      .attribute("turn-radius", &P::turn_radius, "m", non_negative(),
                 "Of a turn at its tightest place.")
      .children(&P::way_points, required())
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        std::vector<Track::Piece> pieces;
        const std::string fault = Track::plan(p, pieces);
        if (!fault.empty()) diagnostics.error(where, fault);
      });
}

std::string Track::plan(const TrackDeck& deck, std::vector<Piece>& pieces) {
  const auto& points = deck.way_points;
  const std::string who = "track '" + deck.name.value + "': ";
  if (points.size() < 2) return who + "at least two way-points are needed";
  std::vector<double> headings, lengths;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double dx = points[i + 1].at[0] - points[i].at[0];
    const double dy = points[i + 1].at[1] - points[i].at[1];
    if (dx == 0 && dy == 0)
      return who + "way-points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
             " are the same";
    headings.push_back(std::atan2(dy, dx));
    lengths.push_back(std::hypot(dx, dy));
  }
  double begin = 0, before = 0;  // way sailed; what the last turn took of this leg
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    Piece turn;
    double after = 0;  // what the next turn takes of this leg
    if (i + 1 < lengths.size()) {
      turn.heading = headings[i];
      turn.turn = turn_between(headings[i], headings[i + 1]);
      if (std::abs(turn.turn) > 1e-12) {
        const std::string place = "at way-point " + std::to_string(i + 2);
        if (!(deck.turn_radius > 0))
          return who + "the turn " + place + " needs a turn-radius greater than 0";
        if (std::abs(turn.turn) > 0.999 * pi)
          return who + "the track turns back on itself " + place +
                 "; set way-points for a turn of less than 180 degrees each";
        turn.length = steepest_ramp * std::abs(turn.turn) * deck.turn_radius;
        const auto end = point(turn, turn.length);
        after = 0.5 * std::hypot(end[0], end[1]) / std::cos(0.5 * turn.turn);
      }
    }
    if (before + after > lengths[i] * (1 + 1e-12))
      return who + "the leg from way-point " + std::to_string(i + 1) + " to " +
             std::to_string(i + 2) + " is " + write_value(lengths[i]) +
             " m long, and its turns need " + write_value(std::round(before + after)) +
             " m of it; take a smaller turn-radius or longer legs";
    const double c = std::cos(headings[i]), s = std::sin(headings[i]);
    const auto on_leg = [&](double along) {
      return std::array<double, 2>{points[i].at[0] + along * c, points[i].at[1] + along * s};
    };
    pieces.push_back({on_leg(before), headings[i], 0, begin, lengths[i] - before - after});
    begin += pieces.back().length;
    if (after > 0) {
      turn.start = on_leg(lengths[i] - after);
      turn.begin = begin;
      begin += turn.length;
      pieces.push_back(turn);
    }
    before = after;
  }
  return "";
}

Track::Track(const TrackDeck& deck) : speed_(deck.speed), start_(deck.start), ramp_(deck.ramp) {
  const std::string fault = plan(deck, pieces_);
  if (!fault.empty()) throw DeckError(deck.name.location.text() + ": " + fault);
  length_ = pieces_.back().begin + pieces_.back().length;
}

double Track::heading(const Piece& piece, double along) {
  return piece.turn == 0 ? piece.heading
                         : piece.heading + piece.turn * ramp(along, 0, piece.length);
}

std::array<double, 2> Track::point(const Piece& piece, double along) {
  if (piece.turn == 0)
    return {piece.start[0] + along * std::cos(piece.heading),
            piece.start[1] + along * std::sin(piece.heading)};
  // Gauss' rule of five points on panels of at most an eighth of the turn: exact to round-off.
  constexpr double nodes[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  constexpr int panels = 8;
  std::array<double, 2> result = piece.start;
  const double half = 0.5 * along / panels;
  const auto add = [&](double s, double weight) {
    const double angle = heading(piece, s);
    result[0] += weight * half * std::cos(angle);
    result[1] += weight * half * std::sin(angle);
  };
  for (int p = 0; p < panels; ++p) {
    const double middle = (2 * p + 1) * half;
    add(middle, weights[0]);
    for (int k = 1; k < 3; ++k)
      for (const double sign : {-1.0, 1.0})
        add(middle + sign * half * nodes[k], weights[k]);
  }
  return result;
}

const Track::Piece& Track::piece_at(double distance) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), distance,
                                      [](double d, const Piece& piece) { return d < piece.begin; });
  return after == pieces_.begin() ? pieces_.front() : *(after - 1);
}

double Track::distance(double time) const {
  return speed_ * (ramp_ > 0 ? ramp_distance(time, start_, ramp_) : time - start_);
}
double Track::speed(double time) const {
  return ramp_ > 0 ? speed_ * ramp(time, start_, ramp_) : speed_;
}

std::array<double, 2> Track::position(double time) const {
  const double sailed = distance(time);
  const Piece& piece = piece_at(sailed);
  return point(piece, sailed - piece.begin);
}

std::array<double, 2> Track::course(double time) const {
  const double sailed = distance(time);
  const Piece& piece = piece_at(sailed);
  const double angle = heading(piece, sailed - piece.begin);
  return {std::cos(angle), std::sin(angle)};
}

std::array<double, 2> Track::velocity(double time) const {
  const auto direction = course(time);
  return {speed(time) * direction[0], speed(time) * direction[1]};
}

void Track::value(const SpaceTime& at, double* values) const {
  const auto now = position(at.t);
  for (std::size_t j = 0; j < 2; ++j)
    values[j] = now[j] - pieces_.front().start[j];
}

void Track::time_derivative(const SpaceTime& at, double* rates) const {
  const auto now = velocity(at.t);
  std::copy(now.begin(), now.end(), rates);
}

void Track::gradient(const SpaceTime&, int, double* slope) const { std::fill_n(slope, 3, 0.0); }

}  // namespace hawser
