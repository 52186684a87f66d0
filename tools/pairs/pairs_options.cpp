// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_options.h"

#include <CLI/CLI.hpp>

namespace collision_monitor::pairs_tool {
namespace {

const char* const kAbout =
    "Finds out which pairs of links of robots can touch: draws states of the joints within their\n"
    "limits, and tries to prove that pairs never touch, or always. Prints a line for each pair.\n"
    "Writes the pairs that need no checking to an SRDF or a YAML file, or checks an SRDF.\n";

const char* const kFooter =
    "A pair touches\n"
    "  adjacent   by design, at the joint between the links; not looked at\n"
    "  always     in every state that was drawn\n"
    "  sometimes  in the state that is printed, and not in others\n"
    "  perhaps    its enclosing shapes do in the state that is printed; of the geometries no more\n"
    "             is known\n"
    "  never      in no state that was drawn\n"
    "Always and never hold for all states only where the line says 'proven'.\n\n"
    "Exit code: 0, done. 1, something that was read or is to be written is at fault, all of it is\n"
    "listed and no file is touched; or the SRDF of --check disables a pair that touches. 2, the\n"
    "command line is at fault.\n\n"
    "Of an SRDF that is there, --write-srdf changes <disable_collisions> below the root and not a\n"
    "byte beside. Pairs that are adjacent, or proven to touch always or never, are added. Lines "
    "of\n"
    "reason Never or Always whose links touch sometimes are taken out. All others stay.\n\n"
    "Examples:\n"
    "  pairs robot.urdf                              look at the table\n"
    "  pairs robot.urdf --write-srdf robot.srdf      bring an SRDF up to date, or make one\n"
    "  pairs robot.urdf --check robot.srdf           find pairs that it should not disable\n"
    "  pairs robot.urdf --states 100000 --write-srdf robot.srdf --trust-samples\n"
    "  pairs cell.urdf --with left=arm.urdf --place left=0,0.5,0 --write-yaml pairs.yaml";

/// CLI11's own check accepts NaN.
std::string faultOfTime(const std::string& text) {
  constexpr double kLongest = 1e6;  // [s]
  double value = -1.0;
  const bool is_time = CLI::detail::lexical_cast(text, value) && value >= 0.0 && value <= kLongest;
  return is_time ? "" : "'" + text + "' is no time; accepted: 0 to 1000000 s";
}

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
  app.add_option("--time-limit", options.search.time_limit,
                 "[s] of all proofs together; those that are not done by then are left open")
      ->check(faultOfTime)
      ->type_name("SECONDS")
      ->capture_default_str()
      ->group(group);
}

void addOutputs(CLI::App& app, Options& options) {
  const char* const group = "Output";
  app.add_option("--check", options.check,
                 "an SRDF: list pairs that it disables although they touch, and pairs that it\n"
                 "leaves checked although they are proven to touch never or always")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--write-srdf", options.write_srdf,
                 "pairs that need no checking, as disable_collisions")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--write-yaml", options.write_yaml,
                 "pairs that need no checking, as the monitor's parameter ignore_pairs")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--trust-samples", options.trusts_samples,
               "write pairs, too, that are Never or Always in the states drawn, but not proven")
      ->group(group);
  app.add_flag("--force", options.may_replace,
               "make the SRDF anew, and replace the YAML file; all that is in them is lost")
      ->group(group);
}

/// @throws CLI::ValidationError for options that do not go together.
void checkOptions(const Options& options) {
  const fit_tool::RobotSource& source = options.source;
  fit_tool::checkOneRobot(source);
  checkSeveralRobots(options.robots);
  const bool has_several = !options.robots.others.empty() || !options.robots.prefix.empty();
  if (has_several && !(options.write_srdf.empty() && options.check.empty())) {
    throw CLI::ValidationError(
        "--check and --write-srdf: an SRDF is of one robot without a prefix; --write-yaml takes "
        "the pairs of several");
  }
  const bool writes = !options.write_srdf.empty() || !options.write_yaml.empty();
  if ((options.trusts_samples || options.may_replace) && !writes) {
    throw CLI::ValidationError(
        "--trust-samples and --force need a file to write: --write-srdf or --write-yaml");
  }
  if (!options.write_yaml.empty() && options.write_yaml == options.write_srdf) {
    throw CLI::ValidationError("--write-srdf and --write-yaml name the same file");
  }
  std::vector<fit_tool::InputFile> inputs{{"robot", source.urdf}};
  for (const OtherRobot& other : options.robots.others) {
    inputs.push_back({"robot", other.urdf});
  }
  for (const fit_tool::InputFile& input : inputs) {
    fit_tool::checkKeeps(input, "--write-srdf", options.write_srdf);
    fit_tool::checkKeeps(input, "--write-yaml", options.write_yaml);
  }
  fit_tool::checkKeeps({"SRDF", options.check}, "--write-yaml", options.write_yaml);
}

/// In other programs, the option of this name reads a file. Here it once overwrote one.
void refuseSrdf(CLI::App& app) {
  app.add_option_function<std::string>("--srdf",
                                       [](const std::string& file) {
                                         throw CLI::ValidationError(
                                             "--srdf: pairs looks at all pairs, whatever an SRDF "
                                             "says; --check " +
                                             file + " compares, --write-srdf " + file +
                                             " writes what it finds");
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
  addSeveralRobots(app, parsed.options.robots);
  addSearch(app, parsed.options);
  addOutputs(app, parsed.options);
  refuseSrdf(app);
  fit_tool::addCacheOptions(app, parsed.options.cache, has_no_cache);
  try {
    app.parse(argc, argv);
    checkOptions(parsed.options);
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
