// For libFuzzer of clang: any bytes as a table. A table is read or refused with a place; nothing
// crashes, overflows or takes long. tests/fuzz/run compiles and runs it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "values/tests/table_reading.hpp"

namespace {

using namespace hawser;

TableText asked_for(std::uint8_t choice, const std::string& text) {
  TableDeck deck = with_direction(choice & 1U ? "going-to" : "coming-from");
  if (choice & 2U) deck.missing = {"-999", "NaN"};
  if (choice & 4U) deck.longest_gap = 100;
  if (choice & 8U) deck.origin = Located<std::vector<double>>{{5e5, 6e6}, {"d.xml", 1, 1}};
  if (choice & 16U) deck.smooth = Located<double>{30, {"d.xml", 1, 2}};
  deck.relative = (choice & 32U) != 0;
  return {text, choice & 64U ? displacement() : velocity(), deck};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const TableReading reading =
      read(asked_for(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1}));
  int line = 0, column = 0;
  const bool placed = std::sscanf(reading.faults.c_str(), "t.csv:%d:%d: ", &line, &column) == 2 ||
                      std::sscanf(reading.faults.c_str(), "d.xml:%d:%d: ", &line, &column) == 2;
  if (reading.table ? !reading.faults.empty() : !placed) std::abort();
  if (!reading.table) return 0;
  const Span span = reading.table->span();
  SpaceTime point;
  point.t = span.covers(0, 0) ? 0 : span.from;
  double numbers[2];
  try {
    reading.table->value(point, numbers);
    reading.table->time_derivative(point, numbers);
  } catch (const std::exception&) {
    return 0;  // not over this place
  }
  return 0;
}
