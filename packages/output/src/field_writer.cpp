#include "hawser/output/field_writer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "src/files.hpp"
#include "src/hdf5_file.hpp"
#include "src/rows.hpp"
#include "src/vtkhdf.hpp"
#include "src/xdmf.hpp"

namespace hawser {
namespace {

std::vector<double> widened(const std::vector<double>& values, int from, int to) {
  if (from == to) return values;
  std::vector<double> result;
  result.reserve(values.size() / static_cast<std::size_t>(from) * static_cast<std::size_t>(to));
  for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(from)) {
    for (int k = 0; k < to; ++k) {
      result.push_back(k < from ? values[i + static_cast<std::size_t>(k)] : 0.0);
    }
  }
  return result;
}

// The step in "flow-000010.h5", or -1 when the file is none of ours.
int step_of(const std::string& file, const std::string& name) {
  if (file.rfind(name + "-", 0) != 0) return -1;
  const std::string rest = file.substr(name.size() + 1);
  const auto digits = rest.find_first_not_of("0123456789");
  if (digits == 0 || digits == std::string::npos || digits > 9) return -1;
  const std::string extension = rest.substr(digits);
  return extension == ".h5" || extension == ".xdmf" ? std::stoi(rest) : -1;
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void require_size(std::size_t size, std::size_t expected, const std::string& what) {
  if (size != expected) {
    throw std::logic_error(fmt::format("output: {} has {} values, not {}", what, size, expected));
  }
}

}  // namespace

FieldWriter::FieldWriter(const Communicator& communicator, std::string folder, Grid grid,
                         int keep_until)
    : communicator_(communicator), folder_(std::move(folder)), grid_(std::move(grid)) {
  points_ = std::make_unique<Rows>(communicator_, grid_.point_count, grid_.point_ids);
  cells_ = std::make_unique<Rows>(communicator_, grid_.cell_count, grid_.cell_ids);
  joined_.reserve(grid_.cells.size());
  for (const GlobalIndex id : grid_.cells) {
    joined_.push_back(points_->position(id));
  }
  communicator_.on_root([&] { tidy_folder(keep_until); });
}

FieldWriter::~FieldWriter() = default;

std::string FieldWriter::path(int step, const std::string& extension) const {
  return fmt::format("{}/{}-{:06d}.{}", folder_, grid_.name, step, extension);
}

void FieldWriter::tidy_folder(int keep_until) {
  std::error_code error;
  const std::filesystem::directory_iterator files(folder_, error);
  if (error) throw_cannot("read", folder_, error.value());
  std::vector<std::filesystem::path> stale;
  for (const auto& file : files) {
    const int step = step_of(file.path().filename(), grid_.name);
    if (step > keep_until) stale.push_back(file.path());
    if (step >= 0 && step <= keep_until && file.path().extension() == ".xdmf") {
      const Hdf5File data = Hdf5File::open(Communicator(MPI_COMM_SELF), path(step, "h5"));
      outputs_[step] = {data.number("/", "time"), file.path().stem().string() + ".h5",
                        xdmf_grid_of(contents(file.path()))};
    }
  }
  for (const auto& file : stale) {
    if (!std::filesystem::remove(file, error)) throw_cannot("remove", file, error.value());
  }
}

void FieldWriter::write(int step, double time, const std::vector<double>& coordinates,
                        const std::vector<PointField>& fields) {
  const std::size_t owned = grid_.point_ids.size();
  require_size(coordinates.size(), owned * static_cast<std::size_t>(grid_.dimension),
               "coordinates");
  for (const PointField& field : fields) {
    const std::size_t places = field.of_cells ? grid_.cell_ids.size() : owned;
    require_size(field.values.size(), places * static_cast<std::size_t>(field.components),
                 field.name);
  }

  const std::string data = path(step, "h5");
  const int corners = grid_.kind == CellKind::triangle ? 3 : 2;
  GlobalIndex numbers =
      3 * grid_.point_count + static_cast<GlobalIndex>(corners) * grid_.cell_count;
  for (const PointField& field : fields) {
    numbers += rows_of(grid_, field) * written_components(field.components);
  }
  communicator_.on_root([&] { try_room(unfinished(data), room_for(numbers)); });
  Hdf5File file = Hdf5File::create(communicator_, unfinished(data));
  file.set("/", "step", GlobalIndex{step});
  file.set("/", "time", time);
  file.write("points", {grid_.point_count, 3}, points_->positions(),
             widened(coordinates, grid_.dimension, 3));
  file.write("cells", {grid_.cell_count, corners}, cells_->positions(), joined_);
  file.make_group("fields");
  for (const PointField& field : fields) {
    const int components = written_components(field.components);
    file.write("fields/" + field.name, {rows_of(grid_, field), components},
               field.of_cells ? cells_->positions() : points_->positions(),
               widened(field.values, field.components, components));
    file.set("fields/" + field.name, "unit", field.unit);
    if (field.of_cells) file.set("fields/" + field.name, "of", std::string("cells"));
  }
  file.close();

  // The index comes last, so that it never names a file that is not there.
  communicator_.on_root([&] {
    finish(data);
    const std::string name = std::filesystem::path(data).filename();
    outputs_[step] = {time, name, xdmf_grid(grid_, name, fields)};
    write_atomically(path(step, "xdmf"), xdmf_single(outputs_[step].grid));
    const std::string series = folder_ + "/" + grid_.name;
    write_vtkhdf(series + ".vtkhdf", grid_, fields, outputs_);
    write_atomically(series + ".xdmf", xdmf_series(grid_.name, outputs_));
  });
}

}  // namespace hawser
