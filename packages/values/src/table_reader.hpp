#pragma once
// From the text of a file to a Table: its rows put into a grid.
#include "hawser/values/table.hpp"
#include "src/table_rows.hpp"

namespace hawser {

class TableReader {
 public:
  TableReader(const TableDeck& deck, const WantedValues& wanted, Diagnostics& diagnostics)
      : deck_(deck), wanted_(wanted), diagnostics_(diagnostics) {}
  std::shared_ptr<const Table> read(const std::string& text);

 private:
  bool over_time_alone() const;
  void check_order();
  void check_gaps();
  void check_roughness();
  void check_options();
  void fill_grid(Table& table);
  Location place(const TableRow& row) const { return {csv_.file, row.line->number, 1}; }

  const TableDeck& deck_;
  const WantedValues& wanted_;
  Diagnostics& diagnostics_;
  Csv csv_;
  TableRows rows_;
};

}  // namespace hawser
