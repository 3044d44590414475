// Reads the body of one function; private to function_body.cpp and function_calls.cpp.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "functions/builder.h"
#include "functions/names.h"
#include "interpreter/interpreter.h"
#include "interpreter/user_function.h"

namespace durer::interpreter {

class Interpreter::FunctionReader {
 public:
  FunctionReader(Interpreter& in, std::span<const SymbolId> parameters);
  /// Reads up to and including the closing brace.
  [[nodiscard]] functions::Function read();

 private:
  /// One component, or those of a call that needs a member behind it.
  struct Operand {
    std::vector<functions::Value> components;
    Span span;
  };
  /// Parameters, then counters of the loops around.
  struct Known {
    SymbolId name;
    functions::Value value;
  };
  class Arguments;

  /// x and u are one register, y and v another (language §6.2).
  [[nodiscard]] static constexpr SymbolId register_of(SymbolId name) {
    return name == grammar::words::u   ? grammar::words::x
           : name == grammar::words::v ? grammar::words::y
                                       : name;
  }
  [[nodiscard]] static constexpr bool is_register(SymbolId name) {
    const SymbolId r = register_of(name);
    return r == grammar::words::x || r == grammar::words::y || r == grammar::words::z;
  }

  Operand full();
  [[nodiscard]] bool ends_here() const;
  Operand chain(int level);
  char mark_ahead();
  Operand signed_operand();
  void spell_out();
  Operand operand();
  [[nodiscard]] SymbolId symbol_of(const Token& t) const;

  functions::Value compile_number(const ast::Tree& tree, ast::ExprId id);
  std::vector<functions::Value> compile(const ast::Tree& tree, ast::ExprId id);
  std::vector<functions::Value> open_group(const ast::Tree& tree, ast::ExprId id,
                                           const ast::OpenGroup& g);

  [[nodiscard]] const functions::Value* find(SymbolId name) const;
  functions::Value named(const ast::Expr& e, SymbolId name);
  functions::Value captured(const Value& v, Span span, std::string_view name);
  functions::Value element(const ast::Tree& tree, ast::ExprId id);
  [[noreturn]] void unknown(Span span, SymbolId name);

  functions::Value number(const Operand& o);
  functions::Value member(const Operand& o, SymbolId name, Span span);
  void check(Span span);
  [[noreturn]] void no_such_operator(Span span, char mark);
  [[noreturn]] void not_an_operator(const Token& t);
  [[noreturn]] void not_an_operand(const Token& t);

  // function_calls.cpp
  std::vector<functions::Value> call(const ast::Tree& tree, const ast::Expr& e);
  functions::Value call_word(SymbolId word, Span span, Arguments& arguments);
  functions::Value plain_call(const functions::BuiltIn& f, Span span, Arguments& arguments);
  functions::Value select(Span span, Arguments& arguments);
  functions::Value loop(bool product, Span span, Arguments& arguments);
  std::vector<functions::Value> call_function(const UserFunction& f, std::string_view name,
                                              Span span, Arguments& arguments);
  std::vector<functions::Value> all(Arguments& arguments);
  [[noreturn]] void wrong_count(std::string_view name, std::string_view takes, std::size_t given,
                                Span span, Span declared = {});

  Interpreter& in_;
  functions::FunctionBuilder builder_;
  std::vector<Known> names_;
};

}  // namespace durer::interpreter
