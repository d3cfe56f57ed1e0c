/// \file
/// What a solution depends on, key by key: to tell what differs between two runs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cleft/problem/specification.hpp"

namespace cleft::scene {

/// A dotted key as `--set` takes it (cracks and boundaries by their names) and its value as JSON.
using KeyValue = std::pair<std::string, std::string>;

/// All keys of such a JSON text, in its order. Empty if the text is no JSON object.
std::vector<KeyValue> keys_and_values(const std::string& json);

/// `KEY (A before, B now)` for each key that differs between two such texts, those that only one has included.
std::vector<std::string> differences(const std::string& before, const std::string& now);

}  // namespace cleft::scene
