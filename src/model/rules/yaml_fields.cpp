// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/rules/yaml_fields.h"

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "model/number_text.h"
#include "model/visible_text.h"

namespace collision_monitor {
namespace {

std::string rangeText(int count, double least, double greatest) {
  std::ostringstream text;
  text << (count == 1 ? "a number" : "a list of " + std::to_string(count) + " numbers") << " from "
       << least << " to " << greatest;
  return text.str();
}

/// Reads a number from its text: the same in every locale, and never "0x10" or ".inf".
bool readNumberIn(const YAML::Node& node, double least, double greatest, double& number) {
  Eigen::VectorXd read(1);
  if (!node.IsScalar() || parseNumbers(node.Scalar(), read) || read[0] < least ||
      read[0] > greatest) {
    return false;
  }
  number = read[0];
  return true;
}

}  // namespace

YAML::Node loadYaml(const std::string& text) {
  // Other encodings begin with a byte order mark, or with a letter of several bytes.
  const bool is_wide = text.size() > 1 && (text[0] == '\0' || text[1] == '\0' ||
                                           static_cast<unsigned char>(text[0]) >= 0xFE);
  const std::size_t wrong = is_wide ? text.size() : firstNoUtf8(text);
  if (wrong < text.size()) {
    YAML::Mark mark;
    mark.line = static_cast<int>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(wrong), '\n'));
    throw YAML::Exception(mark, "a byte that is no UTF-8");
  }
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  if (documents.size() > 1) {
    throw YAML::Exception(documents[1].Mark(), "a second document");
  }
  return documents.empty() ? YAML::Node() : documents.front();
}

int lineOf(const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  return mark.is_null() ? 0 : mark.line + 1;
}

std::string describe(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return quoted(node.Scalar());
    case YAML::NodeType::Sequence: {
      // Show a short list as written.
      std::string text = "[";
      for (const YAML::Node& item : node) {
        text += (text.size() == 1 ? "" : ", ") + (item.IsScalar() ? item.Scalar() : "...");
      }
      constexpr std::size_t kLongest = 60;
      return text.size() < kLongest ? text + "]" : "a list of " + std::to_string(node.size());
    }
    case YAML::NodeType::Map:
      return "a map of " + std::to_string(node.size());
    default:
      return "nothing";
  }
}

YAML::Node childOf(const YAML::Node& node, const std::string& key) {
  return node.IsDefined() && node.IsMap() ? node[key] : YAML::Node(YAML::NodeType::Undefined);
}

YamlFields::YamlFields(const YAML::Node& node, const Place& place, const std::string& what)
    : node_(node), place_(place) {
  if (!node_.IsMap()) {
    place_.addError(lineOf(node_), describe(node_), what);
    // An assignment would change the document.
    node_.reset(YAML::Node(YAML::NodeType::Map));
  }
}

std::optional<YAML::Node> YamlFields::find(const std::string& key) {
  asked_for_.push_back(key);
  for (const auto& field : node_) {
    if (field.first.IsScalar() && field.first.Scalar() == key) {
      return field.second;
    }
  }
  return std::nullopt;
}

std::optional<std::string> YamlFields::readText(const std::string& key,
                                                const std::string& accepted) {
  const std::optional<YAML::Node> field = find(key);
  if (field && (!field->IsScalar() || field->Scalar().empty())) {
    refuse(key, accepted);
    return std::nullopt;
  }
  return field ? std::optional<std::string>(field->Scalar()) : std::nullopt;
}

std::optional<bool> YamlFields::readBool(const std::string& key) {
  const std::optional<YAML::Node> field = find(key);
  bool value = false;
  if (field && !YAML::convert<bool>::decode(*field, value)) {
    refuse(key, "true or false");
    return std::nullopt;
  }
  return field ? std::optional<bool>(value) : std::nullopt;
}

std::vector<YAML::Node> YamlFields::readWords(const std::string& key, const std::string& accepted) {
  const std::optional<YAML::Node> field = find(key);
  if (!field) {
    return {};
  }
  std::vector<YAML::Node> words;
  if (field->IsSequence()) {
    for (const YAML::Node& word : *field) {
      words.push_back(word);
    }
  } else {
    words.push_back(*field);
  }
  const bool are_words = std::all_of(words.begin(), words.end(), [](const YAML::Node& word) {
    return word.IsScalar() && !word.Scalar().empty();
  });
  if (words.empty() || !are_words) {
    refuse(key, accepted);
    return {};
  }
  return words;
}

std::optional<Eigen::VectorXd> YamlFields::readNumbers(const std::string& key, int count,
                                                       double least, double greatest) {
  const std::optional<YAML::Node> field = find(key);
  if (!field) {
    return std::nullopt;
  }
  Eigen::VectorXd numbers(count);
  bool is_good = count == 1 || (field->IsSequence() && field->size() == std::size_t(count));
  for (int i = 0; i < count && is_good; ++i) {
    is_good = readNumberIn(count == 1 ? *field : (*field)[i], least, greatest, numbers[i]);
  }
  if (!is_good) {
    refuse(key, rangeText(count, least, greatest));
    return std::nullopt;
  }
  return numbers;
}

std::optional<double> YamlFields::readNumber(const std::string& key, double least,
                                             double greatest) {
  const std::optional<Eigen::VectorXd> number = readNumbers(key, 1, least, greatest);
  return number ? std::optional<double>((*number)[0]) : std::nullopt;
}

Eigen::VectorXd YamlFields::readLengths(const std::string& key, int count, double least,
                                        double greatest) {
  Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  if (!find(key)) {
    refuse("kind", "with " + key + ", in metres");
    return ones;
  }
  return readNumbers(key, count, least, greatest).value_or(ones);
}

void YamlFields::refuse(const std::string& key, const std::string& accepted) {
  const YAML::Node value = *find(key);
  place_.addError(lineOf(value), key + " " + describe(value), accepted);
}

bool YamlFields::refuseOthers() {
  bool has_refused = false;
  std::set<std::string> seen;
  const std::set<std::string> known(asked_for_.begin(), asked_for_.end());
  for (const auto& field : node_) {
    const std::string key = field.first.IsScalar() ? field.first.Scalar() : "";
    if (known.count(key) == 0) {
      place_.addError(lineOf(field.first), "an unknown key, " + describe(field.first),
                      joined({known.begin(), known.end()}));
    } else if (!seen.insert(key).second) {
      place_.addError(lineOf(field.first), key + " a second time", "each key once");
    } else {
      continue;
    }
    has_refused = true;
  }
  return has_refused;
}

}  // namespace collision_monitor
