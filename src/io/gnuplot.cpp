#include "gnuplot.hpp"

#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"
#include "child_program.hpp"
#include "drawing_folder.hpp"

namespace wirepack {

namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  replace_file(path, std::vector<char>(text.begin(), text.end()));
}

// A terminal of gnuplot with the size of its letters; commands find that of smaller ones in the
// variable `small`.
struct Terminal {
  std::string name;
  double font;
  std::string more;
};

Terminal png_terminal(const Canvas& canvas) {
  return {fmt::format("pngcairo size {},{}", canvas.width, canvas.height), 20, " linewidth 2"};
}

std::string drawn_to(const Terminal& terminal, const std::string& file,
                     const std::string& commands) {
  return fmt::format(
      "set terminal {} font 'sans,{}'{}\nset encoding utf8\nsmall = ',{:.1f}'\n"
      "set output '{}'\n{}unset output\n",
      terminal.name, terminal.font, terminal.more, 0.77 * terminal.font, file, commands);
}

std::string whole_script(const Drawing& drawing) {
  const auto [width, height] = drawing.canvas;
  constexpr double per_centimetre = 1200.0 / 14;
  const std::string& name = drawing.name;
  const Terminal pdf{fmt::format("pdfcairo size {:.2f}cm,{:.2f}cm", width / per_centimetre,
                                 height / per_centimetre),
                     9, ""};
  const Terminal svg{fmt::format("svg size {},{}", width * 31 / 50, height * 31 / 50), 16, ""};
  return fmt::format("# draws {0}.png, {0}.pdf and {0}.svg from {0}.dat\n", name) +
         drawn_to(png_terminal(drawing.canvas), name + ".png", drawing.commands) +
         drawn_to(pdf, name + ".pdf", drawing.commands) +
         drawn_to(svg, name + ".svg", drawing.commands);
}

// `script` is the name of the script's file in messages.
void run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                 const std::filesystem::path& script) {
  const std::optional<int> code = run_child_program(folder, {"gnuplot", name + ".gp"});
  if (!code) {
    throw FileError("gnuplot cannot be started: install it, or draw " + script.string() +
                    " elsewhere");
  }
  if (*code != 0) throw FileError("gnuplot failed on " + script.string());
}

void write_sources(const std::filesystem::path& folder, const Drawing& drawing,
                   const std::string& script) {
  write_file(folder / (drawing.name + ".dat"), drawing.data);
  write_file(folder / (drawing.name + ".gp"), script);
  for (const DrawingPart& part : drawing.parts) write_file(folder / part.name, part.bytes);
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string quoted;
  for (const char c : plain_text(text)) quoted += c == '\'' ? "\'\'" : std::string(1, c);
  return "'" + quoted + "' noenhanced";
}

std::string gnuplot_title(const std::string& text) { return "title " + gnuplot_text(text); }

void draw_with_gnuplot(const std::filesystem::path& folder, const Drawing& drawing) {
  make_folder(folder);
  const DrawingFolder drawn(folder);
  write_sources(drawn.path(), drawing, whole_script(drawing));
  const auto keep = [&](const std::string& file) {
    const std::filesystem::path target = output_file(folder / file, {.inputs = {}, .force = true});
    replace_file(target, read_bytes(drawn.path() / file));
  };
  // data and script first: without gnuplot they are what is left
  for (const char* ending : {".dat", ".gp"}) keep(drawing.name + ending);
  for (const DrawingPart& part : drawing.parts) keep(part.name);
  run_gnuplot(drawn.path(), drawing.name, folder / (drawing.name + ".gp"));
  for (const char* ending : {".png", ".pdf", ".svg"}) keep(drawing.name + ending);
}

void draw_png(const std::filesystem::path& png, const Drawing& drawing) {
  const DrawingFolder drawn(png.parent_path());
  const std::string file = drawing.name + ".png";
  write_sources(drawn.path(), drawing,
                drawn_to(png_terminal(drawing.canvas), file, drawing.commands));
  run_gnuplot(drawn.path(), drawing.name, png);
  replace_file(output_file(png, {.inputs = {}, .force = true}), read_bytes(drawn.path() / file));
}

}  // namespace wirepack
