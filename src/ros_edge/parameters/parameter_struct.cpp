// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/parameter_struct.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

using XmlRpc::XmlRpcValue;

template <class T>
T valueAs(const XmlRpcValue& value) {
  return static_cast<T>(value);
}

std::string describe(const NumberRange& range) {
  std::string text = range.is_whole ? "a whole number " : "a number ";
  text += range.is_least_open ? "> " : ">= ";
  text += shortText(range.least);
  if (std::isfinite(range.greatest)) {
    text += " and <= " + shortText(range.greatest);
  }
  return text;
}

bool isNumberAsText(const XmlRpcValue& value) {
  Eigen::VectorXd number(1);
  return value.getType() == XmlRpcValue::TypeString &&
         !parseNumbers(valueAs<std::string>(value), number);
}

bool isIn(double value, const NumberRange& range) {
  return std::isfinite(value) && value <= range.greatest &&
         (!range.is_whole || value == std::floor(value)) &&
         (range.is_least_open ? value > range.least : value >= range.least);
}

}  // namespace

std::string toText(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeString:
      return quoted(valueAs<std::string>(value));
    case XmlRpcValue::TypeBoolean:
      return valueAs<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(valueAs<int>(value));
    case XmlRpcValue::TypeDouble:
      return shortText(valueAs<double>(value));
    case XmlRpcValue::TypeArray:
      return "a list of " + std::to_string(value.size());
    case XmlRpcValue::TypeStruct:
      return "a struct of " + std::to_string(value.size());
    default:
      return "a value of another type";
  }
}

namespace {

/// In double quotes, where YAML knows the escapes of JSON.
std::string doubleQuoted(const std::string& text) {
  std::string escaped = "\"";
  for (const char letter : text) {
    constexpr unsigned char kFirstVisible = 0x20;
    if (static_cast<unsigned char>(letter) < kFirstVisible) {
      constexpr const char* kDigits = "0123456789abcdef";
      escaped += "\\x";
      escaped += kDigits[static_cast<unsigned char>(letter) >> 4U];
      escaped += kDigits[static_cast<unsigned char>(letter) & 0xfU];
    } else {
      escaped += (letter == '"' || letter == '\\') ? "\\" : "";
      escaped += letter;
    }
  }
  return escaped + "\"";
}

std::string flowYaml(const XmlRpcValue& value) {
  std::string text;
  if (value.getType() == XmlRpcValue::TypeArray) {
    for (int i = 0; i < value.size(); ++i) {
      text += (i == 0 ? "" : ", ") + flowYaml(value[i]);
    }
    return "[" + text + "]";
  }
  if (value.getType() == XmlRpcValue::TypeStruct) {
    for (const auto& [name, field] : value) {
      text += (text.empty() ? "" : ", ") + doubleQuoted(name) + ": " + flowYaml(field);
    }
    return "{" + text + "}";
  }
  return value.getType() == XmlRpcValue::TypeString ? doubleQuoted(valueAs<std::string>(value))
                                                    : toText(value);
}

}  // namespace

std::string toYaml(const XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeArray || value.size() == 0) {
    return flowYaml(value);
  }
  std::string text;
  for (int i = 0; i < value.size(); ++i) {
    text += "- " + flowYaml(value[i]) + "\n";
  }
  return text;
}

ParameterStruct::ParameterStruct(const XmlRpcValue& values, std::string where, SetupReport& report)
    : values_(values), where_(std::move(where)), report_(report) {
  if (values_.valid() && values_.getType() != XmlRpcValue::TypeStruct) {
    report_.errors.push_back(
        {"parameter " + where_, toText(values_), "a struct of named parameters"});
  }
}

const XmlRpcValue* ParameterStruct::find(const std::string& name) {
  asked_for_.push_back(name);
  if (values_.getType() != XmlRpcValue::TypeStruct || !values_.hasMember(name)) {
    return nullptr;
  }
  return &values_[name];
}

void ParameterStruct::read(const std::string& name, const NumberRange& range, double& value) {
  const XmlRpcValue* found = find(name);
  if (found == nullptr) {
    return;
  }
  double read_value = std::nan("");
  if (found->getType() == XmlRpcValue::TypeInt) {
    read_value = valueAs<int>(*found);
  } else if (found->getType() == XmlRpcValue::TypeDouble) {
    read_value = valueAs<double>(*found);
  }
  if (!isIn(read_value, range)) {
    // YAML takes 1e3 for text, because it has no point and no sign in its exponent.
    const bool is_text = isNumberAsText(*found);
    refuse(
        name, toText(*found) + (is_text ? ", a text to YAML" : ""),
        describe(range) + (is_text ? ", without quotes, and without exponent or as 1.0e+3" : ""));
    return;
  }
  value = read_value;
}

void ParameterStruct::read(const std::string& name, bool& value) {
  const XmlRpcValue* found = find(name);
  if (found == nullptr) {
    return;
  }
  if (found->getType() != XmlRpcValue::TypeBoolean) {
    refuse(name, toText(*found), "true or false");
    return;
  }
  value = valueAs<bool>(*found);
}

void ParameterStruct::read(const std::string& name, std::string& value) {
  const XmlRpcValue* found = find(name);
  if (found == nullptr) {
    return;
  }
  if (found->getType() != XmlRpcValue::TypeString) {
    refuse(name, toText(*found), "a string");
    return;
  }
  value = valueAs<std::string>(*found);
}

void ParameterStruct::read(const std::string& name, const std::vector<std::string>& words,
                           std::size_t& position) {
  const XmlRpcValue* found = find(name);
  if (found == nullptr) {
    return;
  }
  const std::string word =
      found->getType() == XmlRpcValue::TypeString ? valueAs<std::string>(*found) : "";
  const auto place = std::find(words.begin(), words.end(), word);
  if (place == words.end()) {
    std::string accepted = "one of";
    for (const std::string& one : words) {
      accepted += " " + one;
    }
    refuse(name, toText(*found), accepted);
    return;
  }
  position = static_cast<std::size_t>(place - words.begin());
}

void ParameterStruct::tolerate(const std::string& name) { asked_for_.push_back(name); }

void ParameterStruct::refuseOthers() {
  if (values_.getType() != XmlRpcValue::TypeStruct) {
    return;
  }
  constexpr std::size_t kShown = 5;
  std::size_t count = 0;
  for (const auto& [name, value] : values_) {
    if (std::find(asked_for_.begin(), asked_for_.end(), name) != asked_for_.end() ||
        ++count > kShown) {
      continue;
    }
    const std::string nearest = nearestName(name, asked_for_);
    refuse(name, "an unknown parameter, " + toText(value),
           nearest.empty() ? "the names of config/monitor.yaml" : "perhaps '" + nearest + "'");
  }
  if (count > kShown) {
    report_.errors.push_back({"parameter " + where_,
                              std::to_string(count - kShown) + " more unknown parameters",
                              "the names of config/monitor.yaml"});
  }
}

void ParameterStruct::refuse(const std::string& name, const std::string& found,
                             const std::string& accepted) {
  report_.errors.push_back({"parameter " + pathOf(name), found, accepted});
}

}  // namespace collision_monitor
