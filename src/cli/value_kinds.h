// SPDX-License-Identifier: MIT
// What may stand behind an option, by the name that --help gives its value: METHOD, SCENE, DIR.
// Completions of shells follow from this table.
#pragma once

#include <string>
#include <vector>

namespace polhode {

enum class ValueForm { word, words_with_commas, file, folder };

struct ValueKind {
  std::string name;  // as type_name() has it
  ValueForm form = ValueForm::word;
  std::vector<std::string> words;    // of the word forms
  std::vector<std::string> endings;  // of files, without the dot; none: any file
};

const std::vector<ValueKind>& value_kinds();

// Null for values that nothing can complete, such as numbers.
const ValueKind* find_value_kind(const std::string& name);

}  // namespace polhode
