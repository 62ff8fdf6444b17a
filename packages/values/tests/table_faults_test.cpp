// What tables may not be: every kind of fault, with variations, is told with file, line, column and
// what to do.
#include <gmock/gmock.h>

#include <algorithm>

#include "table_reading.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A table with a fault, and what is to be said: where, and words of the sentence.
struct Faulty {
  TableText table;
  std::string place, words;
};

class Faults : public testing::TestWithParam<Faulty> {};
TEST_P(Faults, AreToldWithTheirPlaceAndWhatToDo) {
  const TableReading reading = read(GetParam().table);
  EXPECT_EQ(reading.table, nullptr);
  EXPECT_THAT(reading.faults, StartsWith(GetParam().place + ": ")) << GetParam().table.text;
  EXPECT_THAT(reading.faults, HasSubstr(GetParam().words)) << GetParam().table.text;
}

#define FAULTS(name, ...) INSTANTIATE_TEST_SUITE_P(name, Faults, testing::Values(__VA_ARGS__))

const std::string head = "time_s,velocity_x_m_per_s,velocity_y_m_per_s\n";
const std::string track = "time_s,displacement_x_m,displacement_y_m\n";

Faulty current(const std::string& rows, const std::string& place, const std::string& words,
               TableDeck deck = {}) {
  return {{head + rows, velocity(), std::move(deck)}, place, words};
}
Faulty header(const std::string& names, const std::string& place, const std::string& words,
              TableDeck deck = {}) {
  return {{names + "\n0,0,0\n", velocity(), std::move(deck)}, place, words};
}
Faulty way(const std::string& names, const std::string& place, const std::string& words,
           TableDeck deck = {}) {
  return {{names + "\n0,0,0\n600,0,120\n", displacement(), std::move(deck)}, place, words};
}

FAULTS(NoUnit,
       way("t_s,displacement_x,displacement_y", "t.csv:1:5",
           "'displacement_x' says no unit; the header would be "
           "'t_s,displacement_x_m,displacement_y_m', if that is what its numbers are in"),
       way("t,displacement_x_m,displacement_y_m", "t.csv:1:1",
           "'t' says no unit; the header would be 't_s,displacement_x_m,displacement_y_m'"),
       way("time_s,x,y", "t.csv:1:8", "the header would be 'time_s,x_m,y_m'"),
       way("time_s,easting,northing", "t.csv:1:8", "'time_s,easting_m,northing_m'"),
       header("t_s,u,v", "t.csv:1:5", "'t_s,u_m_per_s,v_m_per_s'"),
       header("time,u,v", "t.csv:1:1", "'time_s,u_m_per_s,v_m_per_s'"),
       header("t_s,velocity_x,velocity_y", "t.csv:1:5",
              "'t_s,velocity_x_m_per_s,velocity_y_m_per_s'"),
       header("t_s,speed,direction", "t.csv:1:5", "'t_s,speed_m_per_s,direction_deg'"),
       header("t_s,speed_kn,direction", "t.csv:1:14", "'t_s,speed_kn,direction_deg'"),
       header("t_s,velocity_x_,velocity_y_kn", "t.csv:1:5", "says no unit"));

FAULTS(WrongUnit,
       header("time_m,u_kn,v_kn", "t.csv:1:1",
              "the column 'time_m' is in m, and time is a quantity in s, such as 'time_s'"),
       header("time_s,u_m,v_kn", "t.csv:1:8", "'u_m' is in m, and u is a quantity in m/s"),
       header("time_s,u_kn,v_s", "t.csv:1:13", "'v_s' is in s"),
       header("time_s,speed_deg,direction_kn", "t.csv:1:8", "'speed_deg' is in deg"),
       header("time_s,speed_kn,direction_m", "t.csv:1:17", "such as 'direction_deg'"),
       header("time_s,u_kmh,v_kmh", "t.csv:1:8",
              "'u_kmh' ends in no unit, as 'u_m_per_s' does: there is no unit 'kmh'"),
       header("time_sec,u_kn,v_kn", "t.csv:1:1", "did you mean 's'?"),
       header("time_s,speed_knots,direction_deg", "t.csv:1:8", "did you mean 'kn'?"),
       header("time_s,u_x_kn,v_kn", "t.csv:1:8", "'u_x_kn' ends in no unit"),
       way("time_s,x_kn,y_kn", "t.csv:1:8", "x is a quantity in m, such as 'x_m'"),
       way("time_s,displacement_x_per_s,displacement_y_m", "t.csv:1:8", "ends in no unit"));

FAULTS(Unknown,
       way("time_s,displacment_x_m,displacement_y_m", "t.csv:1:8",
           "there is no column 'displacment_x_m'; allowed: time_s, x_m, y_m, z_m, easting_m, "
           "northing_m, displacement_x_m, displacement_y_m, "),
       way("time_s,displacment_x_m,displacement_y_m", "t.csv:1:8",
           "did you mean 'displacement_x_m'?"),
       way("tiem_s,displacement_x_m,displacement_y_m", "t.csv:1:1", "did you mean 'time_s'?"),
       way("time_s,displacement_x_m,depth_m", "t.csv:1:25", "no column 'depth_m'"),
       header("time_s,velocity_z_m_per_s,v_kn", "t.csv:1:8", "did you mean 'velocity_x_m_per_s'"),
       header("time_s,veloctiy_x_m_per_s,v_kn", "t.csv:1:8", "did you mean 'velocity_x_m_per_s'"),
       header("Time_s,u_kn,v_kn", "t.csv:1:1", "did you mean 'time_s'?"),
       header("time_s,u_kn,", "t.csv:1:13", "a column has no name"),
       header("0,1,2", "t.csv:1:1", "'0' stands where a column's name is needed"),
       header("-5,u_kn,v_kn", "t.csv:1:1", "the first line names the columns"),
       header("time_s,u_kn,quality", "t.csv:1:13", "and what ignore of <table> names"));

FAULTS(MissingOrTwice,
       header("time_s,u_kn,u_m_per_s", "t.csv:1:13",
              "the columns 'u_kn' and 'u_m_per_s' hold the same quantity; take one away"),
       header("time_s,t_h,u_kn", "t.csv:1:8", "'time_s' and 't_h' hold the same quantity"),
       header("x_m,easting_m,u_kn", "t.csv:1:5", "hold the same quantity"),
       header("time_s,speed_kn,u_kn", "t.csv:1:8", "needs a column direction_deg beside it"),
       header("time_s,direction_deg,x_m", "t.csv:1:8", "needs a column speed_m_per_s beside it"),
       header("time_s,x_m,u_kn", "t.csv:1:12", "a column is missing: velocity_y_m_per_s"),
       header("time_s,x_m,y_m", "t.csv:1:12",
              "a column is missing: velocity_x_m_per_s, velocity_y_m_per_s, or speed_m_per_s and "
              "direction_deg"),
       way("time_s,displacement_x_m,x_m", "t.csv:1:25", "a column is missing: displacement_y_m"),
       way("time_s,x_m,z_m", "t.csv:1:12", "a column is missing: y_m of the point's position"),
       way("z_m,x_m,y_m", "t.csv:1:1", "no column says when the point is there; add time_s"),
       Faulty{{"u_kn,v_kn\n0,1\n"}, "t.csv:1:1", "no column says when or where; add time_s"});

FAULTS(
    Direction,
    header("time_s,speed_kn,direction_deg", "t.csv:1:17",
           "is 'direction_deg' where it comes from or where it goes to? The deck must say: <table "
           "name=\"...\" file=\"...\" direction=\"coming-from\"/> or \"going-to\""),
    header("time_s,speed_kn,heading_deg", "t.csv:1:17", "comes from or where it goes to?"),
    way("time_s,speed_kn,direction_deg", "t.csv:1:8",
        "a speed and a direction make a velocity, and the field 'displacement' is in m; needed: "
        "displacement_x_m, displacement_y_m, or x_m, y_m, the positions of a point"),
    Faulty{
        {"time_s,speed_kn,direction_deg,u_kn\n0,1,2,3\n", velocity(), with_direction("going-to")},
        "t.csv:1:31",
        "'u_kn' and 'speed_kn' say the same twice"},
    Faulty{{"time_s,speed_kn,direction_deg\n0,1,400\n", velocity(), with_direction("going-to")},
           "t.csv:2:5",
           "-360 to 360 degrees is plausible"},
    Faulty{{"time_s,speed_kn,direction_deg\n0,1,-999\n", velocity(), with_direction("going-to")},
           "t.csv:2:5",
           "<table missing=\"-999\"> says so"},
    Faulty{{"time_s,speed_kn,direction_deg\n0,-1,90\n", velocity(), with_direction("going-to")},
           "t.csv:2:3",
           "'speed_kn' is '-1', and 0 to 50 m/s is plausible"});

FAULTS(File, Faulty{{"\xEF\xBB\xBF" + head + "0,0,0\n"}, "t.csv:1:1", "byte-order mark"},
       Faulty{{"\xFF\xFEt\0i\0"}, "t.csv:1:1", "in UTF-16"},
       Faulty{{std::string("PK\x03\x04rest")}, "t.csv:1:1", "spreadsheet"},
       Faulty{{std::string("time_s\0,u", 9)}, "t.csv:1:1", "no text"},
       Faulty{{"time_s,u_kn,v_kn\r0,0,0\r"}, "t.csv:1:1", "carriage return"},
       Faulty{{""}, "t.csv:1:1", "the table is empty"},
       Faulty{{"# nothing\n\n"}, "t.csv:1:1", "the table is empty"},
       Faulty{{head}, "t.csv:1:1", "the table has no rows"},
       Faulty{{"\n# c\n" + head + "# d\n"}, "t.csv:3:1", "the table has no rows"},
       Faulty{{"\"time_s\",\"u_kn\",\"v_kn\"\n0,0,0\n"}, "t.csv:1:1", "a table has no quotes"},
       Faulty{{head + "0,\"1\",2\n"}, "t.csv:2:3", "a table has no quotes"},
       Faulty{{"'time_s',u_kn,v_kn\n0,0,0\n"}, "t.csv:1:1", "a table has no quotes"},
       Faulty{{"time_s;u_kn;v_kn\n0;0;0\n"},
              "t.csv:1:7",
              "values are set apart by commas, and here by ';'"},
       Faulty{{"time_s\tu_kn\tv_kn\n0\t0\t0\n"}, "t.csv:1:7", "by tabulators"},
       Faulty{{"time_s|u_kn|v_kn\n0|0|0\n"}, "t.csv:1:7", "by '|'"},
       Faulty{{head + "0;0,5;1,5\n"}, "t.csv:2:2", "write numbers with a point, 0.5 for 0,5"});

FAULTS(Rows, current("0,1,2\n10,1\n", "t.csv:3:4", "2 values, but 3 columns"),
       current("0,1,2,\n", "t.csv:2:7", "4 values, but 3 columns; a comma stands at the end"),
       current("0,1,2,3,4,5\n", "t.csv:2:7", "numbers are written with a point"),
       current("0,0,5,1,5\n", "t.csv:2:7", "numbers are written with a point"),
       current("0\n", "t.csv:2:1", "1 value, but 3 columns"),
       current("0,fast,0\n", "t.csv:2:3", "'fast' is no number"),
       current("0,0x10,0\n", "t.csv:2:3", "'0x10' is hexadecimal; a decimal number is needed"),
       current("-0X1p3,1,0\n", "t.csv:2:1", "is hexadecimal"),
       current("0, ,0\n", "t.csv:2:4", "the cell is empty"),
       current("0,1 ,nan\n", "t.csv:2:6", "<table missing=\"nan\"> says so"),
       current("0,NaN,0\n", "t.csv:2:3", "where it stands for a missing value"),
       current("0,--,0\n", "t.csv:2:3", "where it stands for a missing value"),
       current("0,inf,0\n", "t.csv:2:3", "no number"),
       current("2024-05-01,1,0\n", "t.csv:2:1", "is a date or a time of day"),
       current("12:30:00,1,0\n", "t.csv:2:1", "is a date or a time of day"),
       current("2024-05-01T12:30:00Z,1,0\n", "t.csv:2:1", "is a date or a time of day"),
       current("0,1e999,0\n", "t.csv:2:3", "too large"),
       current("0,1 m/s,0\n", "t.csv:2:3", "'1 m/s' is no number"),
       current("s,m/s,m/s\n", "t.csv:2:1", "'s' is no number"));

FAULTS(Fill, current("0,180,0\n", "t.csv:2:3", "-50 to 50 m/s is plausible"),
       current("0,1e20,0\n", "t.csv:2:3", "is the unit right"),
       current("0,9.96921e36,0\n", "t.csv:2:3", "missing value"),
       current("0,0.5,0\n10,-99.9,0\n", "t.csv:3:4", "<table missing=\"-99.9\"> says so"),
       current("0,0.5,0\n10,9.99,0\n", "t.csv:3:4",
               "'9.99' looks like a fill value, the others in 'velocity_x_m_per_s' go up to 0.5"),
       current("0,0.5,0\n10,-999,0\n", "t.csv:3:4", "plausible"),
       Faulty{{track + "0,0,0\n10,-999,5\n20,1,10\n", displacement()},
              "t.csv:3:4",
              "looks like a fill value"},
       Faulty{{track + "0,0,0\n10,0,9999.000\n20,1,10\n", displacement()},
              "t.csv:3:6",
              "looks like a fill value"},
       Faulty{{track + "0,0,0\n10,0,-32768\n20,1,10\n", displacement()},
              "t.csv:3:6",
              "missing=\"none\" that it is one"},
       Faulty{{track + "0,0,0\n10,99999999,0\n20,1,10\n", displacement()},
              "t.csv:3:4",
              "-1e+07 to 1e+07 m is plausible"},
       current("9.9e36,0,0\n", "t.csv:2:1", "plausible"));

FAULTS(Times, current("0,0,0\n0,1,1\n", "t.csv:3:1", "its time is that of line 2"),
       current("10,0,0\n0,1,1\n", "t.csv:3:1",
               "the time goes back from 10 s to 0 s; rows are needed in the order of time"),
       current("0,0,0\n10,0,0\n5,0,0\n20,0,0\n", "t.csv:4:1", "goes back from 10 s to 5 s"),
       current("86340,0,0\n86400,0,0\n0,0,0\n60,0,0\n", "t.csv:4:1", "goes back"),
       current("0,0,0\n10,0,0\n10.0,1,0\n", "t.csv:4:1", "that of line 3"),
       current("0,0,0\n10,0,0\n20,0,0\n30,0,0\n90,0,0\n100,0,0\n", "t.csv:6:1",
               "there is no value between t = 30 s and 90 s, where rows mostly are 10 s apart; "
               "longest-gap=\"60 s\" of <table> lets a straight line bridge it"),
       current("0,0,0\n3600,0,0\n3601,0,0\n3602,0,0\n3603,0,0\n", "t.csv:3:1",
               "between t = 0 s and 3600 s"),
       current("0,0,0\n10,-9,0\n20,0,0\n", "t.csv:3:1",
               "there is no value between t = 0 s and 20 s; longest-gap=\"20 s\"",
               with_missing({"-9"})),
       current("0,0,0\n10,,0\n20,,0\n30,0,0\n", "t.csv:3:1", "longer than longest-gap=\"20 s\"",
               with_missing({"-9"}, 20)),
       current("0,0,0\n10,0,0\n60,0,0\n", "t.csv:4:1", "longer than longest-gap=\"20 s\"",
               with_missing({}, 20)),
       current("0,-9,0\n10,0,-9\n", "t.csv:1:1", "in every row a value is missing",
               with_missing({"-9"})),
       current("-9,0,0\n10,0,0\n", "t.csv:2:1", "a row without a time or place cannot be used",
               with_missing({"-9"})));

FAULTS(Grids,
       Faulty{{"t_s,x_m,heat_K\n0,0,1\n0,1,1\n10,0,1\n", scalar("heat", "K")},
              "t.csv:1:1",
              "the rows do not fill a grid: none for t = 10, x = 1, and 1 missing in all"},
       Faulty{{"t_s,x_m,heat_K\n0,0,1\n0,0,1\n", scalar("heat", "K")},
              "t.csv:3:1",
              "time and place are those of line 2"},
       Faulty{{"x_m,y_m,heat_K\n0,0,1\n1,1,1\n", scalar("heat", "K")},
              "t.csv:1:1",
              "do not fill a grid"},
       Faulty{{"t_s,x_m,heat_K\n0,0,1\n0,1,1\n10,0,-9\n10,1,1\n", scalar("heat", "K"),
               with_missing({"-9"})},
              "t.csv:1:1",
              "do not fill a grid"});

FAULTS(Options,
       way("time_s,easting_m,northing_m", "t.csv:1:8",
           "'easting_m' counts from a chart's origin: <table origin=\"E N\"> must say where"),
       way("time_s,x_m,y_m", "d.xml:2:40",
           "origin belongs to columns easting_m and northing_m, and t.csv has none",
           with_origin(0, 0)),
       header("x_m,u_kn,v_kn", "d.xml:2:30", "smooth is for tables over time alone",
              with_smoothing(10)),
       header("time_s,u_kn,v_kn", "d.xml:2:3",
              "ignore names the column 'qualty', and t.csv has time_s, u_kn, v_kn",
              with([](TableDeck& deck) { deck.ignore = {"qualty"}; })),
       Faulty{{head + "0,0,0\n1,0,0\n2,0,0\n", velocity(), with_smoothing(10000)},
              "d.xml:2:30",
              "more than 2000 rows"},
       header("time_s,u_kn,v_kn", "d.xml:2:3", "relative is for displacements over time",
              with([](TableDeck& deck) { deck.relative = true; })));

// Of the many faults of one kind the first few are told.
TEST(TableFaults, AreNotRepeatedForEveryRow) {
  std::string text = head;
  for (int i = 0; i < 1000; ++i)
    text += std::to_string(i) + ",fast,slow\n";
  const std::string faults = read({text}).faults;
  EXPECT_LT(std::count(faults.begin(), faults.end(), '\n'), 10);
}

struct Fixes {
  double noise, spacing, speed;
  bool rough;
};
class Tracks : public testing::TestWithParam<Fixes> {};

// Zigzags of `noise` m around a track of `speed` m/s.
TEST_P(Tracks, OfNoisyFixesNeedASmoothing) {
  const Fixes& given = GetParam();
  std::string text = track;
  for (int i = 0; i < 100; ++i)
    text += std::to_string(i * given.spacing) + "," +
            std::to_string(i % 2 == 0 ? given.noise : -given.noise) + "," +
            std::to_string(given.speed * i * given.spacing) + "\n";
  const TableReading plain = read({text, displacement()});
  EXPECT_EQ(plain.table == nullptr, given.rough) << plain.faults;
  if (given.rough) {
    EXPECT_THAT(plain.faults, StartsWith("t.csv:2:1: from row to row the velocity changes by "));
    EXPECT_THAT(plain.faults,
                HasSubstr(" of <table> smooths it, and smooth=\"0 s\" takes the rows"));
  }
  EXPECT_NE(read({text, displacement(), with_smoothing(0)}).table, nullptr);
  EXPECT_NE(read({text, displacement(), with_smoothing(20 * given.spacing)}).table, nullptr);
}
INSTANTIATE_TEST_SUITE_P(Table, Tracks,
                         testing::Values(Fixes{1, 1, 0.2, true}, Fixes{1, 1, 2.5, true},
                                         Fixes{2, 10, 2.5, false}, Fixes{0.05, 1, 2.5, false},
                                         Fixes{3, 1, 2.5, true}, Fixes{1, 1, 0, true},
                                         Fixes{0, 1, 0, false}, Fixes{0, 600, 0.2, false},
                                         Fixes{10, 10, 1, true}, Fixes{0.5, 1, 1, true}));

}  // namespace
}  // namespace hawser
