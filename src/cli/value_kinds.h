// SPDX-License-Identifier: MIT
// The table of kinds of option values, by the name that --help shows: METHOD, SCENE, DIR. Shell
// completions are made from it.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// How a value is completed.
enum class ValueForm { word, words_with_commas, file, folder };

// A kind of value.
struct ValueKind {
  std::string name;  // as in CLI11's type_name()
  ValueForm form = ValueForm::word;
  std::vector<std::string> words;    // allowed words, for the word forms
  std::vector<std::string> endings;  // of files, without the dot; empty: any file
};

// All kinds.
const std::vector<ValueKind>& value_kinds();

// The kind of that name; null for values that cannot be completed, such as numbers.
const ValueKind* find_value_kind(const std::string& name);

}  // namespace polhode
