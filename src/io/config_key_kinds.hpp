#pragma once

#include <type_traits>
#include <utility>

#include "config_keys.hpp"

// Kinds of keys: how each reads its value into a scenario and writes it from there.
namespace wirepack::config {

// Access to a member of a scenario, or to a member of a member.
template <class Member>
auto in(Member Scenario::*member) {
  return [=](auto& scenario) -> auto& { return scenario.*member; };
}
template <class Part, class Member>
auto in(Part Scenario::*part, Member Part::*member) {
  return [=](auto& scenario) -> auto& { return scenario.*part.*member; };
}

inline ConfigKey named(std::string_view section, std::string_view name) {
  ConfigKey key;
  key.section = section;
  key.name = name;
  return key;
}

// A key that stands for one member of the scenario; `access` gives a reference to it.
template <class Access>
ConfigKey member(std::string_view section, std::string_view name, Access access) {
  using Member = std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>;
  ConfigKey key = named(section, name);
  if constexpr (std::is_same_v<Member, bool>) {
    key.type = ConfigType::boolean;
    key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<bool>(v); };
    key.get = [access](const Scenario& s) { return ConfigValue(access(s)); };
  } else if constexpr (std::is_integral_v<Member>) {
    key.type = ConfigType::integer;
    key.smallest = std::is_unsigned_v<Member> ? 0 : std::numeric_limits<int>::min();
    key.largest = std::is_same_v<Member, int> ? std::numeric_limits<int>::max()
                                              : std::numeric_limits<std::int64_t>::max();
    key.set = [access](Scenario& s, const ConfigValue& v) {
      access(s) = static_cast<Member>(std::get<std::int64_t>(v));
    };
    key.get = [access](const Scenario& s) {
      return ConfigValue(static_cast<std::int64_t>(access(s)));
    };
  } else {
    key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<double>(v); };
    key.get = [access](const Scenario& s) { return ConfigValue(access(s)); };
  }
  return key;
}

// A key without a value until it is given.
template <class Access>
ConfigKey optional_value(std::string_view section, std::string_view name, Access access) {
  using Value =
      typename std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>::value_type;
  ConfigKey key = named(section, name);
  key.type = std::is_same_v<Value, double> ? ConfigType::number
             : std::is_same_v<Value, Vec3> ? ConfigType::vector
                                           : ConfigType::integer;
  key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<Value>(v); };
  key.get = [access](const Scenario& s) {
    const std::optional<Value> value = access(s);
    return value ? std::optional<ConfigValue>(*value) : std::nullopt;
  };
  return key;
}

inline ConfigKey may_change(ConfigKey key) {
  key.may_change = true;
  return key;
}

// A number, or the word that leaves it to the program.
inline ConfigKey or_auto(ConfigKey key) {
  key.choices = {"auto"};
  const auto set = key.set;
  key.set = [set](Scenario& s, const ConfigValue& v) {
    if (std::holds_alternative<double>(v)) set(s, v);
  };
  const auto get = key.get;
  key.get = [get](const Scenario& s) {
    const std::optional<ConfigValue> value = get(s);
    return value ? *value : ConfigValue(std::string("auto"));
  };
  return key;
}

template <class Names, class Access>
ConfigKey choice(std::string_view section, std::string_view name, const Names& names,
                 Access access) {
  ConfigKey key = named(section, name);
  key.type = ConfigType::choice;
  for (const auto& [value, text] : names) key.choices.emplace_back(text);
  key.set = [access, names](Scenario& s, const ConfigValue& v) {
    for (const auto& [value, text] : names) {
      if (std::get<std::string>(v) == text) access(s) = value;
    }
  };
  key.get = [access, names](const Scenario& s) {
    ConfigValue result;
    for (const auto& [value, text] : names) {
      if (access(s) == value) result = std::string(text);
    }
    return result;
  };
  return key;
}

// What only reading goes by: other keys follow from it, and it is never written.
inline ConfigKey stand_in(std::string_view section, std::string_view name) {
  ConfigKey key = named(section, name);
  key.set = [](Scenario&, const ConfigValue&) {};
  key.get = [](const Scenario&) -> std::optional<ConfigValue> { return std::nullopt; };
  return key;
}

}  // namespace wirepack::config
