// SPDX-License-Identifier: MIT
// Decks from text in memory.
#pragma once

#include <string>

#include "lecture/deck/deck.h"

namespace polhode::test {

inline Deck deck_of(const std::string& text) {
  return parse_deck(text, "deck.md", {".", false});
}

// the first problem of a deck; "none" if there is none
inline std::string problem_of(const std::string& text) {
  const Deck deck = deck_of(text);
  return deck.problems.empty() ? "none" : deck.problems.front().what();
}

// every kind of words that a deck has
inline constexpr const char* kAllKinds = R"(---
title: A *title*
author: [Ann One, Bo Two]
---

# Part[^1]

## Slide with `code_word` and 10⁻⁷

Words un*joined*, "quoted ~~struck~~", café, Ω and 3² [@cited, p. 3], naïve…dots – and so_on → [there](https://example.org/a%20b?c=d&e=f#g).

- One
  - Two^raised^ [small]{.smallcaps}

> Said

```cpp
std::puts("\nabout 5kg");  // \alpha
```

| Head^[inside] | more |
|---|---|
| cell | `other` |

: What it shows

Term
:   Meaning

$$x^2$$

::: notes
Say [this](https://example.org) and $y$.

| a1 | b2 |
|---|---|
| c3 | d4 |
:::

[^1]: The footnote.
)";

}  // namespace polhode::test
