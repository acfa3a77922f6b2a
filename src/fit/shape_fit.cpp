#include "wirepack/fit/shape_fit.hpp"

#include <iterator>
#include <vector>

#include "chosen_points.hpp"
#include "fit_outliers.hpp"
#include "fit_result.hpp"
#include "index_lists.hpp"
#include "ordered_fit.hpp"
#include "points_check.hpp"

namespace wirepack {

ShapeFit fit_shape(const MeasuredPoints& given, const FitOptions& options) {
  std::vector<Index> left_out = errors_of_measurement(given.position);
  if (given.count() - std::ssize(left_out) < fewest_points(options.model)) left_out.clear();
  const auto kept = [&] { return all_without(given.count(), left_out); };
  check_points(chosen(given, kept()), options);
  OrderedFit fit = ordered_fit(given, kept(), options);
  // what stands alone, but on the curve, is no error
  const auto is_no_error = [&](Index i) { return lies_on(fit, given.position.col(i)); };
  if (std::erase_if(left_out, is_no_error) > 0) fit = ordered_fit(given, kept(), options);
  return fit_result(fit, given, left_out, options.model);
}

}  // namespace wirepack
