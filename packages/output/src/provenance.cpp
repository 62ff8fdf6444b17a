#include "hawser/output/provenance.hpp"

#include <Trilinos_version.h>
#include <unistd.h>

#include <ctime>

namespace hawser {

void add_provenance(const Communicator& communicator, Summary& summary) {
  Summary& provenance = summary.object("provenance");
  provenance.set("hawser_version", HAWSER_VERSION);
  provenance.set("git_revision", HAWSER_GIT_REVISION);
  provenance.set("compiler", "gcc " __VERSION__);
  provenance.set("trilinos_version", TRILINOS_VERSION_STRING);
  char library[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(library, &length);
  const std::string text(library, static_cast<std::size_t>(length));
  provenance.set("mpi_library", text.substr(0, text.find(',')));
  provenance.set("ranks", communicator.size());
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  provenance.set("host", host);
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  provenance.set("date_utc", date);
}

}  // namespace hawser
