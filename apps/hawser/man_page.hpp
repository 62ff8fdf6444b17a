#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace hawser::program {

/// The manual page, in roff, with every verb and option that the command line knows.
std::string man_page(const CLI::App& app);

}  // namespace hawser::program
