// What conditions say that does not fit together, told before the first step.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/conditions/conditions.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {

std::vector<double> gather(const Communicator& communicator, const std::vector<double>& mine) {
  std::vector<int> counts(static_cast<std::size_t>(communicator.size())), starts(counts.size(), 0);
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator.mpi());
  for (std::size_t r = 1; r < counts.size(); ++r)
    starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<double> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(),
                 MPI_DOUBLE, communicator.mpi());
  return all;
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// "(0, 1), (1, 1) and 3 more".
std::string listed_places(const std::vector<std::array<double, 3>>& places, int dimension) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
    text += i == 0 ? "(" : ", (";
    for (int j = 0; j < dimension; ++j)
      text += (j == 0 ? "" : ", ") + number(places[i][static_cast<std::size_t>(j)]);
    text += ")";
  }
  if (places.size() > most) text += " and " + std::to_string(places.size() - most) + " more";
  return text;
}

}  // namespace

/// Of two entries, at one node.
struct Conditions::Disagreement {
  double first, second;        // entries, numbers in prescribed_
  double component, was, now;  // of the row: its component, the two values
  double time;                 // s
  double place[3];             // m, reference
};

std::vector<Conditions::Disagreement> Conditions::disagreements(const State& start,
                                                                const RunSpan& span) const {
  constexpr double tolerance = 1e-6;   // of the greater values that either prescribes
  constexpr double round_off = 1e-12;  // of formulas that come to zero, in SI units
  std::vector<double> mine;
  constexpr std::size_t size = sizeof(Disagreement) / sizeof(double);
  const double length = span.end - span.begin;
  std::vector<double> times = {span.end};
  if (!span.steady) times = {span.begin + span.first_step, span.begin + length / 2, span.end};
  std::map<std::array<std::size_t, 3>, bool> told;  // two entries and a row
  for (const double time : times) {
    State state = start;
    state.time = time;
    state.step = span.steady ? std::numeric_limits<double>::infinity() : span.first_step;
    std::vector<int> last(static_cast<std::size_t>(dofs_.rows()), -1);
    std::vector<double> value(last.size(), 0), greatest(prescribed_.size(), 0);
    for (std::size_t e = 0; e < prescribed_.size(); ++e) {
      std::vector<PrescribedRow> rows;
      try {
        prescribe(prescribed_[e], state, state, rows);
      } catch (const Error&) {
        continue;  // a value that cannot be had then is told when it is wanted
      }
      for (const PrescribedRow& row : rows)
        greatest[e] = std::max(greatest[e], std::abs(row.value));
      for (const PrescribedRow& row : rows) {
        const auto r = static_cast<std::size_t>(row.row);
        const int before = last[r];
        const double was = value[r];
        last[r] = static_cast<int>(e);
        value[r] = row.value;
        if (before < 0 || before == static_cast<int>(e) || prescribed_[e].replaces) continue;
        const auto first = static_cast<std::size_t>(before);
        if (std::abs(was - row.value) <=
            round_off + tolerance * std::max(greatest[first], greatest[e]))
          continue;
        if (!told.emplace(std::array{first, e, r}, true).second) continue;
        Disagreement found{
            double(first), double(e), double(dofs_.info(row.row).component), was, row.value,
            time,          {}};
        dofs_.position(row.row, found.place);
        const auto* const numbers = reinterpret_cast<const double*>(&found);
        mine.insert(mine.end(), numbers, numbers + size);
      }
    }
  }
  const std::vector<double> all = gather(dofs_.mesh().communicator, mine);
  std::vector<Disagreement> result(all.size() / size);
  std::copy(all.begin(), all.end(), reinterpret_cast<double*>(result.data()));
  return result;
}

// A displacement that is not where the initial values are gets there within the first step.
void Conditions::find_jumps(const State& start, const RunSpan& span,
                            Diagnostics& diagnostics) const {
  const Mesh& mesh = dofs_.mesh();
  const Communicator& communicator = mesh.communicator;
  double shortest = std::numeric_limits<double>::max();  // edge of the mesh, squared, m^2
  for (std::size_t e = 0; e + 1 < mesh.edge_ends.size(); e += 2) {
    double squared = 0;
    for (int j = 0; j < mesh.dimension; ++j)
      squared += std::pow(
          mesh.coordinates[static_cast<std::size_t>(mesh.dimension * mesh.edge_ends[e] + j)] -
              mesh.coordinates[static_cast<std::size_t>(mesh.dimension * mesh.edge_ends[e + 1] +
                                                        j)],
          2);
    shortest = std::min(shortest, squared);
  }
  shortest = std::sqrt(communicator.min(shortest));
  for (const Entry& entry : prescribed_) {
    double farthest = 0;
    std::array<double, 3> place{};
    if (entry.is_displacement && !entry.is_table && entry.from <= span.begin &&
        entry.until > span.begin) {
      const auto components = static_cast<std::size_t>(entry.source->components());
      std::vector<double> values(components);
      for (const LocalIndex first : entry.first_rows) {
        if (first >= dofs_.owned()) continue;
        try {
          SpaceTime at = point(first, start);
          at.t = span.begin;
          entry.source->value(at, values.data());
        } catch (const Error&) {
          break;
        }
        double squared = 0;
        for (std::size_t c = 0; c < components; ++c)
          squared += std::pow(
              values[c] - start.value[static_cast<std::size_t>(first + entry.first_component) + c],
              2);
        if (std::sqrt(squared) <= farthest) continue;
        farthest = std::sqrt(squared);
        dofs_.position(first, place.data());
      }
    }
    const double all = communicator.max(farthest);
    if (!(all > 0.01 * shortest)) continue;
    // Ranks without the farthest node leave the place to the first one that has it.
    std::vector<double> mine;
    if (farthest == all) mine.assign(place.begin(), place.end());
    const std::vector<double> places = gather(communicator, mine);
    diagnostics.note(entry.location,
                     "at the start, t = " + number(span.begin) + " s, the displacement on '" +
                         entry.on + "' is " + number(all) + " m from its initial value, at " +
                         listed_places({{places[0], places[1], places[2]}}, mesh.dimension) +
                         ": it gets there within the first step, of " + number(span.first_step) +
                         " s. Begin at 0 (a ramp), or give the same place as <initial>");
  }
}

void Conditions::look_ahead(const State& start, const RunSpan& span,
                            Diagnostics& diagnostics) const {
  for (const Entry& entry : prescribed_) {
    if (!span.shortened && entry.from >= span.end)
      diagnostics.note(entry.location, "it never holds: the run ends at t = " + number(span.end) +
                                           " s, and this from " + number(entry.from) + " s on");
    if (!span.finds_start && !span.steady && entry.until <= span.begin)
      diagnostics.note(entry.location,
                       "it never holds: the run begins at t = " + number(span.begin) +
                           " s, and this is until " + number(entry.until) + " s");
  }
  std::map<std::pair<double, double>, std::vector<Disagreement>> pairs;
  for (const Disagreement& one : disagreements(start, span))
    pairs[{one.second, one.first}].push_back(one);
  const int dimension = dofs_.mesh().dimension;
  for (auto& [pair, nodes] : pairs) {
    const auto key = [](const Disagreement& d) {
      return std::array{d.place[0], d.place[1], d.place[2], d.component, d.time};
    };
    std::sort(nodes.begin(), nodes.end(),
              [&](const Disagreement& a, const Disagreement& b) { return key(a) < key(b); });
    std::vector<std::array<double, 3>> places;
    for (const Disagreement& node : nodes) {
      const std::array<double, 3> place = {node.place[0], node.place[1], node.place[2]};
      if (places.empty() || places.back() != place) places.push_back(place);
    }
    const Entry& second = prescribed_[static_cast<std::size_t>(pair.first)];
    const Entry& first = prescribed_[static_cast<std::size_t>(pair.second)];
    const Disagreement& node = nodes.front();
    diagnostics.note(
        second.location,
        "'" + second.field + "' on '" + second.on + "' disagrees with '" + first.field + "' on '" +
            first.on + "' of " + first.location.text() + " at " + std::to_string(places.size()) +
            (places.size() == 1 ? " node" : " nodes") + " that both have, " +
            listed_places(places, dimension) + ": component " +
            static_cast<char>('x' + static_cast<int>(node.component)) + " is " + number(node.now) +
            " there, and was to be " + number(node.was) + " (t = " + number(node.time) +
            " s). The later one holds; say replaces=\"true\" in it where that is meant, else "
            "change their order");
  }
  if (!span.steady && !span.finds_start) find_jumps(start, span, diagnostics);
}

std::optional<std::vector<double>> Conditions::prescribed_velocity(LocalIndex vertex, double time,
                                                                   const State& state) const {
  const int velocity = dofs_.find(field_name::velocity);
  if (velocity < 0) return std::nullopt;
  const LocalIndex first = dofs_.first_row(velocity, PointKind::vertex, vertex);
  const auto count =
      static_cast<std::size_t>(dofs_.fields()[static_cast<std::size_t>(velocity)].components);
  std::vector<std::optional<double>> known(count);
  for (const Entry& entry : prescribed_) {
    if (first < 0 || time <= entry.from || time > entry.until) continue;
    for (const LocalIndex row : entry.first_rows) {
      const LocalIndex moves =
          entry.is_displacement ? velocity_of_[static_cast<std::size_t>(row)] : row;
      if (moves != first) continue;
      std::vector<double> values(static_cast<std::size_t>(entry.source->components()));
      SpaceTime at = point(row, state);
      at.t = time;
      if (entry.is_displacement)
        entry.source->time_derivative(at, values.data());
      else
        entry.source->value(at, values.data());
      for (std::size_t c = 0; c < values.size(); ++c)
        known[static_cast<std::size_t>(entry.first_component) + c] = values[c];
    }
  }
  std::vector<double> result;
  for (const auto& component : known) {
    if (!component) return std::nullopt;
    result.push_back(*component);
  }
  return result;
}

}  // namespace hawser
