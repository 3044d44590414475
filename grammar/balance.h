// Which brackets and directives belong together. A first pass over the tokens of a file finds the
// partner of every bracket, so that the grammar proper never has to guess: a bracket without a
// partner in its own directive body is *stray* and becomes an item of its own (language §7.4).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.h"
#include "grammar/vocabulary.h"

namespace durer::grammar {

/// Bracket bookkeeping of one file. Outside of directive bodies everything must pair, except that
/// - the branches of a conditional may open what a later conditional, or the file, closes;
/// - macros and includes may open and close what their caller closes or has opened.
class Balance {
 public:
  Balance(std::string_view text, Loc base, const SymbolTable& symbols, Diagnostics& diagnostics,
          bool included = false)
      : text_(text),
        base_(base),
        symbols_(&symbols),
        diagnostics_(&diagnostics),
        included_(included) {
    regions_.push_back({});
  }

  void open(char bracket, std::size_t at);
  void close(char bracket, std::size_t at);
  /// `#` at `at`, followed by `word`.
  void directive(std::string_view word, std::size_t at, std::size_t size);
  /// The word after `#macro`.
  void macro_name(std::string_view name) { regions_.back().macro = name; }
  /// `name (`: macros of this file act as their bodies do, unknown ones may do anything.
  void call(std::string_view name, std::size_t at);
  /// The end of the file; false if anything was reported.
  [[nodiscard]] bool finish(std::size_t size);

  [[nodiscard]] bool has_strays() const { return !strays_.empty(); }
  /// True if the bracket at this offset has no partner; valid after finish().
  [[nodiscard]] bool is_stray(std::size_t at) const;

  /// Upper bounds for the size of the tree.
  std::size_t operands = 0;
  std::size_t operators = 0;
  std::size_t marks = 0;  // commas and such

 private:
  struct Mark {
    char bracket;
    std::size_t at;
    bool borrowed;  // opened by a directive body or a macro: its partner here is stray
  };
  /// What a body does to the text around it: closes these brackets, then opens those.
  struct Effect {
    std::string closes;
    std::string opens;
    [[nodiscard]] std::size_t size() const { return closes.size() + opens.size(); }
  };
  enum class Kind { file, conditional, switch_, loop, macro };
  struct Region {
    Kind kind = Kind::file;
    Span head;
    std::string_view macro;
    std::size_t first_mark = 0;
    std::string closes;  // of the branch so far
    Effect effect;       // of the longest branch so far
  };

  void begin(Kind kind, Span head);
  void next_branch(Kind expected, std::string_view word, Span at);
  void end(Span at);
  void end_branch(Region& region);
  void apply(const Effect& effect, std::size_t at);
  void apply_close(char bracket);
  void leave_open(const Mark& mark, Span noticed);
  void compare_indentation(std::size_t open, std::size_t close);
  Diagnostic& report(Span at, std::string message, std::string words, Label related = {});
  [[nodiscard]] Span span(std::size_t at, std::size_t size) const {
    return {static_cast<Loc>(base_ + at), static_cast<std::uint32_t>(size)};
  }

  std::string_view text_;
  Loc base_;
  const SymbolTable* symbols_;
  Diagnostics* diagnostics_;
  bool included_;
  std::vector<Diagnostic> found_;
  std::vector<Mark> marks_;
  std::vector<Region> regions_;
  std::vector<std::size_t> strays_;
  std::unordered_map<std::string_view, Effect> macros_;
  Span suspect_{};  // a `{` whose `}` is indented otherwise: the first of the file
  std::size_t last_unknown_call_ = 0;  // offset + 1; 0: none yet
};

}  // namespace durer::grammar
