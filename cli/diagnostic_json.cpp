#include "cli/diagnostic_json.h"

#include <nlohmann/json.hpp>

namespace durer::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view severity_text(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return "";
}

void add_place(Json& json, Span span, const SourceMap& sources) {
  if (span.begin == 0) return;
  const Place begin = sources.place(span.begin);
  json["file"] = begin.path;
  json["line"] = begin.line;
  json["column"] = begin.column;
  const FileId file = sources.file_of(span.begin);
  const Loc last = sources.base(file) + static_cast<Loc>(sources.text(file).size());
  const Place end = sources.place(std::min(span.end(), last));
  json["end"] = {{"line", end.line}, {"column", end.column}};
}

template <typename Places>
void add_places(Json& json, const char* name, const Places& places, const SourceMap& sources) {
  for (const auto& place : places) {
    Json one;
    one["text"] = place.text;
    add_place(one, place.span, sources);
    json[name].push_back(std::move(one));
  }
}

/// Scenes may hold bytes that are not UTF-8; JSON may not.
std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string diagnostic_json(const Diagnostic& d, const SourceMap& sources) {
  Json json;
  json["kind"] = "diagnostic";
  json["severity"] = severity_text(d.severity);
  json["code"] = code_text(d.code);
  json["message"] = d.message;
  add_place(json, d.span, sources);
  if (!d.at.empty()) json["at"] = d.at;
  add_places(json, "labels", d.labels, sources);
  for (const std::string& help : d.help) json["help"].push_back(help);
  add_places(json, "trace", d.trace, sources);
  return line_of(json);
}

std::string message_json(std::string_view stream, std::string_view text) {
  return line_of(Json{{"kind", "message"}, {"stream", stream}, {"text", text}});
}

}  // namespace durer::cli
