// Mutants of good tables: each is read or refused with its place, none crashes, and none that is
// read has a value that is not finite. Deterministic: mutant n is the same every time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "hawser/base/error.hpp"
#include "table_reading.hpp"

namespace hawser {
namespace {

constexpr unsigned mutants = 10000;

std::vector<TableText> good_tables() {
  TableDeck chart = with_origin(500000, 6000000);
  chart.missing = {"-999", "NaN"};
  chart.longest_gap = 1000;
  TableDeck smooth = with_smoothing(30);
  smooth.relative = true;
  std::string fixes = "time_s,x_m,y_m\n";
  for (int i = 0; i < 30; ++i)
    fixes +=
        std::to_string(10 * i) + "," + std::to_string(i % 3) + "," + std::to_string(4 * i) + "\n";
  return {
      {"# tide\ntime_h,velocity_x_m_per_s,velocity_y_cm_per_s\n0,0,-50\n1,0.1,-45\n2,.2,-4e1\n"},
      {"t_s,speed_kn,direction_deg\n0,1,350\n900,1.2,10\n1800,0.9,20\n", velocity(),
       with_direction("coming-from")},
      {"time_s,easting_m,northing_m,u [m/s],v [m/s]\n0,499000,5999000,0,0\n"
       "0,501000,5999000,0,1\n0,499000,6001000,1,0\n0,501000,6001000,1,1\n",
       velocity(), chart},
      {"time_s,displacement_x_m,displacement_y_m\n0,0,0\n600,0,120\n1200,0,240\n", displacement()},
      {fixes, displacement(), smooth},
      {"z_m,heat_K\n-100,280\n-50,281\n0,290\n", scalar("heat", "K"), with_missing({"none"})}};
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  std::string mutated(std::string text) {
    for (std::size_t i = 0, count = 1 + below(3); i < count; ++i)
      mutate(text);
    return text;
  }

 private:
  void mutate(std::string& text) {
    static const std::vector<std::string> odd = {"nan",
                                                 "inf",
                                                 "1e400",
                                                 "-1e-400",
                                                 "99999999999999",
                                                 "0x10",
                                                 "\"",
                                                 "'",
                                                 ";",
                                                 "\t",
                                                 "|",
                                                 ",",
                                                 ",,",
                                                 "\n",
                                                 "\n\n",
                                                 "\r",
                                                 "\r\n",
                                                 "-999",
                                                 "#",
                                                 "1e20",
                                                 "time",
                                                 "_m",
                                                 "_s",
                                                 "_kn",
                                                 "x_m",
                                                 "u_kn",
                                                 "speed_kn",
                                                 "direction_deg",
                                                 "[m/s]",
                                                 "(",
                                                 ")",
                                                 "^",
                                                 "_per_",
                                                 "deg",
                                                 "\xEF\xBB\xBF",
                                                 "\xff\xfe",
                                                 "\xc3",
                                                 "-",
                                                 "+",
                                                 "e",
                                                 ".",
                                                 "1,5",
                                                 "2024-05-01",
                                                 "12:30",
                                                 "NaN"};
    const std::size_t at = below(text.size() + 1);
    switch (below(9)) {
      case 0: text.erase(at, below(8)); break;
      case 1: text.insert(at, odd[below(odd.size())]); break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_() & 0xFF);
        break;
      case 3: text.insert(at, text.substr(below(text.size() + 1), below(200))); break;
      case 4: text.erase(at, below(300)); break;
      case 5: replace_cell(text, odd[below(odd.size())]); break;
      case 6: swap_lines(text); break;
      case 7:
        if (at + 1 < text.size()) std::swap(text[at], text[at + 1]);
        break;
      default: text.insert(at, std::string(below(5000), odd[below(odd.size())][0])); break;
    }
  }

  void replace_cell(std::string& text, const std::string& by) {
    const std::size_t begin = text.find_first_of(",\n", below(text.size() + 1));
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_of(",\n", begin + 1), text.size());
    text.replace(begin + 1, end - begin - 1, by);
  }

  void swap_lines(std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    if (lines.empty()) return;
    std::swap(lines[below(lines.size())], lines[below(lines.size())]);
    text.clear();
    for (const std::string& line : lines)
      text += line + "\n";
  }

  std::mt19937 random_;
};

/// "t.csv:3:9: sentence", or a place of the deck.
bool names_places(const std::string& faults) {
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);) {
    int number = 0, column = 0;
    const bool table = std::sscanf(line.c_str(), "t.csv:%d:%d: ", &number, &column) == 2;
    const bool deck = std::sscanf(line.c_str(), "d.xml:%d:%d: ", &number, &column) == 2;
    if (!(table || deck) || number < 1 || column < 1) return false;
  }
  return true;
}

void expect_finite(const Table& table) {
  const Span span = table.span();
  for (const double share : {0.0, 0.3, 1.0}) {
    SpaceTime point =
        at(std::isfinite(span.from) ? span.from + share * (span.until - span.from) : 0);
    std::vector<double> found(static_cast<std::size_t>(table.components()));
    try {
      table.value(point, found.data());
    } catch (const DeckError&) {
      continue;  // not over this place
    }
    EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](double v) { return std::isfinite(v); }));
    table.time_derivative(point, found.data());
    EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](double v) { return std::isfinite(v); }));
  }
}

TEST(TableMutants, AreReadOrRefusedWithTheirPlace) {
  const std::vector<TableText> good = good_tables();
  for (const TableText& table : good)
    EXPECT_EQ(read(table).faults, "");
  unsigned refused = 0;
  for (unsigned seed = 0; seed < mutants; ++seed) {
    Mutator mutator(seed);
    TableText mutant = good[mutator.below(good.size())];
    mutant.text = mutator.mutated(mutant.text);
    const TableReading reading = read(mutant);
    ASSERT_EQ(reading.table == nullptr, !reading.faults.empty()) << seed;
    ASSERT_TRUE(names_places(reading.faults)) << seed << ": " << reading.faults;
    if (reading.table)
      expect_finite(*reading.table);
    else
      ++refused;
    ASSERT_FALSE(testing::Test::HasFailure()) << seed << "\n" << mutant.text;
  }
  EXPECT_GT(refused, mutants / 2);
  std::printf("%u of %u tables read or refused with their place; %u refused\n", mutants, mutants,
              refused);
}

}  // namespace
}  // namespace hawser
