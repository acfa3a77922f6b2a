#include "listed_points.hpp"

#include "index_lists.hpp"
#include "point_order.hpp"

namespace wirepack {

ListedPoints listed_points(const MeasuredPoints& points, const std::vector<Index>& which,
                           ShapeModel model) {
  // known arcs give the order, too
  if (points.arc.size() > 0) return {picked(which, order_by(points.arc(which))), true, false};
  if (points.ordered) return {which, true, false};
  const Points position = points.position(Eigen::all, which);
  if (const std::vector<Index> order = order_of_list(position); !order.empty()) {
    return {picked(which, order), true, false};
  }
  if (model == ShapeModel::circle) return {which, false, true};
  if (const std::vector<Index> order = order_along_wire(position); !order.empty()) {
    return {picked(which, order), true, true};
  }
  return {which, false, true};
}

}  // namespace wirepack
