#include "src/hdf5_file.hpp"

#include <algorithm>
#include <numeric>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

// HDF5 names the cause innermost in its stack of errors.
std::string innermost_error() {
  std::string text;
  const auto keep_last = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
    if (error->desc != nullptr && *error->desc != 0) *static_cast<std::string*>(data) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &text);
  return text.empty() ? "failure on another rank" : text;
}

Hdf5Handle parallel_access(const Communicator& communicator) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(access, communicator.mpi(), MPI_INFO_NULL);
  return access;
}

Hdf5Handle collective_transfer() {
  Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

// Rows at ascending, distinct positions. MPI-IO wants file offsets to ascend.
bool select(hid_t space, Hdf5File::Shape shape, const std::vector<GlobalIndex>& positions) {
  if (positions.empty()) return H5Sselect_none(space) >= 0;
  if (positions.back() - positions.front() + 1 == static_cast<GlobalIndex>(positions.size())) {
    const hsize_t start[] = {static_cast<hsize_t>(positions.front()), 0};
    const hsize_t count[] = {positions.size(), static_cast<hsize_t>(shape.components)};
    return H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0;
  }
  std::vector<hsize_t> entries;
  const auto components = static_cast<hsize_t>(shape.components);
  entries.reserve(positions.size() * components * 2);
  for (const GlobalIndex position : positions) {
    for (hsize_t i = 0; i < components; ++i) {
      entries.push_back(static_cast<hsize_t>(position));
      if (components > 1) entries.push_back(i);
    }
  }
  return H5Sselect_elements(space, H5S_SELECT_SET, positions.size() * components, entries.data()) >=
         0;
}

Hdf5Handle table_space(Hdf5File::Shape shape) {
  const hsize_t sizes[] = {static_cast<hsize_t>(shape.rows),
                           static_cast<hsize_t>(shape.components)};
  return {H5Screate_simple(shape.components > 1 ? 2 : 1, sizes, nullptr), H5Sclose};
}

Hdf5Handle memory_space(std::size_t size) {
  const hsize_t sizes[] = {size};
  return {H5Screate_simple(1, sizes, nullptr), H5Sclose};
}

std::vector<std::size_t> ascending(const std::vector<GlobalIndex>& positions) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return positions[a] < positions[b]; });
  return order;
}

template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::size_t>& order,
                         int components) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<T> result;
  result.reserve(values.size());
  for (const std::size_t row : order) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * width);
    result.insert(result.end(), first, first + components);
  }
  return result;
}

}  // namespace

Hdf5File::Hdf5File(const Communicator& communicator, std::string path, Hdf5Handle file, bool writes)
    : communicator_(communicator), path_(std::move(path)), writes_(writes), file_(std::move(file)) {
  require(file_.valid());
}

Hdf5File Hdf5File::create(const Communicator& communicator, const std::string& path,
                          int free_bytes) {
  const Hdf5Handle access = parallel_access(communicator);
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation, static_cast<hsize_t>(free_bytes));
  return {communicator, path,
          Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose), true};
}

Hdf5File Hdf5File::open(const Communicator& communicator, const std::string& path) {
  const Hdf5Handle access = parallel_access(communicator);
  return {communicator, path, Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose),
          false};
}

void Hdf5File::require(bool done) const {
  if (!communicator_.any(!done)) return;
  const std::string reason = done ? "" : innermost_error();
  communicator_.together([&] {
    if (!done)
      throw OutputError("cannot " + std::string(writes_ ? "write " : "read ") + path_ + ": " +
                        reason);
  });
}

void Hdf5File::write_table(const std::string& name, Shape shape,
                           const std::vector<GlobalIndex>& positions, hid_t type,
                           const void* sorted_values) {
  const Hdf5Handle space = table_space(shape);
  const Hdf5Handle data(
      H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  require(data.valid() && select(space, shape, positions));
  const Hdf5Handle memory =
      memory_space(positions.size() * static_cast<std::size_t>(shape.components));
  require(H5Dwrite(data, type, memory, space, collective_transfer(), sorted_values) >= 0);
}

void Hdf5File::write(const std::string& name, Shape shape,
                     const std::vector<GlobalIndex>& positions, const std::vector<double>& values) {
  const auto order = ascending(positions);
  write_table(name, shape, reordered(positions, order, 1), H5T_NATIVE_DOUBLE,
              reordered(values, order, shape.components).data());
}

void Hdf5File::write(const std::string& name, Shape shape,
                     const std::vector<GlobalIndex>& positions,
                     const std::vector<GlobalIndex>& values) {
  const auto order = ascending(positions);
  write_table(name, shape, reordered(positions, order, 1), H5T_NATIVE_LLONG,
              reordered(values, order, shape.components).data());
}

Hdf5File::Shape Hdf5File::shape(const std::string& name) const {
  const Hdf5Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(data.valid());
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  hsize_t sizes[H5S_MAX_RANK] = {0, 1};
  const int rank = H5Sget_simple_extent_dims(space, sizes, nullptr);
  require(rank == 1 || rank == 2);
  return {static_cast<GlobalIndex>(sizes[0]), rank == 1 ? 1 : static_cast<int>(sizes[1])};
}

std::vector<double> Hdf5File::read(const std::string& name,
                                   const std::vector<GlobalIndex>& positions) const {
  const Shape table = shape(name);
  std::vector<GlobalIndex> wanted = positions;
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());

  const Hdf5Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space = table_space(table);
  require(select(space, table, wanted));
  const auto width = static_cast<std::size_t>(table.components);
  std::vector<double> found(wanted.size() * width);
  require(H5Dread(data, H5T_NATIVE_DOUBLE, memory_space(found.size()), space, collective_transfer(),
                  found.data()) >= 0);

  std::vector<std::size_t> order;
  order.reserve(positions.size());
  for (const GlobalIndex position : positions) {
    const auto at = std::lower_bound(wanted.begin(), wanted.end(), position) - wanted.begin();
    order.push_back(static_cast<std::size_t>(at));
  }
  return reordered(found, order, table.components);
}

void Hdf5File::close() {
  if (writes_) require(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0);
  require(file_.reset());
}

}  // namespace hawser
