#include "navigation_file.hpp"

#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/navigation/clock.hpp"
#include "hawser/navigation/write_p190.hpp"

namespace hawser {
namespace {

std::vector<double> numbers_of(std::string row) {
  for (char& c : row)
    if (c == ',') c = ' ';
  std::istringstream text(row);
  std::vector<double> numbers;
  for (double number = 0; text >> number;)
    numbers.push_back(number);
  return numbers;
}

/// Rows of t, receiver, arc length, x, y and, in space, z.
NavigationLine line_of(std::istream& table, int dimension, const NavigationFileDeck& deck) {
  NavigationLine line;
  std::string row;
  std::getline(table, row);  // the header
  while (std::getline(table, row)) {
    const std::vector<double> cell = numbers_of(row);
    if (cell.size() < 5) continue;
    if (line.shots.empty() || cell[1] <= 1)
      line.shots.push_back(
          {deck.first_shot + static_cast<int>(line.shots.size()), {}, cell[0], {}, {}});
    Shot& shot = line.shots.back();
    if (line.shots.size() == 1) line.receivers.push_back(static_cast<int>(cell[1]));
    shot.places.push_back({cell[3] + deck.origin[0], cell[4] + deck.origin[1]});
    shot.depths.push_back(dimension == 3 ? -cell[5] : deck.depth);
  }
  return line;
}

}  // namespace

void write_navigation(const Mesh& mesh, const std::string& table, const std::string& folder,
                      const NavigationFileDeck& deck) {
  mesh.communicator.on_root([&] {
    std::ifstream rows(table);
    const NavigationLine line = line_of(rows, mesh.dimension, deck);
    if (line.shots.empty())
      throw OutputError("cannot read " + table + ", of which " + *deck.file + " is made");
    P190Options options;
    options.line = deck.line;
    options.streamer = deck.streamer;
    read_clock(deck.epoch, options.epoch);
    const std::string path = folder + "/" + *deck.file;
    std::ofstream file(path, std::ios::binary);
    file << write_p190(line, Chart(deck.crs), options);
    if (!file.flush()) throw OutputError("cannot write " + path);
  });
}

}  // namespace hawser
