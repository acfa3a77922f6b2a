#include "markups_file.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

using nlohmann::json;

// The entries of a list in an object; none where there is no such list.
std::vector<json> list_in(const json& object, const char* key) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_array()) return {};
  return object[key].get<std::vector<json>>();
}

bool is_placed(const json& point) {
  return !point.is_object() || !point.contains("positionStatus") ||
         point["positionStatus"] == "defined";
}

}  // namespace

MeasuredPoints markups_points(const std::string& text, const std::string& name) {
  const json root = json::parse(text, nullptr, false);
  if (root.is_discarded()) throw InvalidInput(name + ": is not JSON");
  std::vector<Vec3> places;
  int lists = 0;
  for (const json& markup : list_in(root, "markups")) {
    const std::vector<json> points = list_in(markup, "controlPoints");
    if (!points.empty()) ++lists;
    for (const json& point : points) {
      if (!is_placed(point)) continue;
      const std::vector<json> place = list_in(point, "position");
      Vec3 position = Vec3::Constant(NAN);
      for (Index c = 0; c < 3 && place.size() == 3; ++c) {
        const json& number = place[static_cast<std::size_t>(c)];
        if (number.is_number()) position[c] = number.get<double>();
      }
      if (!position.allFinite() || position.cwiseAbs().maxCoeff() > 1e100) {
        throw InvalidInput(fmt::format("{}: the position of point {} must be three finite numbers",
                                       name, places.size() + 1));
      }
      places.push_back(position);
    }
  }
  if (lists > 1) {
    throw InvalidInput(fmt::format("{}: has {} lists of points; must be one wire", name, lists));
  }
  if (places.empty()) {
    throw InvalidInput(name + ": holds no points; must be 3D Slicer's markups with controlPoints");
  }
  MeasuredPoints result;
  result.position.resize(3, std::ssize(places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    result.position.col(static_cast<Index>(i)) = places[i];
  }
  return result;
}

}  // namespace wirepack
