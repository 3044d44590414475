// After an error: what is told, where reading goes on, and which names are not to be complained
// about any more because what should have declared them was lost (docs/architecture.md, "Errors").
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

bool word_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool word_char(char c) { return word_start(c) || (c >= '0' && c <= '9'); }

/// True if nothing sensible can follow: the scene asked to stop, or would run into it again.
bool is_final(Code code) {
  return code == Code::limit || code == Code::user_error || code == Code::version;
}

}  // namespace

// ---- telling errors apart from their consequences ------------------------------------------------

/// What the grammar had to say about the text at `loc`, if it could not read it (ast::Flaw).
const ast::Flaw* Interpreter::flaw_at(Loc loc) const {
  if (loc == 0) return nullptr;
  const FileId file = sources_.file_of(loc);
  if (file >= tree_of_.size() || tree_of_[file] == nullptr) return nullptr;
  const auto& flaws = tree_of_[file]->flaws;
  const auto it = std::ranges::lower_bound(flaws, loc, {}, &ast::Flaw::place);
  return it != flaws.end() && it->place == loc ? &*it : nullptr;
}

namespace {
bool holds_poison(const Value& v) {
  if (v.get<Poison>() != nullptr) return true;
  const auto* array = v.get<std::shared_ptr<Array>>();
  if (array == nullptr) return false;
  return std::ranges::any_of((*array)->elements, [](const Value& e) { return holds_poison(e); });
}
}  // namespace

/// True if the text of `d` names something that an earlier error left without a meaning.
bool Interpreter::follows_from_earlier(const Diagnostic& d) const {
  constexpr std::size_t enough = 4096;
  const std::string_view text = sources_.text(d.span).substr(0, enough);
  for (std::size_t i = 0; i < text.size();) {
    if (!word_char(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && word_char(text[end])) ++end;
    const SymbolId name = word_start(text[i]) ? symbols_.find(text.substr(i, end - i))
                                              : grammar::SymbolTable::none;
    i = end;
    if (name == grammar::SymbolTable::none || symbols_.reserved(name)) continue;
    Slot* slot = env_.find(name);
    if (slot == nullptr && names_are_missing_) return true;
    const Value* v = Environment::value_of(slot);
    if (v != nullptr && holds_poison(*v)) return true;
  }
  return false;
}

/// A name of the wrong kind: where it got that kind.
void Interpreter::label_declaration(Diagnostic& d) const {
  if (d.code != Code::wrong_kind || !d.labels.empty()) return;
  const SymbolId name = symbols_.find(sources_.text(d.span));
  if (name == grammar::SymbolTable::none || symbols_.reserved(name)) return;
  Slot* slot = env_.find(name);
  const Value* v = Environment::value_of(slot);
  if (v == nullptr) return;
  if (const MacroRef* macro = v->get<MacroRef>()) {
    d.labels.push_back({macro->macro->head, "the macro is defined here"});
  } else if (slot->declared.begin != 0) {
    d.labels.push_back({slot->declared, fmt::format("`{}` is declared here", name_of(name))});
  }
}

/// Reports, unless it is the same again or a consequence of something reported.
void Interpreter::report(Diagnostic d) {
  // Text that the grammar could not read is reported as such, now that it is executed.
  if (const ast::Flaw* flaw = flaw_at(d.span.begin)) d = flaw->why;
  // A macro or loop that fails does so each time, but one report is enough.
  const bool again = d.span.begin != 0 && !reported_.insert(d.span.begin).second;
  const bool new_trouble = is_final(d.code) || (!again && !(failed_ && follows_from_earlier(d)));
  failed_ = true;
  if (!new_trouble) return;
  label_declaration(d);
  add_trace(d);
  diagnostics_.report(std::move(d));
}

void Interpreter::fail(Diagnostic d) {
  const bool final = is_final(d.code);
  report(std::move(d));
  stop_here(final);
}

/// Unwinds to where reading can go on.
void Interpreter::stop_here(bool final) {
  poison_what_is_skipped();
  throw Failure{final};
}

// ---- names whose declarations are lost -----------------------------------------------------------

void Interpreter::poison(SymbolId name, std::uint32_t scope, bool overwrite) {
  if (symbols_.reserved(name)) return;
  Slot* slot = env_.find(name);
  if (slot != nullptr && !overwrite) return;
  if (slot == nullptr) slot = &env_.in_scope(name, scope);
  if (Value* v = Environment::value_of(slot)) *v = Value(Poison{});
}

/// Names that the items would have declared had they been executed. `locals`: so #local counts, in
/// `scope`.
void Interpreter::poison_declared(const ast::Tree& tree, ast::Range items, bool locals,
                                  std::uint32_t scope) {
  for (std::uint32_t i = 0; i < items.count; ++i) {
    const ast::Item& item = tree.items[items.first + i];
    if (item.kind == ast::ItemKind::directive) {
      poison_declared(tree, tree.directives[item.ref], locals, scope);
    } else if (item.kind == ast::ItemKind::braces || item.kind == ast::ItemKind::brackets) {
      poison_declared(tree, tree.groups[item.ref].items, locals, scope);
    }
  }
}

void Interpreter::poison_declared(const ast::Tree& tree, const ast::Directive& directive,
                                  bool locals, std::uint32_t scope) {
  const auto& node = directive.node;
  if (const auto* d = std::get_if<ast::Declare>(&node)) {
    if (!d->local || locals) poison(d->name, d->local ? scope : 0, false);
  } else if (const auto* m = std::get_if<ast::Macro>(&node)) {
    poison(m->name, 0, false);
  } else if (const auto* l = std::get_if<ast::While>(&node)) {
    poison_declared(tree, l->items, locals, scope);
  } else if (const auto* f = std::get_if<ast::For>(&node)) {
    poison_declared(tree, f->items, locals, scope);
  } else if (const auto* c = std::get_if<ast::If>(&node)) {
    for (std::uint32_t i = 0; i < c->branches.count; ++i) {
      poison_declared(tree, tree.branches[c->branches.first + i].items, locals, scope);
    }
  } else if (const auto* s = std::get_if<ast::Switch>(&node)) {
    for (std::uint32_t i = 0; i < s->cases.count; ++i) {
      poison_declared(tree, tree.cases[s->cases.first + i].items, locals, scope);
    }
  }
}

/// The frame to go on in: the innermost file that no reader is in the middle of, or an `#if` branch
/// directly in it.
std::size_t Interpreter::resume_frame() const {
  const std::size_t limit = std::min(reading_depth_, frames_.size());
  std::size_t at = limit;
  while (at > 0 && frames_[at - 1].kind != Frame::Kind::file) --at;
  if (at == 0) return 0;  // the scene itself
  while (at < limit && frames_[at].kind == Frame::Kind::branch) ++at;
  return at - 1;
}

/// Before unwinding: everything between the place of the error and where reading goes on is lost.
void Interpreter::poison_what_is_skipped() {
  if (frames_.empty()) return;
  const std::size_t resume = resume_frame();
  std::uint32_t scope = 0;  // of the file that goes on
  bool locals = true;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Frame& f = frames_[i];
    const bool own_scope = (f.kind == Frame::Kind::file && i > 0) || f.kind == Frame::Kind::macro;
    if (i <= resume) {
      scope += own_scope ? 1 : 0;
      if (i < resume || f.pos == 0 || f.kind == Frame::Kind::expansion) continue;
      // The item that is being executed.
      poison_declared(*f.tree, ast::Range{f.pos - 1, 1}, true, scope);
      continue;
    }
    locals = locals && !own_scope;
    if (f.kind == Frame::Kind::expansion || f.kind == Frame::Kind::barrier || f.pos > f.end) {
      continue;
    }
    poison_declared(*f.tree, ast::Range{f.pos, f.end - f.pos}, locals, scope);
  }
}

// ---- going on ------------------------------------------------------------------------------------

/// After a Failure: true if the top level can go on with the next item.
bool Interpreter::recover(const Failure& failure) {
  if (failure.final || diagnostics_.error_count() >= Diagnostics::max_errors) return false;
  const std::size_t keep = resume_frame() + 1;
  // Within a block the rest of the statement is gone with it; else it is still to be skipped.
  const bool in_block = frames_.size() > keep && frames_[keep].kind == Frame::Kind::group;
  while (frames_.size() > keep) pop();
  unread_.clear();
  unread_base_ = 0;
  declare_depth_ = 0;
  nesting_ = 0;
  arguments_.clear();
  own_texture_ = scene::none;
  reading_depth_ = no_reader;
  if (!in_block) skip_to_statement();
  return true;
}

/// Skips the rest of a statement whose end is not known: to a directive, or to an item that begins
/// its line.
void Interpreter::skip_to_statement() {
  Frame& f = frames_.back();
  for (; f.pos < f.end; ++f.pos) {
    const ast::Item& item = f.tree->items[f.pos];
    if (item.kind == ast::ItemKind::directive) return;
    if (item.kind != ast::ItemKind::word && item.kind != ast::ItemKind::expr) continue;
    const std::string_view line = sources_.line_at(item.span.begin);
    const std::uint32_t column = sources_.place(item.span.begin).column;
    if (line.find_first_not_of(" \t") + 1 == column) return;
  }
}

}  // namespace durer::interpreter
