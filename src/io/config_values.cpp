#include "config_values.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/shape_file.hpp"

#include "number_hint.hpp"

namespace wirepack {

namespace {

std::string quoted_list(const std::vector<std::string_view>& values) {
  std::string text;
  for (const std::string_view value : values) {
    text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", value);
  }
  return text;
}

// The value if it has this type.
template <class Type>
const Type* held(const GivenKey& given) {
  return given.value ? std::get_if<Type>(&*given.value) : nullptr;
}

std::optional<ConfigValue> boolean(const GivenKey& given, std::string& problem) {
  if (const bool* value = held<bool>(given)) return ConfigValue(*value);
  problem = "must be true or false";
  return std::nullopt;
}

std::optional<ConfigValue> integer(const ConfigKey& key, const GivenKey& given,
                                   std::string& problem) {
  const auto* value = held<std::int64_t>(given);
  if (value != nullptr && *value >= key.smallest && *value <= key.largest) {
    return ConfigValue(*value);
  }
  problem = "must be an integer";
  if (value != nullptr) problem += fmt::format(" from {} to {}", key.smallest, key.largest);
  return std::nullopt;
}

std::optional<ConfigValue> number(const ConfigKey& key, const GivenKey& given,
                                  std::string& problem) {
  double value = NAN;
  if (const auto* v = held<double>(given)) value = *v;
  if (const auto* v = held<std::int64_t>(given)) value = static_cast<double>(*v);
  if (std::isfinite(value)) return ConfigValue(value);
  problem = "must be a finite number";
  if (!key.choices.empty()) problem += " or " + quoted_list(key.choices);
  if (const auto* word = held<std::string>(given)) problem += number_hint(*word);
  if (given.shown == "[...]" && key.section == "wire") {
    problem += ": the wire is the same along its length, sections of it are not read";
  }
  return std::nullopt;
}

std::optional<ConfigValue> vector(const GivenKey& given, std::string& problem) {
  const auto* value = held<Vec3>(given);
  if (value != nullptr && value->allFinite()) return ConfigValue(*value);
  problem = "must be three finite numbers, [x, y, z]";
  return std::nullopt;
}

// Rows, or those in a file.
std::optional<ConfigValue> shape(const GivenKey& given, const std::filesystem::path& folder,
                                 std::string& problem) {
  try {
    if (const auto file = named_file(given, folder)) return ConfigValue(read_shape(*file).rows());
    if (const auto* rows = held<std::vector<DarbouxRow>>(given)) {
      return ConfigValue(DarbouxTable(*rows).rows());
    }
    problem = "must be the name of a shape file, or rows [[s, k1, k2, k3], ...]";
  } catch (const InvalidInput& error) {
    problem = error.what();
  }
  return std::nullopt;
}

}  // namespace

std::optional<ConfigValue> converted(const ConfigKey& key, const GivenKey& given,
                                     const std::filesystem::path& folder, std::string& problem) {
  const auto* word = held<std::string>(given);
  const bool chosen = word != nullptr &&
                      std::find(key.choices.begin(), key.choices.end(), *word) != key.choices.end();
  if (chosen) return given.value;
  switch (key.type) {
    case ConfigType::boolean:
      return boolean(given, problem);
    case ConfigType::integer:
      return integer(key, given, problem);
    case ConfigType::number:
      return number(key, given, problem);
    case ConfigType::vector:
      return vector(given, problem);
    case ConfigType::choice:
      problem = "must be " + quoted_list(key.choices);
      return std::nullopt;
    case ConfigType::shape:
      return shape(given, folder, problem);
  }
  return std::nullopt;
}

std::optional<std::filesystem::path> named_file(const GivenKey& given,
                                                const std::filesystem::path& folder) {
  const auto* name = held<std::string>(given);
  if (name == nullptr) return std::nullopt;
  return (given.overrides ? given.folder : folder) / *name;
}

}  // namespace wirepack
