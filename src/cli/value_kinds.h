// SPDX-License-Identifier: MIT
// The table of kinds of option values, by the name that --help shows: METHOD, SCENE, DIR. Shell
// completions, and the lists of allowed values in manual pages, are made from it.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// What a value is, which decides how it is completed: one of some words, several of them separated
// by commas, a file, or a folder.
enum class ValueForm { word, words_with_commas, file, folder };

// A kind of value.
struct ValueKind {
  std::string name;  // as in CLI11's type_name(), such as "METHOD"
  ValueForm form = ValueForm::word;
  std::vector<std::string> words;    // the allowed words, for the two word forms
  std::vector<std::string> endings;  // of the files to offer, without the dot; empty: any file
};

// All kinds. The table exists until the program ends.
const std::vector<ValueKind>& value_kinds();

// The row of value_kinds() with that name; null for values that cannot be completed, such
// as numbers.
const ValueKind* find_value_kind(const std::string& name);

}  // namespace polhode
