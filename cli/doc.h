// What `durer doc` knows: the words of the language and the names of the standard library.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/type_info.h"

namespace durer::cli {

/// One thing that can be explained.
struct DocEntry {
  std::string name;
  std::string kind;               // macro, colour, texture, object, pattern, function, directive …
  std::string place;              // the include that declares it; empty for the language itself
  std::string usage;              // how it is written
  std::vector<std::string> text;  // lines of explanation
  std::string value;              // source text of a declaration; empty for macros and words
};

/// Everything that the includes of `folder` declare or explain: docstrings (`///` lines) before
/// `#macro` and `#declare` at the start of a line. Macros without one are helpers and left out.
[[nodiscard]] std::vector<DocEntry> library_docs(const std::string& folder);
/// The names that one include declares; `file` is its name, `text` its source.
void read_library_docs(const std::string& file, const std::string& text,
                       std::vector<DocEntry>& entries);
/// Objects, patterns and warps from the registry; directives and built-in functions.
[[nodiscard]] std::vector<DocEntry> language_docs(const scene::Registry& registry);

/// An entry for people to read in a terminal.
[[nodiscard]] std::string doc_text(const DocEntry& entry);
/// All entries as a JSON list of objects with the members of `DocEntry`.
[[nodiscard]] std::string doc_json(std::span<const DocEntry> entries);

}  // namespace durer::cli
