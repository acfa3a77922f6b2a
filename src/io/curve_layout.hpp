#pragma once

#include <cstddef>
#include <string>

#include "gnuplot.hpp"

namespace wirepack {

// 1, 2 or 5 times a power of ten, of which a range has so many or fewer: a distance of tics.
double tic_step(double range, int most);

// A graph of fixed size above a key of so many lines: no key is too long for its graph.
class CurveLayout {
 public:
  explicit CurveLayout(std::size_t key_lines);
  Canvas canvas() const { return canvas_; }
  // Places, grid, axes and key of the graph.
  std::string graph() const;
  // Places a smaller graph, without a key, on white within that one. Shares of the graph, from its
  // lower left corner; its labels take room outside of them.
  struct Box {
    double left, right, bottom, top;
  };
  std::string inset(const Box& box) const;

 private:
  Canvas canvas_;
};

}  // namespace wirepack
