#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/doc.h"

namespace durer::cli {

std::string doc_text(const DocEntry& entry) {
  std::string out = fmt::format("{}\n  {}{}{}\n", entry.usage, entry.kind,
                                entry.place.empty() ? "" : " of ", entry.place);
  if (!entry.text.empty()) out += '\n';
  for (const std::string& line : entry.text) out += fmt::format("  {}\n", line);
  if (!entry.value.empty()) {
    std::string value = entry.value;
    for (std::size_t at = 0; (at = value.find('\n', at)) != std::string::npos; at += 3) {
      value.insert(at + 1, "  ");
    }
    out += fmt::format("\n  {}\n", value);
  }
  return out;
}

std::string doc_json(std::span<const DocEntry> entries) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const DocEntry& e : entries) {
    list.push_back({{"name", e.name},
                    {"kind", e.kind},
                    {"place", e.place},
                    {"usage", e.usage},
                    {"text", e.text},
                    {"value", e.value}});
  }
  return list.dump(1) + "\n";
}

}  // namespace durer::cli
