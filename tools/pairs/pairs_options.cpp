// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_options.h"

#include <CLI/CLI.hpp>

namespace collision_monitor::pairs_tool {
namespace {

const char* const kAbout =
    "Finds out which pairs of links of a robot can touch: draws states of its joints within their\n"
    "limits, and tries to prove pairs apart that were never seen to touch. Prints a line for each\n"
    "pair; writes the pairs that need no checking to an SRDF.\n";

const char* const kFooter =
    "A pair touches\n"
    "  adjacent   by design, at the joint between the links; not looked at\n"
    "  always     in every state that was drawn\n"
    "  sometimes  in the state that is printed, and not in others\n"
    "  perhaps    its enclosing shapes do in the state that is printed; of the geometries no more\n"
    "             is known\n"
    "  never      in no state that was drawn. Only where the line says 'proven' can it never "
    "touch\n\n"
    "Exit code: 0, done. 1, something that was read or is to be written is at fault; all of it is\n"
    "listed and no file is touched. 2, the command line is at fault.\n\n"
    "Of an SRDF that is there, --write-srdf changes <disable_collisions> below the root and not a\n"
    "byte beside. Pairs that are adjacent, or proven to touch always or never, are added. Lines "
    "of\n"
    "reason Never or Always whose links touch sometimes are taken out. All others stay.\n\n"
    "Examples:\n"
    "  pairs robot.urdf                              look at the table\n"
    "  pairs robot.urdf --write-srdf robot.srdf      bring an SRDF up to date, or make one\n"
    "  pairs robot.urdf --states 100000 --write-srdf robot.srdf --trust-samples";

void addSearch(CLI::App& app, Options& options) {
  constexpr std::size_t kMostStates = 100000000;
  constexpr std::size_t kMostCells = 100000000;
  const char* const group = "Search";
  app.add_option("--states", options.search.states, "that are drawn, 1 to 100000000")
      ->check(CLI::Range(std::size_t{1}, kMostStates).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  app.add_option("--seed", options.search.seed, "the same one draws the same states")
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  app.add_option("--cells", options.search.most_cells,
                 "into which a proof may cut what joints can do, for each pair")
      ->check(CLI::Range(std::size_t{1}, kMostCells).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
}

void addOutputs(CLI::App& app, Options& options) {
  const char* const group = "Output";
  CLI::Option* srdf = app.add_option("--write-srdf", options.write_srdf,
                                     "pairs that need no checking, as disable_collisions")
                          ->type_name("FILE")
                          ->group(group);
  app.add_flag("--trust-samples", options.trusts_samples,
               "write pairs, too, that touched in no state drawn or in all and are not proven to")
      ->needs(srdf)
      ->group(group);
  app.add_flag("--force", options.may_replace,
               "make the SRDF anew; all that is in a file of that name is lost")
      ->needs(srdf)
      ->group(group);
}

/// In other programs, the option of this name reads a file. Here it once overwrote one.
void refuseSrdf(CLI::App& app) {
  app.add_option_function<std::string>("--srdf",
                                       [](const std::string& file) {
                                         throw CLI::ValidationError(
                                             "--srdf: pairs reads no SRDF, it looks at all pairs; "
                                             "--write-srdf " +
                                             file + " writes what it finds");
                                       })
      ->group("");
}

}  // namespace

Parsed parseOptions(int argc, const char* const* argv) {
  Parsed parsed;
  CLI::App app{kAbout, "pairs"};
  app.footer(kFooter);
  bool has_no_cache = false;
  fit_tool::addRobotOptions(app, parsed.options.source);
  addSearch(app, parsed.options);
  addOutputs(app, parsed.options);
  refuseSrdf(app);
  fit_tool::addCacheOptions(app, parsed.options.cache, has_no_cache);
  try {
    app.parse(argc, argv);
    fit_tool::checkOneRobot(parsed.options.source);
    fit_tool::checkKeeps({"robot", parsed.options.source.urdf}, "--write-srdf",
                         parsed.options.write_srdf);
  } catch (const CLI::ParseError& fault) {
    parsed.exit_code = app.exit(fault) == 0 ? 0 : fit_tool::kUsageFault;
    return parsed;
  }
  if (has_no_cache) {
    parsed.options.cache = "none";
  }
  parsed.is_to_run = true;
  return parsed;
}

}  // namespace collision_monitor::pairs_tool
