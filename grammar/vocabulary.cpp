#include "grammar/vocabulary.h"

#include <iterator>

namespace durer::grammar {
namespace {

struct ReservedWord {
  std::string_view text;
  WordClass word_class;
};

constexpr ReservedWord reserved_words[] = {
#define DURER_WORD(enumerator, text, word_class) ReservedWord{text, WordClass::word_class},
#include "grammar/vocabulary.def"
#undef DURER_WORD
};

constexpr std::string_view added_words[] = {
#define DURER_ADDITION(enumerator, text) text,
#include "grammar/additions.def"
#undef DURER_ADDITION
};

}  // namespace

SymbolTable::SymbolTable() {
  ids_.reserve(2 * std::size(reserved_words));
  classes_.reserve(std::size(reserved_words));
  for (const ReservedWord& word : reserved_words) {
    intern(word.text);
    classes_.push_back(word.word_class);
  }
  for (const std::string_view word : added_words) intern(word);
}

SymbolId SymbolTable::intern(std::string_view text) {
  if (const auto known = ids_.find(text); known != ids_.end()) return known->second;
  const auto id = static_cast<SymbolId>(texts_.size());
  ids_.emplace(texts_.emplace_back(text), id);
  return id;
}

SymbolId SymbolTable::find(std::string_view text) const {
  const auto known = ids_.find(text);
  return known == ids_.end() ? none : known->second;
}

}  // namespace durer::grammar
