#pragma once
// The lines of a CSV file: cells set apart by commas, each with its place. Blank lines and lines
// that begin with # are skipped. Strict: what another program might read otherwise is a fault.
#include <string>
#include <vector>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {

struct CsvCell {
  std::string text;  ///< without blanks at either end
  int column = 1;    ///< in characters, from 1
};

struct CsvLine {
  int number = 0;  ///< from 1
  std::vector<CsvCell> cells;
};

struct Csv {
  std::string file;
  CsvLine header;
  std::vector<CsvLine> rows;  ///< each with as many cells as the header

  Location place(const CsvLine& line, std::size_t cell) const {
    return {file, line.number, line.cells.at(cell).column};
  }
};

/// Faults go to `diagnostics`: a byte-order mark, quotes, other separators, what is no text, rows
/// that do not fit the header, no rows. What is returned after a fault is not to be used.
Csv read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics);

/// Faults of one kind that are told one by one; a file of a million rows has the same one in each.
constexpr int most_told = 5;

}  // namespace hawser
