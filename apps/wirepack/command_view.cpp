#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "wirepack/core/error.hpp"
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

void require_free(const std::string& page, const std::string& result, bool force) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(page, error);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::equivalent(page, result, error)) {
    throw InvalidInput(page + " is the result itself; the page needs a name of its own");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InvalidInput(page + " is not a regular file: a page cannot go there");
  }
  if (!force) throw InvalidInput(page + " exists; --force replaces it");
}

int view(const Options& options) {
  require_free(options.page, options.result, options.force);
  write_view_page(options.result, options.page, options.frames);
  print_lines(options.page + "\n");
  return exit_done;
}

}  // namespace

Command view_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "view", "One page to look at a packing in a browser, without server and network");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->result, "Result of wirepack run")->required();
  app->add_option("-o,--output", options->page, "The page, PAGE.html")->required();
  app->add_option("--frames", options->frames,
                  "At most so many of the saved frames, evenly spread (default 40)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}));
  app->add_flag("--force", options->force, "Replaces an existing PAGE.html");
  app->footer("Example: wirepack view quickstart.h5 -o quickstart.html");
  return {app, [options] { return view(*options); }};
}

}  // namespace wirepack
