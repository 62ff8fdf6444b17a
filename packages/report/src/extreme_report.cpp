#include "src/extreme_report.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "hawser/fields/look_up.hpp"

namespace hawser {
namespace {

/// Of a linear formula the vertices have the extremes; else the points of a lattice come close.
Quadrature candidates(CellShape shape, int degree) {
  constexpr int parts = 4;
  return lattice(shape, degree <= 1 ? 1 : parts);
}

/// A value, the least number of the cells that have it, and the place.
struct Candidate {
  double value = std::numeric_limits<double>::infinity();
  GlobalIndex cell = std::numeric_limits<GlobalIndex>::max();
  std::array<double, 3> place{};

  bool before(const Candidate& other) const {
    return value < other.value || (value == other.value && cell < other.cell);
  }
};

/// The first of all ranks' candidates, on every rank.
Candidate first_of(const Communicator& communicator, const Candidate& mine) {
  Candidate result;
  result.value = communicator.min(mine.value);
  GlobalIndex cell = mine.value == result.value ? mine.cell : result.cell;
  MPI_Allreduce(&cell, &result.cell, 1, MPI_LONG_LONG, MPI_MIN, communicator.mpi());
  const bool is_mine = mine.value == result.value && mine.cell == result.cell;
  for (std::size_t j = 0; j < 3; ++j)
    result.place[j] = communicator.sum(is_mine ? mine.place[j] : 0.0);
  return result;
}

}  // namespace

Spec<ExtremeDeck> ExtremeDeck::spec() {
  using P = ExtremeDeck;
  return Spec<P>(
             "extreme",
             "Reports the least and the greatest value of a formula on a region as it has "
             "moved, NAME_min and NAME_max, and their places. A linear formula of linear fields "
             "has them at vertices; any other is looked at on a lattice of quarters of every "
             "edge.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute(
          "of", &P::of, "SI", required() && any(),
          "A formula of place, time, fields and their derivatives; on a boundary of normal_x "
          "and normal_y, too.")
      .attribute("on", &P::on, required(), "Region: a body, a line, a boundary.")
      .attribute("unit", &P::unit, absent("that of the field, where the formula is one, else 1"),
                 "Unit of the values, for their names: nothing is converted.")
      .check(check_name_and_unit<P>)
      .source("doc/decks.md");
}

ExtremeReport::ExtremeReport(const ExtremeDeck& deck, const ReportContext& context,
                             Diagnostics& diagnostics)
    : communicator_(context.mesh().communicator),
      dimension_(context.mesh().dimension),
      deck_(deck),
      instant_(context) {
  const Region* const region = find_region(context.mesh(), deck.on, diagnostics);
  if (region == nullptr) return;
  if (region->dimension == 0) {
    diagnostics.error(deck.on.location, "region '" + region->name +
                                            "' is a point, which has no extremes; a <probe> gives "
                                            "the value there");
    return;
  }
  sampling_.emplace(context.dofs(), *region, deck.of, moving_field(context.dofs()), candidates,
                    diagnostics);
  instant_.look_at(sampling_->formula());
  if (deck_.unit.empty()) deck_.unit = sampling_->formula().plain_unit(context.dofs());
}

std::vector<Column> ExtremeReport::columns() const {
  std::vector<Column> columns;
  for (const char* const which : {"_min", "_max"}) {
    columns.push_back({deck_.name + which, deck_.unit});
    for (int j = 0; j < dimension_; ++j)
      columns.push_back({deck_.name + which + "_" + static_cast<char>('x' + j), "m"});
  }
  return columns;
}

std::vector<double> ExtremeReport::measure(const Step& step) {
  Candidate least, greatest;  // of the value, and of its negative
  const auto keep = [](Candidate& best, double value, const RegionSampling::Sample& at) {
    const Candidate found{value, at.cell, {at.place.x, at.place.y, at.place.z}};
    if (found.before(best)) best = found;
  };
  communicator_.together([&] {
    sampling_->visit(instant_(step), [&](const RegionSampling::Sample& at) {
      keep(least, at.value, at);
      keep(greatest, -at.value, at);
    });
  });
  std::vector<double> values;
  for (const auto& [mine, sign] : {std::pair{least, 1.0}, std::pair{greatest, -1.0}}) {
    const Candidate first = first_of(communicator_, mine);
    values.push_back(sign * first.value);
    values.insert(values.end(), first.place.begin(), first.place.begin() + dimension_);
  }
  return values;
}

}  // namespace hawser
