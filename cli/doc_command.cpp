// `durer doc`: what a name means.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/suggest.h"
#include "cli/commands.h"
#include "cli/doc.h"
#include "cli/scene_file.h"
#include "tracer/compile.h"

namespace durer::cli {
namespace {

constexpr const char* usage =
    "usage: durer doc NAME...   what a macro, colour, texture, object, pattern, function or\n"
    "                           directive means\n"
    "       durer doc --list [KIND]   all names, or those of a kind\n"
    "       durer doc --json    everything, for programs\n";

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// All entries of that name; if there is none, all whose name differs in case only.
std::vector<const DocEntry*> find(std::span<const DocEntry> entries, std::string name) {
  if (name.starts_with('#')) name.erase(0, 1);
  std::vector<const DocEntry*> exact;
  std::vector<const DocEntry*> similar;
  for (const DocEntry& e : entries) {
    if (e.name == name) exact.push_back(&e);
    if (lower(e.name) == lower(name)) similar.push_back(&e);
  }
  return exact.empty() ? similar : exact;
}

bool explain(std::span<const DocEntry> entries, const std::string& name) {
  const auto found = find(entries, name);
  for (const DocEntry* e : found) {
    fmt::print("{}{}", e == found.front() ? "" : "\n", doc_text(*e));
  }
  if (!found.empty()) return true;
  std::vector<std::string_view> names;
  for (const DocEntry& e : entries) names.emplace_back(e.name);
  fmt::print(stderr, "error: nothing is known of `{}`\n", name);
  if (const auto near = closest(name, names)) {
    fmt::print(stderr, "   = help: did you mean `{}`?\n", *near);
  }
  return false;
}

void list(std::span<const DocEntry> entries, const std::string& kind) {
  std::map<std::string, std::vector<std::string>> names;
  for (const DocEntry& e : entries) {
    if (kind.empty() || e.kind == kind) names[e.kind].push_back(e.name);
  }
  for (const auto& [of, which] : names) fmt::print("{}: {}\n", of, fmt::join(which, " "));
}

}  // namespace

int doc_command(const std::vector<std::string>& words) {
  if (words.empty() || words.front() == "--help") {
    fmt::print(words.empty() ? stderr : stdout, usage);
    return words.empty() ? exit_code::error : exit_code::ok;
  }
  std::vector<DocEntry> entries = language_docs(tracer::registry());
  const std::vector<DocEntry> library = library_docs(stdlib_folder());
  entries.insert(entries.end(), library.begin(), library.end());
  if (words.front() == "--json") {
    fmt::print("{}", doc_json(entries));
    return exit_code::ok;
  }
  if (words.front() == "--list") {
    list(entries, words.size() > 1 ? words[1] : "");
    return exit_code::ok;
  }
  bool good = true;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) fmt::print("\n");
    good = explain(entries, words[k]) && good;
  }
  return good ? exit_code::ok : exit_code::error;
}

}  // namespace durer::cli
