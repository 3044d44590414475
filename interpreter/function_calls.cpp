// Calls inside the bodies of functions: built-ins, select, sum, prod, other functions.
#include <fmt/format.h>

#include "interpreter/function_body.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// The arguments of one call, whether they are plain expressions or have to be read item by item.
class Interpreter::FunctionReader::Arguments {
 public:
  Arguments(FunctionReader& reader, const ast::Tree& tree, const ast::Expr& call)
      : reader_(reader), tree_(tree), span_(call.span) {
    if (const auto* c = std::get_if<ast::Call>(&call.node)) {
      list_ = {tree.expr_lists.data() + c->args.first, c->args.count};
    } else {
      part_.emplace(reader.in_, tree, std::get<ast::OpenGroup>(call.node).items, call.span);
    }
  }

  [[nodiscard]] bool more() {
    return part_ ? reader_.in_.peek().kind != Token::Kind::end : used_ < list_.size();
  }
  functions::Value value() {
    require("an argument");
    if (!part_) return reader_.compile_number(tree_, list_[used_++]);
    const functions::Value v = reader_.number(reader_.full());
    comma();
    return v;
  }
  /// The argument as a name of its own.
  SymbolId name() {
    require("a name for the counter");
    const ast::Name* name = nullptr;
    Span span;
    if (part_) {
      const Token t = reader_.in_.next();
      name = t.node<ast::Name>();
      span = t.span;
      if (name != nullptr) comma();
    } else {
      const ast::Expr& e = tree_.exprs[list_[used_++]];
      name = std::get_if<ast::Name>(&e.node);
      span = e.span;
    }
    if (name == nullptr) {
      reader_.in_.fail(Code::wrong_kind, span, "expected a name for the counter",
                       "write `sum(I, 1, 10, …)`");
    }
    return name->name;
  }

 private:
  void require(std::string_view what) {
    if (!more())
      reader_.in_.fail(Code::missing_argument, span_, fmt::format("expected {} here", what));
  }
  void comma() {
    if (!more() || reader_.in_.argument_comma()) return;
    reader_.not_an_operator(reader_.in_.next());
  }

  FunctionReader& reader_;
  const ast::Tree& tree_;
  Span span_;
  std::span<const ast::ExprId> list_;
  std::size_t used_ = 0;
  std::optional<Nested> part_;
};

std::vector<functions::Value> Interpreter::FunctionReader::call(const ast::Tree& tree,
                                                                const ast::Expr& e) {
  const auto* c = std::get_if<ast::Call>(&e.node);
  const ast::ExprId callee = c != nullptr ? c->callee : std::get<ast::OpenGroup>(e.node).callee;
  const auto* word = std::get_if<ast::Name>(&tree.exprs[callee].node);
  if (word != nullptr && in_.symbols_.reserved(word->name)) {
    Arguments arguments(*this, tree, e);
    return {call_word(word->name, e.span, arguments)};
  }
  const Span at = tree.exprs[callee].span;
  const auto array = array_of(tree.exprs[callee]);
  if (word == nullptr && !array) {
    in_.fail(Code::wrong_kind, at, "only functions with a name can be called inside of functions",
             "declare one for it: `#declare F = D.key`");
  }
  const SymbolId name = word != nullptr ? word->name : *array;
  const Value* v = in_.lookup(tree, callee, false);
  if (v == nullptr || !v->defined()) unknown(at, name);
  const auto* f = v->get<Shared<UserFunction>>();
  if (f == nullptr) {
    if (const auto* u = v->get<Shared<Unsupported>>()) in_.not_supported((*u)->feature, at);
    const bool spline = v->get<Shared<functions::Spline>>() != nullptr;
    in_.fail(
        Code::wrong_kind, at,
        fmt::format("expected a function to call, `{}` is {}", in_.name_of(name), kind_name(*v)),
        spline ? fmt::format("make a function of it: `#declare F = function {{ spline {{ {} "
                             "}} }}`",
                             in_.name_of(name))
               : "");
  }
  const Shared<UserFunction> keep = *f;  // a directive in the arguments might undefine it
  Arguments arguments(*this, tree, e);
  return call_function(*keep, in_.name_of(name), e.span, arguments);
}

std::vector<functions::Value> Interpreter::FunctionReader::all(Arguments& arguments) {
  std::vector<functions::Value> values;
  if (arguments.more()) values.push_back(arguments.value());
  builder_.enter_later_argument();
  while (arguments.more()) values.push_back(arguments.value());
  builder_.leave_later_argument();
  return values;
}

std::vector<functions::Value> Interpreter::FunctionReader::call_function(const UserFunction& f,
                                                                         std::string_view name,
                                                                         Span span,
                                                                         Arguments& arguments) {
  const std::vector<functions::Value> values = all(arguments);
  if (values.size() != f.tape->parameters) {
    wrong_count(name, argument_count(f.tape->parameters), values.size(), span, f.declared);
  }
  std::vector<functions::Value> result = builder_.call(f.tape, values);
  check(span);
  return result;
}

functions::Value Interpreter::FunctionReader::call_word(SymbolId word, Span span,
                                                        Arguments& arguments) {
  switch (word) {
    case w::select: return select(span, arguments);
    case w::sum: return loop(false, span, arguments);
    case w::prod: return loop(true, span, arguments);
    case w::degrees:
    case w::radians: {
      const auto values = all(arguments);
      if (values.size() != 1) wrong_count(in_.name_of(word), "1 argument", values.size(), span);
      return word == w::degrees ? builder_.degrees(values[0]) : builder_.radians(values[0]);
    }
    default: break;
  }
  const functions::BuiltIn* f = functions::built_in(in_.name_of(word));
  if (f == nullptr) {
    in_.fail(Code::unexpected_item, span,
             fmt::format("`{}` cannot be used in a function", in_.name_of(word)),
             "functions know abs acos acosh asin asinh atan atan2 atanh ceil cos cosh degrees div "
             "exp floor int ln log max min mod pow prod radians select sin sinh sqrt sum tan tanh");
  }
  return plain_call(*f, span, arguments);
}

functions::Value Interpreter::FunctionReader::plain_call(const functions::BuiltIn& f, Span span,
                                                         Arguments& arguments) {
  const auto values = all(arguments);
  const auto arity = static_cast<std::size_t>(f.arity);
  if (f.chain ? values.size() < arity : values.size() != arity) {
    wrong_count(f.name, f.chain ? "2 or more arguments" : argument_count(arity), values.size(),
                span);
  }
  functions::Value v = values[0];
  if (arity == 1) v = builder_.op(f.op, v);
  for (std::size_t i = 1; i < values.size(); ++i) v = builder_.op(f.op, v, values[i]);
  check(span);
  return v;
}

functions::Value Interpreter::FunctionReader::select(Span span, Arguments& arguments) {
  builder_.select_begin(arguments.value());
  std::size_t sides = 0;
  for (; arguments.more(); ++sides) builder_.select_next(arguments.value());
  if (sides != 2 && sides != 3) wrong_count("select", "3 or 4 arguments", sides + 1, span);
  const functions::Value v = builder_.select_end();
  check(span);
  return v;
}

/// sum(I, from, to, term) and prod().
functions::Value Interpreter::FunctionReader::loop(bool product, Span span, Arguments& arguments) {
  const SymbolId counter = arguments.name();
  if (in_.symbols_.reserved(counter) && !is_register(counter)) {
    in_.fail(Code::unexpected_item, span,
             fmt::format("`{}` is a word of the language and cannot count", in_.name_of(counter)));
  }
  const functions::Value from = arguments.value();
  const functions::Value to = arguments.value();
  const functions::Value turn = builder_.loop_begin(product, from, to);
  if (is_register(counter)) {
    in_.warn(Code::evaluation, span,
             fmt::format("`{}` is a parameter here, not the counter", in_.name_of(counter)),
             "choose another name for the counter");
  } else {
    names_.push_back({counter, turn});
  }
  const functions::Value body = arguments.value();
  if (!is_register(counter)) names_.pop_back();
  if (arguments.more()) {
    wrong_count(product ? "prod" : "sum", "4 arguments: counter, first, last, term", 5, span);
  }
  const functions::Value v = builder_.loop_end(body);
  check(span);
  return v;
}

void Interpreter::FunctionReader::wrong_count(std::string_view name, std::string_view takes,
                                              std::size_t given, Span span, Span declared) {
  Diagnostic d;
  d.code = Code::missing_argument;
  d.span = span;
  d.message =
      fmt::format("`{}` takes {}, here {} {}", name, takes, given == 1 ? "is" : "are", given);
  if (declared.begin != 0) d.labels.push_back({declared, "the function is declared here"});
  in_.fail(std::move(d));
}

}  // namespace durer::interpreter
