// Docs of the language itself: what the registries know, and the directives and functions.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "cli/doc.h"
#include "functions/internals.h"

namespace durer::cli {
namespace {

struct WordDoc {
  std::string_view kind;
  std::string_view name;
  std::string_view usage;
  std::string_view text;
};

constexpr std::array word_docs = {
#define DURER_DOC(kind, name, usage, text) WordDoc{kind, name, usage, text},
#include "cli/doc_words.def"
#undef DURER_DOC
};

std::string operand(const scene::Param& p) {
  const std::string name(p.name);
  if (p.kind == scene::ArgKind::flag) return name;
  if (!p.positional) return name + " …";
  return p.optional ? fmt::format("[{}]", name) : name;
}

std::string_view kind_text(scene::ArgKind kind) {
  switch (kind) {
    case scene::ArgKind::number: return "a number";
    case scene::ArgKind::vector2: return "a vector of two";
    case scene::ArgKind::vector: return "a vector";
    case scene::ArgKind::pair: return "two numbers";
    case scene::ArgKind::flag: return "a switch";
  }
  return "";
}

DocEntry registered(const scene::TypeInfo& type, std::string_view kind, bool braces) {
  DocEntry entry;
  entry.name = type.name;
  entry.kind = kind;
  std::string operands;
  for (const scene::Param& p : type.params) {
    operands += (operands.empty() ? "" : p.positional ? ", " : " ") + operand(p);
    entry.text.push_back(fmt::format("{}: {}{}{}", p.name, p.doc, p.doc.empty() ? "" : "; ",
                                     kind_text(p.kind)));
  }
  entry.text.insert(entry.text.begin(), std::string(type.doc));
  entry.usage = braces ? fmt::format("{} {{ {}{}… }}", type.name, operands, operands.empty() ? "" : " ")
                       : fmt::format("{}{}{}", type.name, operands.empty() ? "" : " ", operands);
  return entry;
}

}  // namespace

std::vector<DocEntry> language_docs(const scene::Registry& registry) {
  std::vector<DocEntry> entries;
  for (const auto* type : registry.primitives) entries.push_back(registered(*type, "object", true));
  for (const auto* type : registry.patterns) entries.push_back(registered(*type, "pattern", false));
  for (const auto* type : registry.warps) entries.push_back(registered(*type, "warp", true));
  for (const WordDoc& word : word_docs) {
    entries.push_back({std::string(word.name), std::string(word.kind), {}, std::string(word.usage),
                       {std::string(word.text)}, {}});
  }
  for (const functions::InternalInfo& f : functions::internal_functions) {
    if (f.name == "pattern" || f.extra == 0) continue;
    entries.push_back({std::string(f.name), "function", "functions.inc",
                       fmt::format("{}(x, y, z, {})", f.name, f.parameters), {}, {}});
  }
  return entries;
}

}  // namespace durer::cli
