// What the language has had since 3.8 (language §1.6, §5.1): dictionaries, several targets at once,
// new names. Optional parameters are with the macros, mixed and growing arrays with the arrays.
#include <utility>

#include <fmt/format.h>

#include "grammar/parse.h"
#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;
namespace a = grammar::additions;

/// Since 3.8 these words are reserved; before, scenes may declare them.
void Interpreter::check_new_name(SymbolId name, Span span) {
  if (version() < 380 || !grammar::SymbolTable::added(name)) return;
  fail(Code::unexpected_item, span,
       fmt::format("`{}` is a word of the language since version 3.8", name_of(name)),
       "choose another name; names that start with a capital letter are always free");
}

/// The names that 3.8 brings, written in the language itself.
void Interpreter::declare_additions() {
  if (additions_) return;
  additions_ = true;
  const FileId file = sources_.add("<version 3.8>",
                                   "#declare tau = 2*pi;\n"
                                   "#declare atand = function(x) { degrees(atan(x)) }\n");
  auto tree = grammar::parse(sources_, file, symbols_, diagnostics_);
  if (!tree) stop_here(true);
  remember(*tree);
  main_trees_.push_back(std::move(tree));
  const ast::Tree& text = *main_trees_.back();
  // They are reserved from now on, so they must be declared before.
  const int version = std::exchange(declared_version_, 370);
  Nested part(*this, text, text.top);
  part.finish("the end of these names");
  declared_version_ = version;
}

// ---- dictionaries ------------------------------------------------------------------------------

bool Interpreter::starts_dictionary(const Token& t) const {
  if (!additions_) return false;
  const auto* name = t.node<ast::Name>();
  return name != nullptr && name->name == a::dictionary && env_.find(a::dictionary) == nullptr;
}

/// `dictionary { ["key"]: value, .key: value }`, or the word alone for an empty one.
Value Interpreter::read_dictionary() {
  next();
  auto dictionary = std::make_shared<Dictionary>();
  if (raw_next().kind != Token::Kind::open) return Value(std::move(dictionary));
  next();
  for (;;) {
    const Token t = next();
    if (t.kind == Token::Kind::close) return Value(std::move(dictionary));
    Text key;
    if (t.kind == Token::Kind::bracket_open) {
      key = read_text();
      const Token close = next();
      if (close.kind != Token::Kind::bracket_close) unexpected(close, "`]` after the key");
    } else if (t.is_punct('.')) {
      const Token word = next();
      const auto* name = word.node<ast::Name>();
      if (name == nullptr && word.kind != Token::Kind::word) unexpected(word, "a key after `.`");
      key = Text(name_of(name != nullptr ? name->name : word.word));
    } else {
      unexpected(t, "`[\"key\"]:`, `.key:` or `}` in this dictionary");
    }
    const Token colon = next();
    if (!colon.is_punct(':')) unexpected(colon, "`:` after the key");
    dictionary->entries[key] = read_value();
    optional_comma();
  }
}

// ---- several targets at once -------------------------------------------------------------------

/// Assigns to one target as `#declare` does.
void Interpreter::assign_target(const ast::Tree& tree, const ast::Tuple& tuple, ast::ExprId target,
                                Value value) {
  if (target == ast::none) return;
  ast::Declare node;
  node.local = tuple.local;
  node.target = tree.exprs[target].span;
  const auto& written = tree.exprs[target].node;
  if (const auto* name = std::get_if<ast::Name>(&written)) {
    node.name = name->name;
    check_new_name(node.name, node.target);
  } else if (const auto* index = std::get_if<ast::Index>(&written)) {
    node.name = index->name;
    node.subscripts = index->subscripts;
  } else {
    node.place = target;
  }
  const std::uint32_t scope = env_.scope();
  Slot* existing = node.local ? env_.find_in_scope(node.name, scope) : env_.find(node.name);
  assign(tree, node, std::move(value), scope, existing);
}

namespace {
/// The value as what the places of a tuple get one by one.
std::vector<Value> parts_of(const Value& value) {
  std::vector<Value> parts;
  if (const Num* n = value.get<Num>(); n != nullptr && n->length > 1) {
    for (int i = 0; i < n->length; ++i) parts.emplace_back(Num(n->v[static_cast<std::size_t>(i)]));
  } else if (const auto* array = value.get<std::shared_ptr<Array>>();
             array != nullptr && (*array)->sizes.size() == 1) {
    parts = (*array)->elements;
  }
  return parts;
}
}  // namespace

void Interpreter::run(const ast::Tree& tree, const ast::Directive& d, const ast::Tuple& node) {
  if (version() < 380) {
    fail(Code::version, d.span, "several targets at once need version 3.8",
         "write `#version 3.8;` above, or one `#declare` for each");
  }
  const auto target = [&](std::uint32_t i) { return tree.expr_lists[node.targets.first + i]; };
  if (node.kind == '(') {
    // One after the other: a later value sees what an earlier one has changed.
    const Token t = next();
    const auto* paren = t.node<ast::Paren>();
    const auto* group = t.node<ast::OpenGroup>();
    if (paren == nullptr && (group == nullptr || group->kind != ast::OpenGroup::Kind::paren)) {
      unexpected(t, "the values in parentheses");
    }
    const auto assign_all = [&](Nested part) {
      for (std::uint32_t i = 0; i < node.targets.count; ++i) {
        assign_target(tree, node, target(i), read_value());
        optional_comma();
      }
      part.finish("the end of these values");
    };
    if (paren != nullptr) assign_all(Nested(*this, *t.tree, paren->inner));
    if (group != nullptr) assign_all(Nested(*this, *t.tree, group->items));
  } else {
    const Span at = peek().span;
    const Value value = read_value();
    const std::vector<Value> parts = parts_of(value);
    const bool fits = (node.kind == '<') == value.is_num() && !parts.empty();
    if (!fits) {
      fail(Code::wrong_kind, at,
           fmt::format("expected {}, found {}",
                       node.kind == '<' ? "a vector" : "an array of one dimension",
                       kind_name(value)));
    }
    if (parts.size() != node.targets.count) {
      fail(Code::missing_argument, d.span,
           fmt::format("here are {} targets for {} values", node.targets.count, parts.size()));
    }
    for (std::uint32_t i = 0; i < node.targets.count; ++i) {
      if (target(i) == ast::none) continue;
      if (!parts[i].defined()) {
        fail(Code::evaluation, tree.exprs[target(i)].span, "the element for this has no value yet");
      }
      assign_target(tree, node, target(i), parts[i]);
    }
  }
  accept_raw_punct(';');
}

/// Puts `value` into an element or entry.
void Interpreter::assign_place(const ast::Tree& tree, const ast::Declare& node, Value value) {
  Place to;
  if (node.place != ast::none) {
    to = place(tree, node.place, Access::write);
  } else {
    Value* base = Environment::value_of(env_.find(node.name));
    if (base == nullptr) unknown_name(node.name, node.target);
    to = step_into({base, nullptr}, tree, node.subscripts, node.target, Access::write);
  }
  if (to.value == nullptr) {
    fail(Code::evaluation, node.target, "this parameter no longer has a value");
  }
  if (to.value->get<Shared<UserFunction>>() != nullptr) function_stays(node.name, node.target);
  store(*to.value, std::move(value), to.array != nullptr, to.array, node.target);
}

}  // namespace durer::interpreter
