// The run of a scene: predefined names, the top level, messages and origins.
#include "interpreter/interpret.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grammar/parse.h"
#include "interpreter/camera.h"
#include "interpreter/deep_stack.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

Interpreter::Interpreter(SourceMap& sources, const scene::Registry& registry,
                         const Options& options, Diagnostics& diagnostics)
    : sources_(sources), registry_(registry), options_(options), diagnostics_(diagnostics) {
  for (std::uint32_t i = 0; i < registry.primitives.size(); ++i) {
    primitive_words_[symbols_.intern(registry.primitives[i]->name)] = i;
  }
  for (std::uint32_t i = 0; i < registry.patterns.size(); ++i) {
    pattern_words_[symbols_.intern(registry.patterns[i]->name)] = i;
  }
  for (std::uint32_t i = 0; i < registry.warps.size(); ++i) {
    warp_words_[symbols_.intern(registry.warps[i]->name)] = i;
  }
  scene::Texture plain;
  plain.layers.emplace_back();
  default_texture_ = add_texture(std::move(plain));
  if (options.version > 0) {
    version_source_ = " (option)";
    declared_version_ = options.version;
    version_given_ = true;
  }
}

// ---- messages
// -----------------------------------------------------------------------------------------

void Interpreter::add_trace(Diagnostic& d) const {
  for (std::size_t i = frames_.size(); i-- > 0;) {
    const Frame& f = frames_[i];
    if (f.kind == Frame::Kind::macro) {
      d.trace.push_back({f.call, fmt::format("in macro `{}`, called here", name_of(f.name))});
    } else if (f.kind == Frame::Kind::file && f.call.begin != 0) {
      d.trace.push_back({f.call, "in a file included here"});
    }
    if (d.trace.size() == 8) return;  // enough to find the way; recursion would fill pages
  }
}

void Interpreter::fail(Code code, Span span, std::string message, std::string help,
                       std::string at) {
  Diagnostic d;
  d.code = code;
  d.span = span;
  d.message = std::move(message);
  d.at = std::move(at);
  if (!help.empty()) d.help.push_back(std::move(help));
  fail(std::move(d));
}

/// Each place warns once per kind, however often a loop comes by.
void Interpreter::warn(Code code, Span span, std::string message, std::string help) {
  const std::uint64_t key = std::uint64_t{span.begin} << 8 | static_cast<std::uint64_t>(code);
  if (!warned_.insert(key).second) return;
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = code;
  d.span = span;
  d.message = std::move(message);
  if (!help.empty()) d.help.push_back(std::move(help));
  add_trace(d);
  diagnostics_.report(std::move(d));
}

void Interpreter::not_supported(std::string_view feature, Span span) {
  fail(Code::not_supported, span, fmt::format("{} is not supported yet", feature));
}

/// Origin of the innermost macro call or include, made when first needed.
scene::OriginId Interpreter::call_origin() {
  const auto is_call = [](const Frame& f) {
    return f.kind == Frame::Kind::macro || (f.kind == Frame::Kind::file && f.call.begin != 0);
  };
  std::size_t known = frames_.size();  // calls below have origins
  while (known > 0 && !(is_call(frames_[known - 1]) && frames_[known - 1].has_origin)) --known;
  scene::OriginId parent = known > 0 ? frames_[known - 1].origin : 0;
  for (std::size_t i = known; i < frames_.size(); ++i) {
    Frame& f = frames_[i];
    if (!is_call(f)) continue;
    scene_.origins.push_back({f.call, parent});
    f.origin = static_cast<scene::OriginId>(scene_.origins.size() - 1);
    f.has_origin = true;
    parent = f.origin;
  }
  return parent;
}

scene::OriginId Interpreter::origin(Span span) {
  const scene::OriginId parent = call_origin();
  scene_.origins.push_back({span, parent});
  return static_cast<scene::OriginId>(scene_.origins.size() - 1);
}

void Interpreter::remember(const ast::Tree& tree) {
  if (tree.file >= tree_of_.size()) tree_of_.resize(tree.file + 1);
  tree_of_[tree.file] = &tree;
  formulas_of_.resize(tree_of_.size());
  statements_of_.resize(tree_of_.size());
}

// ---- the scene
// ------------------------------------------------------------------------------------------

void Interpreter::add_root(scene::ObjectId id) { scene_.roots.push_back({id, default_texture_}); }

void Interpreter::top_level() {
  for (;;) {
    reading_depth_ = no_reader;
    run_ahead(nullptr);
    const Token t = next();
    if (t.kind == Token::Kind::end) return;
    if (t.is_punct(';')) continue;
    reading_depth_ = frames_.size();
    // What an unread statement had opened is closed here.
    if (failed_ && (t.kind == Token::Kind::close || t.is_punct(')'))) continue;
    if (starts_object(t)) {
      add_root(read_object(t));
      continue;
    }
    if (const auto* name = t.node<ast::Name>(); name != nullptr && name->name == w::version) {
      obsolete_directive(t, "version");
      continue;
    }
    if (t.kind == Token::Kind::expr) {
      const Value* v = lookup(*t.tree, t.expr, true);
      if (v != nullptr && v->get<ObjectRef>() != nullptr) {
        add_root(v->get<ObjectRef>()->id);
        continue;
      }
      unexpected(t, "an object or directive");
    }
    if (t.kind != Token::Kind::word) unexpected(t, "an object or directive");
    switch (t.word) {
      case w::camera:
        if (camera_)
          warn(Code::scene, t.span, "the scene has several cameras; the last one is used");
        camera_ = read_camera(t.span);
        break;
      case w::global_settings: read_global_settings(t.span); break;
      case w::background: read_background(); break;
      case w::default_:  // the way before 3.0, without `#`
        warn(Code::deprecated, t.span, "`default` without `#`", "write `#default`");
        default_block();
        break;
      case w::declare: obsolete_directive(t, "declare"); break;
      case w::include: obsolete_directive(t, "include"); break;
      case w::max_trace_level: read_max_trace_level(t); break;
      case w::max_intersections: read_float(); break;
      case w::sky_sphere:
        if (scene_.sky_sphere)
          warn(Code::scene, t.span, "the scene has several sky spheres; the last one is used");
        scene_.sky_sphere = read_sky_sphere(t.span);
        break;
      case w::fog: scene_.fogs.push_back(read_fog(t.span)); break;
      case w::rainbow: scene_.rainbows.push_back(read_rainbow(t.span)); break;
      case w::media: scene_.atmosphere.push_back(read_media(t.span)); break;
      default: unexpected(t, "an object or directive");
    }
  }
}

std::optional<scene::Scene> Interpreter::run(FileId main_file) {
  main_file_ = main_file;
  auto tree = grammar::parse(sources_, main_file, symbols_, diagnostics_);
  if (!tree) return std::nullopt;
  if (tree->utf8) charset_ = Charset::utf8;
  remember(*tree);

  predefine();
  Frame f;
  f.kind = Frame::Kind::file;
  f.tree = tree.get();
  f.first = tree->top.first;
  f.pos = tree->top.first;
  f.end = tree->top.first + tree->top.count;
  main_trees_.push_back(std::move(tree));
  frames_.push_back(f);
  const std::string_view path = sources_.path(main_file);
  if (options_.version == 0 && path.ends_with(".scene")) {
    native_ = true;
    set_version(3.8, {});
    version_source_ = " (.scene)";
  } else if (options_.version >= 380) {
    declare_additions();
  }
  bool header_waits = !options_.header_file.empty();
  for (;;) {
    try {
      if (std::exchange(header_waits, false)) include(options_.header_file, {});
      top_level();
      if (failed_) return std::nullopt;
      finish();
      return std::move(scene_);
    } catch (const Failure& failure) {
      if (!recover(failure)) return std::nullopt;
    }
  }
}

/// What only the end of the scene decides.
void Interpreter::finish() {
  scene_.camera = finish_camera(camera_           ? *camera_
                                : default_camera_ ? *default_camera_
                                                  : CameraSpec{});
  finish_settings();
  if (options_.on_assumptions) options_.on_assumptions(assumptions());
  if (scene_.roots.empty()) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = Code::scene;
    d.message = "the scene has no objects";
    diagnostics_.report(std::move(d));
  }
}

std::optional<scene::Scene> interpret(SourceMap& sources, FileId main_file,
                                      const scene::Registry& registry, const Options& options,
                                      Diagnostics& diagnostics) {
  std::optional<scene::Scene> scene;
  on_deep_stack([&] {
    Interpreter interpreter(sources, registry, options, diagnostics);
    scene = interpreter.run(main_file);
  });
  return scene;
}

}  // namespace durer::interpreter
