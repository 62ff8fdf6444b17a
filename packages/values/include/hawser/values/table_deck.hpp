#pragma once
// What a deck says of a table: how a file of measured or forecast values is to be read.
//
//   <table name="adcp" file="adcp.csv" direction="going-to" missing="-999" longest-gap="10 min"/>
//   <prescribe field="velocity" on="inflow" table="adcp"/>
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

struct TableDeck {
  Located<std::string> name, file;
  std::optional<Located<std::string>> direction;  ///< "coming-from" or "going-to"
  std::vector<std::string> ignore;                ///< columns that are not read
  std::vector<std::string> missing;   ///< words that stand for no value; "none": every value is one
  std::optional<double> longest_gap;  ///< s, bridged by a straight line
  std::optional<Located<std::vector<double>>> origin;  ///< m, easting and northing of x = y = 0
  double time_origin = 0;                              ///< s, the table's time at t = 0
  bool relative = false;                  ///< displacements count from the table's at t = 0
  std::optional<Located<double>> smooth;  ///< s, SmoothingSpline::period; 0: as it is
  static Spec<TableDeck> spec();

  bool is_missing(const std::string& word) const;
  bool takes_all() const;  ///< no value is taken for a fill value
};

/// The one of that name; null when there is none.
const TableDeck* find_table(const std::vector<TableDeck>& tables, const std::string& name);

/// A name given twice is a fault.
void check_names(const std::vector<TableDeck>& tables, Diagnostics& diagnostics);

}  // namespace hawser
