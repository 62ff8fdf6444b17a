#include "src/vtkhdf.hpp"

#include <hdf5.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "hawser/base/error.hpp"
#include "src/files.hpp"
#include "src/hdf5_file.hpp"
#include "src/xdmf.hpp"

namespace hawser {
namespace {

using Sizes = std::vector<hsize_t>;

Hdf5Handle space_of(const Sizes& sizes) {
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose};
}

Sizes rows_by_components(hsize_t rows, int components) {
  return components == 1 ? Sizes{rows} : Sizes{rows, static_cast<hsize_t>(components)};
}

class Writer {
 public:
  explicit Writer(const std::string& path)
      : path_(path),
        file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {
    require(file_.valid());
  }

  void group(const std::string& name) {
    require(
        Hdf5Handle(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose)
            .valid());
  }

  void attribute(const std::string& of, const std::string& name, hid_t type, const Sizes& sizes,
                 const void* value) {
    const Hdf5Handle space =
        sizes.empty() ? Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose) : space_of(sizes);
    const Hdf5Handle made(H5Acreate_by_name(file_, of.c_str(), name.c_str(), type, space,
                                            H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
    require(made.valid() && H5Awrite(made, type, value) >= 0);
  }

  void data(const std::string& name, hid_t type, const Sizes& sizes, const void* values) {
    const Hdf5Handle space = space_of(sizes);
    const Hdf5Handle made(
        H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    require(made.valid() && H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  }

  /// One integer per step.
  void steps(const std::string& name, const std::vector<GlobalIndex>& values) {
    data(name, H5T_NATIVE_LLONG, {values.size()}, values.data());
  }

  /// `source` of each of the files, one behind the other; what is not there reads as `fill`.
  void joined(const std::string& name, hid_t type, const std::string& source,
              const Sizes& source_sizes, const Sizes& one, const std::vector<std::string>& files,
              const void* fill) {
    Sizes whole = one;
    whole[0] *= files.size();
    const Hdf5Handle space = space_of(whole), from = space_of(source_sizes);
    const Hdf5Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    bool done = fill == nullptr || H5Pset_fill_value(plan, type, fill) >= 0;
    Sizes start(one.size(), 0);
    for (const std::string& file : files) {
      done = done &&
             H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, one.data(),
                                 nullptr) >= 0 &&
             H5Pset_virtual(plan, space, file.c_str(), source.c_str(), from) >= 0;
      start[0] += one[0];
    }
    H5Sselect_all(space);
    require(done &&
            Hdf5Handle(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, plan, H5P_DEFAULT),
                       H5Dclose)
                .valid());
  }

  void close() { require(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0 && file_.reset()); }

 private:
  void require(bool done) const {
    if (!done) throw OutputError("cannot write " + path_);
  }

  std::string path_;
  Hdf5Handle file_;
};

constexpr unsigned char vtk_line = 3, vtk_triangle = 5;  // vtkCellType.h

void write_cells(Writer& writer, const Grid& grid, const std::string& first_file) {
  const auto cells = static_cast<std::size_t>(grid.cell_count);
  const std::size_t corners = grid.kind == CellKind::triangle ? 3 : 2;
  const std::vector<unsigned char> kinds(cells,
                                         grid.kind == CellKind::triangle ? vtk_triangle : vtk_line);
  std::vector<GlobalIndex> offsets(cells + 1, 0);
  for (std::size_t i = 0; i < cells; ++i)
    offsets[i + 1] = offsets[i] + static_cast<GlobalIndex>(corners);
  writer.data("/VTKHDF/Types", H5T_NATIVE_UCHAR, {cells}, kinds.data());
  writer.data("/VTKHDF/Offsets", H5T_NATIVE_LLONG, {cells + 1}, offsets.data());
  writer.joined("/VTKHDF/Connectivity", H5T_NATIVE_LLONG, "/cells", {cells, corners},
                {cells * corners}, {first_file}, nullptr);
}

}  // namespace

void write_vtkhdf(const std::string& path, const Grid& grid, const std::vector<PointField>& fields,
                  const std::map<int, SavedOutput>& outputs) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  std::vector<double> times;
  std::vector<std::string> files;
  for (const auto& [step, output] : outputs) {
    times.push_back(output.time);
    files.push_back(output.file);
  }
  const auto count = static_cast<GlobalIndex>(files.size());
  const std::vector<GlobalIndex> ones(files.size(), 1), zeros(files.size(), 0);
  std::vector<GlobalIndex> numbers(files.size()), points_before(files.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = 0; i < files.size(); ++i)
    points_before[i] = grid.point_count * numbers[i];
  const auto all = [&](GlobalIndex value) { return std::vector<GlobalIndex>(files.size(), value); };
  const auto points = static_cast<hsize_t>(grid.point_count);
  const double nothing = std::numeric_limits<double>::quiet_NaN();

  // Virtual datasets take less than so much for every step.
  try_room(unfinished(path), room_for(2 * grid.cell_count +
                                      32 * count * static_cast<GlobalIndex>(fields.size() + 2)));
  Writer writer(unfinished(path));
  writer.group("/VTKHDF");
  const GlobalIndex version[] = {2, 0};
  writer.attribute("/VTKHDF", "Version", H5T_NATIVE_LLONG, {2}, version);
  const std::string kind = "UnstructuredGrid";
  const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text, kind.size());
  H5Tset_strpad(text, H5T_STR_NULLPAD);
  writer.attribute("/VTKHDF", "Type", text, {}, kind.c_str());
  writer.steps("/VTKHDF/NumberOfPoints", all(grid.point_count));
  writer.steps("/VTKHDF/NumberOfCells", all(grid.cell_count));
  writer.steps("/VTKHDF/NumberOfConnectivityIds",
               all(grid.cell_count * (grid.kind == CellKind::triangle ? 3 : 2)));
  write_cells(writer, grid, files.front());
  writer.joined("/VTKHDF/Points", H5T_NATIVE_DOUBLE, "/points", {points, 3}, {points, 3}, files,
                &nothing);

  writer.group("/VTKHDF/Steps");
  writer.attribute("/VTKHDF/Steps", "NSteps", H5T_NATIVE_LLONG, {}, &count);
  writer.data("/VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE, {times.size()}, times.data());
  writer.steps("/VTKHDF/Steps/PartOffsets", numbers);
  writer.steps("/VTKHDF/Steps/NumberOfParts", ones);
  writer.steps("/VTKHDF/Steps/PointOffsets", points_before);
  writer.steps("/VTKHDF/Steps/CellOffsets", zeros);
  writer.steps("/VTKHDF/Steps/ConnectivityIdOffsets", zeros);

  for (const bool of_cells : {false, true}) {
    const bool any = std::any_of(fields.begin(), fields.end(), [&](const PointField& field) {
      return field.of_cells == of_cells;
    });
    if (of_cells && !any) continue;
    const std::string data = of_cells ? "CellData" : "PointData";
    const std::string offsets = "/VTKHDF/Steps/" + data + "Offsets";
    writer.group("/VTKHDF/" + data);
    writer.group(offsets);
    for (const PointField& field : fields) {
      if (field.of_cells != of_cells) continue;
      const GlobalIndex rows = rows_of(grid, field);
      const Sizes one =
          rows_by_components(static_cast<hsize_t>(rows), written_components(field.components));
      writer.joined("/VTKHDF/" + data + "/" + field.name, H5T_NATIVE_DOUBLE,
                    "/fields/" + field.name, one, one, files, &nothing);
      std::vector<GlobalIndex> before(files.size());
      for (std::size_t i = 0; i < files.size(); ++i)
        before[i] = rows * numbers[i];
      writer.steps(offsets + "/" + field.name, before);
    }
  }
  writer.close();
  finish(path);
}

}  // namespace hawser
