#include "gnuplot.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"

namespace wirepack {

namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  replace_file(path, std::vector<char>(text.begin(), text.end()));
}

/// A folder beside the figures for gnuplot to draw in, so that no figure is ever half a one.
class DrawingFolder {
 public:
  explicit DrawingFolder(const std::filesystem::path& beside) {
    std::string name = (beside / ".figure.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw FileError(beside.string() + ": cannot be written: " + std::strerror(errno));
    }
    path_ = name;
  }
  ~DrawingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Runs gnuplot on NAME.gp inside the folder, without a shell. The script is kept at `script`.
void run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                 const std::filesystem::path& script) {
  std::array<std::string, 2> words{"gnuplot", name + ".gp"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw FileError("gnuplot cannot be started: install it, or draw " + script.string() +
                    " elsewhere");
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child || status != 0) {
    throw FileError("gnuplot failed on " + script.string());
  }
}

}  // namespace

std::string gnuplot_title(const std::string& text) {
  std::string quoted;
  for (const char c : plain_text(text)) quoted += c == '\'' ? "\'\'" : std::string(1, c);
  return "title '" + quoted + "' noenhanced";
}

void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& name,
                       const std::string& data, const std::string& commands,
                       const std::string& size, const std::string& pixels) {
  make_folder(folder);
  std::string script = fmt::format("# draws {0}.png, {0}.pdf and {0}.svg from {0}.dat\n", name);
  const auto add = [&](const std::string& terminal, const std::string& extension) {
    script += fmt::format("set terminal {}\nset output '{}.{}'\n", terminal, name, extension);
    script += commands + "unset output\n";
  };
  add("pngcairo size " + pixels + " font 'sans,20' linewidth 2", "png");
  add("pdfcairo size " + size + " font 'sans,12'", "pdf");
  add("svg size 800,800 font 'sans,16'", "svg");
  const DrawingFolder drawing(folder);
  write_file(drawing.path() / (name + ".dat"), data);
  write_file(drawing.path() / (name + ".gp"), script);
  const auto keep = [&](const std::string& file) {
    const std::filesystem::path target = output_file(folder / file, {.inputs = {}, .force = true});
    replace_file(target, read_bytes(drawing.path() / file));
  };
  // data and script first: without gnuplot they are what is left
  for (const char* ending : {".dat", ".gp"}) keep(name + ending);
  run_gnuplot(drawing.path(), name, folder / (name + ".gp"));
  for (const char* ending : {".png", ".pdf", ".svg"}) keep(name + ending);
}

}  // namespace wirepack
