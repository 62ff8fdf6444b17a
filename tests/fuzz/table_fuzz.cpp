// Any bytes as a table: it is read or refused with a place; nothing crashes, overflows or takes
// long. The first byte says what the deck says beside the file.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fuzz.hpp"
#include "hawser/base/error.hpp"
#include "values/tests/table_reading.hpp"

namespace {

using namespace hawser;

TableText asked_for(std::uint8_t choice, const std::string& text) {
  TableDeck deck;
  deck.name = {"t", {"d.xml", 2, 3}};
  if (choice & 128U)
    deck.direction =
        Located<std::string>{choice & 1U ? "going-to" : "coming-from", {"d.xml", 2, 4}};
  if (choice & 2U) deck.missing = {"-999", "NaN"};
  if (choice & 4U) deck.longest_gap = 100;
  if (choice & 8U) deck.origin = Located<std::vector<double>>{{5e5, 6e6}, {"d.xml", 1, 1}};
  if (choice & 16U) deck.smooth = Located<double>{30, {"d.xml", 1, 2}};
  deck.relative = (choice & 32U) != 0;
  if ((choice & 65U) == 65U) return {text, scalar("heat", "K"), deck};
  return {text, choice & 64U ? displacement() : velocity(), deck};
}

void expect_finite(const Table& table, double time) {
  std::vector<double> found(static_cast<std::size_t>(table.components()));
  const auto check = [&] {
    if (!std::all_of(found.begin(), found.end(), [](double v) { return std::isfinite(v); }))
      broken("a value is not finite at t = " + std::to_string(time) + " s");
  };
  try {
    table.value(at(time), found.data());
  } catch (const DeckError&) {
    return;  // not over this place
  }
  check();
  table.time_derivative(at(time), found.data());
  check();
}

bool is_placed(const std::string& fault) {
  int line = 0, column = 0;
  return (std::sscanf(fault.c_str(), "t.csv:%d:%d: ", &line, &column) == 2 ||
          std::sscanf(fault.c_str(), "d.xml:%d:%d: ", &line, &column) == 2) &&
         line > 0 && column > 0;
}

}  // namespace

std::vector<std::string> good_inputs() {
  std::string fixes = "time_s,x_m,y_m\n";
  for (int i = 0; i < 30; ++i)
    fixes +=
        std::to_string(10 * i) + "," + std::to_string(i % 3) + "," + std::to_string(4 * i) + "\n";
  const std::string texts[] = {
      fixes,
      "t_s,speed_kn,direction_deg\n0,1,350\n900,1.2,10\n1800,0.9,20\n",
      "time_s,easting_m,northing_m,u [m/s],v [m/s]\n0,499000,5999000,0,0\n"
      "0,501000,5999000,0,1\n0,499000,6001000,1,0\n0,501000,6001000,1,1\n",
      "time_s,displacement_x_m,displacement_y_m\n0,0,0\n600,0,120\n1200,0,240\n",
      "z_m,heat_K\n-100,280\n-50,281\n0,290\n",
      "time_s,speed_kn,direction_deg\n0,1,350\n10,1.5,10\n",
      "t_s,x_m,easting_km,northing_m,u [m/s],v_cm_per_s\n0,0,500,6e6,1,2\n",
      "time_h,x_m,y_m\n0,0,0\n1,-999,1\n2,1,2\n3,2,3\n",
      "# tide\ntime_h,velocity_x_m_per_s,velocity_y_cm_per_s\n0,0,-50\n1,0.1,-45\n2,.2,-4e1\n",
      "t_s,z_m,velocity_x_m_per_s,velocity_y_m_per_s\n0,-9,1,2\n0,0,1,1\n5,-9,1,3\n5,0,0,0\n"};
  std::vector<std::string> inputs;
  for (const std::string& text : texts)
    for (unsigned choice = 0; choice < 256; choice += 5)
      inputs.push_back(static_cast<char>(choice) + text);
  return inputs;
}

Answer answer_to(const std::string& input) {
  if (input.empty()) return Answer::refused;
  const TableReading reading =
      read(asked_for(static_cast<std::uint8_t>(input[0]), input.substr(1)));
  if (reading.table ? !reading.faults.empty() : !every_line(reading.faults, is_placed))
    broken("refused without a place: " + reading.faults);
  if (!reading.table) return Answer::refused;
  const Span span = reading.table->span();
  for (const double share : {0.0, 0.3, 1.0})
    expect_finite(*reading.table,
                  std::isfinite(span.from) ? span.from + share * (span.until - span.from) : 0);
  return Answer::read;
}
