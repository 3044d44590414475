// The words of the language as data. The grammar has no rule for any of them: it only asks whether
// a word can start an expression.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace durer::grammar {

/// Index into a SymbolTable. Reserved words come first, in the order of vocabulary.def.
using SymbolId = std::uint32_t;

enum class WordClass : std::uint8_t {
  identifier,  // not reserved: variables, macros, functions, arrays
  keyword,     // never a value: `sphere`, `rotate`, `rgb`
  value,       // `x`, `pi`, `true`, `clock`, `t` …: an operand by itself
  function,    // `sin`, `vrotate`, `concat` …: an operand together with its parenthesis
};

/// Reserved words as named constants: words::sphere is the SymbolId of "sphere"; words with C++
/// keyword spellings end in an underscore (words::if_).
namespace words {
enum : SymbolId {
#define DURER_WORD(enumerator, text, word_class) enumerator,
#include "grammar/vocabulary.def"
#undef DURER_WORD
  count_  // how many words are reserved
};
}  // namespace words

/// Words since 3.8, which follow the reserved ones: additions::mixed is the SymbolId of "mixed".
namespace additions {
enum : SymbolId {
  before_ = words::count_ - 1,
#define DURER_ADDITION(enumerator, text) enumerator,
#include "grammar/additions.def"
#undef DURER_ADDITION
  end_
};
}  // namespace additions

/// Interns names. One table serves all files of a run.
class SymbolTable {
 public:
  SymbolTable();
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  SymbolId intern(std::string_view text);
  /// The id of a name that may not have been seen; `none` if so.
  [[nodiscard]] SymbolId find(std::string_view text) const;
  [[nodiscard]] std::string_view text(SymbolId id) const { return texts_[id]; }
  [[nodiscard]] WordClass word_class(SymbolId id) const {
    return id < classes_.size() ? classes_[id] : WordClass::identifier;
  }
  [[nodiscard]] bool reserved(SymbolId id) const { return id < words::count_; }
  /// True for words that are reserved since 3.8 only.
  [[nodiscard]] static bool added(SymbolId id) {
    return id >= words::count_ && id < additions::end_;
  }
  [[nodiscard]] std::size_t size() const { return texts_.size(); }

  static constexpr SymbolId none = 0xFFFFFFFF;

 private:
  std::deque<std::string> texts_;  // a deque: views into it are the keys of ids_
  std::vector<WordClass> classes_;
  std::unordered_map<std::string_view, SymbolId> ids_;
};

}  // namespace durer::grammar
