#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "wirepack/io/output_path.hpp"
#include "wirepack/io/view_page.hpp"

#include "command.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct Options {
  std::string result, page;
  std::size_t frames = 40;
  bool force = false;
};

int view(const Options& options) {
  const OutputRules rules{.inputs = {options.result}, .force = options.force};
  write_view_page(options.result, output_file(options.page, rules), options.frames);
  print_lines(options.page + "\n");
  return exit_done;
}

}  // namespace

Command view_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "view", "One page to look at a packing in a browser, without server and network");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->result, "Result of wirepack run")->required();
  app->add_option("-o,--output", options->page, "The page")->required()->type_name("PAGE.html");
  app->add_option("--frames", options->frames, "At most so many of the saved frames, evenly spread")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}));
  app->add_flag("--force", options->force, "Replaces an existing PAGE.html");
  app->footer("Example: wirepack view quickstart.h5 -o quickstart.html");
  return {app, [options] { return view(*options); }};
}

}  // namespace wirepack
