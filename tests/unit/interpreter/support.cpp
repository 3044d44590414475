#include "support.h"

#include <array>

#include <fmt/format.h>

#include "scene/dump.h"

namespace durer::interpreter::test {
namespace {

using scene::ArgKind;
using scene::Param;

constexpr std::array sphere_params = {Param{"center", ArgKind::vector, "centre"},
                                      Param{"radius", ArgKind::number, "radius"}};
constexpr std::array box_params = {Param{"a", ArgKind::vector, "first corner"},
                                   Param{"b", ArgKind::vector, "second corner"}};
constexpr std::array cylinder_params = {
    Param{"a", ArgKind::vector, "base"}, Param{"b", ArgKind::vector, "cap"},
    Param{"r", ArgKind::number, "radius"}, Param{"open", ArgKind::flag, "without caps", false}};
std::optional<std::string> check_cylinder(std::span<const double> a) {
  if (a[0] == a[3] && a[1] == a[4] && a[2] == a[5]) return "the ends of this cylinder coincide";
  return std::nullopt;
}
constexpr scene::TypeInfo sphere = {"sphere", "A ball.", sphere_params};
constexpr scene::TypeInfo box = {"box", "A box.", box_params};
constexpr scene::TypeInfo cylinder = {"cylinder", "A rod.", cylinder_params, check_cylinder};
constexpr scene::TypeInfo mesh = {"mesh", "Triangles.", {}};
constexpr scene::TypeInfo isosurface = {"isosurface", "A function's zeros.", {}};
constexpr scene::TypeInfo parametric = {"parametric", "A function's values.", {}};
// What lists of points become; their types know what these mean.
constexpr scene::TypeInfo lathe = {"lathe", "A turned curve.", {}};
constexpr scene::TypeInfo prism = {"prism", "A pulled curve.", {}};
constexpr scene::TypeInfo sor = {"sor", "Another turned curve.", {}};
constexpr scene::TypeInfo sphere_sweep = {"sphere_sweep", "A ball on its way.", {}};
constexpr scene::TypeInfo polygon = {"polygon", "A flat face.", {}};
constexpr scene::TypeInfo bicubic_patch = {"bicubic_patch", "A bent face.", {}};
constexpr std::array<const scene::TypeInfo*, 12> primitives = {
    &sphere, &box,   &cylinder, &mesh,         &isosurface, &parametric,
    &lathe,  &prism, &sor,      &sphere_sweep, &polygon,    &bicubic_patch};

constexpr std::array gradient_params = {Param{"direction", ArgKind::vector, "direction"}};
constexpr std::array<scene::MapEntry, 2> checker_map = {
    scene::MapEntry{0, {glm::vec3(0, 0, 1), 0, 0}}, scene::MapEntry{1, {glm::vec3(0, 1, 0), 0, 0}}};
constexpr std::array<scene::MapEntry, 2> grey_map = {
    scene::MapEntry{0, {glm::vec3(0, 0, 0), 0, 0}}, scene::MapEntry{1, {glm::vec3(1, 1, 1), 0, 0}}};
constexpr scene::PatternInfo checker = {
    {"checker", "Cubes.", {}}, scene::Wave::ramp, 2, checker_map};
constexpr scene::PatternInfo gradient = {
    {"gradient", "Bands.", gradient_params}, scene::Wave::ramp, 0, grey_map};
constexpr scene::PatternInfo function = [] {
  scene::PatternInfo info{
      {"function", "The value of a function.", {}}, scene::Wave::ramp, 0, grey_map};
  info.takes_function = true;
  return info;
}();
constexpr scene::PatternInfo average = [] {
  scene::PatternInfo info{{"average", "All of it.", {}}, scene::Wave::ramp, 0, {}};
  info.averages = true;
  return info;
}();
constexpr std::array<const scene::PatternInfo*, 4> patterns = {&checker, &gradient, &function,
                                                               &average};

constexpr std::array turbulence_params = {
    Param{"amount", ArgKind::vector, "amount"},
    Param{"octaves", ArgKind::number, "octaves", false, true, {6}},
    Param{"omega", ArgKind::number, "omega", false, true, {0.5}},
    Param{"lambda", ArgKind::number, "lambda", false, true, {2}}};
constexpr std::array repeat_params = {Param{"step", ArgKind::vector, "step"},
                                      Param{"flip", ArgKind::vector, "flip", false, true}};
constexpr scene::TypeInfo turbulence = {"turbulence", "Stirs.", turbulence_params};
constexpr scene::TypeInfo repeat = {"repeat", "Repeats.", repeat_params};
constexpr std::array<const scene::TypeInfo*, 2> warps = {&turbulence, &repeat};

}  // namespace

Run run(const std::string& text, bool header, Options options, const std::string& path) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  const std::string head = "#version 3.7; global_settings { assumed_gamma 1 }\n";
  const FileId file = sources.add(path, (header ? head : std::string()) + text);
  Run r;
  options.on_debug = [&](std::string_view s) { r.debug += s; };
  const scene::Registry registry = {primitives, patterns, warps};
  r.scene = interpret(sources, file, registry, options, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    const Place p = sources.place(d.span.begin);
    const std::uint32_t line = header && p.line > 0 ? p.line - 1 : p.line;
    const std::string s =
        fmt::format("{} at {}:{}: {}", code_text(d.code), line, p.column, d.message);
    (d.severity == Severity::error ? r.errors : r.warnings).push_back(s);
    if (d.severity != Severity::error) continue;
    r.help.insert(r.help.end(), d.help.begin(), d.help.end());
    for (const Label& label : d.labels) {
      const std::uint32_t at = sources.place(label.span.begin).line;
      r.labels.push_back(fmt::format("{}: {}", header ? at - 1 : at, label.text));
    }
  }
  return r;
}

std::string seen(const std::string& text, bool shortcuts) {
  SourceMap sources;
  Diagnostics diagnostics(sources);
  const FileId file = sources.add("test.pov", text);
  std::string all;
  Options options;
  options.shortcuts = shortcuts;
  options.on_debug = [&](std::string_view s) { all += s; };
  const scene::Registry registry = {primitives, patterns, warps};
  const auto made = interpret(sources, file, registry, options, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    const auto place = [&](Span span) {
      const Place p = sources.place(span.begin);
      return fmt::format("{}:{}", p.line, p.column);
    };
    all += fmt::format("\n{} at {}: {}", code_text(d.code), place(d.span), d.message);
    for (const durer::Frame& f : d.trace) all += fmt::format("\n  {} at {}", f.text, place(f.span));
  }
  if (made) all += "\n" + scene::dump_text(*made, registry, &sources, scene::DumpStyle::text);
  return all;
}

std::string text_of(const std::string& expression, const std::string& before) {
  const Run r = run(before + "\n#debug " + expression + "\n");
  return r.errors.empty() ? r.debug : r.errors.front();
}

std::string value_of(const std::string& expression, const std::string& before, int decimals) {
  return text_of(fmt::format("str({}, 0, {})", expression, decimals), before);
}

std::string vector_of(const std::string& expression, int n, const std::string& before,
                      int decimals) {
  // Through a variable, as a place that takes any length.
  return text_of(fmt::format("vstr({}, V_, \" \", 0, {})", n, decimals),
                 before + "\n#declare V_ = " + expression + ";");
}

std::string error_of(const std::string& text) {
  const Run r = run(text);
  return r.errors.empty() ? "no error" : r.errors.front();
}

}  // namespace durer::interpreter::test
