#include "man_page.hpp"

namespace hawser::program {
namespace {

constexpr const char* closing = R"(.SH EXIT STATUS
.TP
.B 0
done, every expectation of the deck holds
.TP
.B 2
wrong command line
.TP
.B 3
a fault in the deck, told with file, line and column
.TP
.B 4
the mesh cannot be made, read or used
.TP
.B 5
a plug-in was not found, or is not fit for this program
.TP
.B 6
no convergence at the least step; the last accepted state is in checkpoint.h5
.TP
.B 7
a file or folder cannot be written or read
.TP
.B 8
the run finished, but an expectation of the deck does not hold
.TP
.B 75
stopped by a signal; checkpoint.h5 holds the last accepted state
.SH SIGNALS
SIGTERM, SIGINT, SIGUSR1, SIGHUP and SIGXCPU, to any rank, end a run after its present step with a checkpoint, as
.B --stop-after
does; a SIGTERM or SIGINT half a second later or more ends it at once. SIGUSR2 writes a checkpoint, and the run goes
on. Of these
.BR mpirun (1)
forwards SIGUSR1 and SIGUSR2.
.SH ENVIRONMENT
.TP
.B HAWSER_PLUGIN_SECONDS
how long plug-ins may take to be loaded and to make their modules; 60 by default
.TP
.B NO_COLOR
when it is set, no colours on a terminal
.TP
.B HAWSER_MESHER
path of the mesher, when it is not beside the program
.SH FILES
.TP
.I lib/hawser/plugins
beside the folder of the program: where plug-ins are loaded from
.SH SEE ALSO
.BR mpirun (1)
)";

/// Text that roff takes as it is.
std::string plain(const std::string& text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\' || c == '-') result += '\\';
    result += c;
    begins_line = c == '\n';
  }
  return result;
}

std::string names_of(const CLI::Option& option) {
  if (option.nonpositional()) return option.get_name(false, true);
  return option.get_name(true);
}

void add_option(const CLI::Option& option, std::string& page) {
  page += ".TP\n.B " + plain(names_of(option)) + "\n" + plain(option.get_description()) +
          (option.get_required() ? " (required)" : "") + "\n";
}

void add_verb(const CLI::App& verb, std::string& page) {
  page += ".SS hawser " + verb.get_name();
  for (const CLI::Option* option : verb.get_options())
    if (!option->nonpositional()) page += " " + plain(names_of(*option));
  page += "\n" + plain(verb.get_description()) + ".\n";
  for (const CLI::Option* option : verb.get_options())
    if (option != verb.get_help_ptr()) add_option(*option, page);
  if (verb.get_footer().empty()) return;
  page += ".PP\n.nf\n" + plain(verb.get_footer()) + "\n.fi\n";
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string page = ".TH HAWSER 1 \"\" \"hawser " HAWSER_VERSION
                     "\"\n"
                     ".SH NAME\nhawser \\- coupled physics on moving meshes\n"
                     ".SH SYNOPSIS\n.B hawser\n.I VERB\n[\\fIOPTIONS\\fR]\n.br\n"
                     "\\fBhawser\\fR [\\fIVERB\\fR] \\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n"
                     ".SH DESCRIPTION\n" +
                     plain(app.get_description()) +
                     "\nA deck in XML names a mesh, physics modules, conditions and a time scheme; "
                     "everything is solved as one system, on any number of MPI ranks.\n.SH VERBS\n";
  for (const CLI::App* verb : app.get_subcommands(nullptr))
    add_verb(*verb, page);
  return page + closing;
}

}  // namespace hawser::program
