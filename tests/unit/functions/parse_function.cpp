#include "tests/unit/functions/parse_function.h"

#include <cctype>
#include <stdexcept>

#include "functions/internals.h"
#include "functions/names.h"

namespace durer::functions {
namespace {

class Reader {
 public:
  Reader(const std::string& text, const std::vector<std::string>& parameters,
         const TestScope& scope)
      : text_(text), builder_(static_cast<int>(parameters.size())), scope_(scope) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      variables_[parameters[i]] = builder_.parameter(static_cast<int>(i));
    }
  }
  Function read() {
    const Value v = disjunction();
    if (peek() != '\0') fail("end");
    return builder_.finish(v);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("expected " + what + " at " + text_.substr(at_) + " in " + text_);
  }
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(const std::string& token) {
    peek();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  void expect(const std::string& token) {
    if (!accept(token)) fail(token);
  }
  std::string word() {
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(text_[at_]) != 0 || text_[at_] == '_')) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  Value disjunction() {
    Value v = conjunction();
    while (accept("|")) v = builder_.op(Op::either, v, conjunction());
    return v;
  }
  Value conjunction() {
    Value v = comparison();
    while (accept("&")) v = builder_.op(Op::both, v, comparison());
    return v;
  }
  Value comparison() {
    Value v = sum();
    for (;;) {
      if (accept("<="))
        v = builder_.op(Op::less_equal, v, sum());
      else if (accept(">="))
        v = builder_.op(Op::greater_equal, v, sum());
      else if (accept("!="))
        v = builder_.op(Op::not_equal, v, sum());
      else if (accept("<"))
        v = builder_.op(Op::less, v, sum());
      else if (accept(">"))
        v = builder_.op(Op::greater, v, sum());
      else if (accept("="))
        v = builder_.op(Op::equal, v, sum());
      else
        return v;
    }
  }
  Value sum() {
    Value v = product();
    for (;;) {
      if (accept("+"))
        v = builder_.op(Op::add, v, product());
      else if (accept("-"))
        v = builder_.op(Op::subtract, v, product());
      else
        return v;
    }
  }
  Value product() {
    Value v = unary();
    for (;;) {
      if (accept("*"))
        v = builder_.op(Op::multiply, v, unary());
      else if (accept("/"))
        v = builder_.op(Op::divide, v, unary());
      else
        return v;
    }
  }
  Value unary() {
    if (accept("-")) return builder_.op(Op::negate, primary());
    accept("+");
    return primary();
  }
  Value primary() {
    if (accept("(")) {
      const Value v = FunctionBuilder::group(disjunction());
      expect(")");
      return v;
    }
    if (std::isdigit(peek()) != 0 || peek() == '.') {
      std::size_t length = 0;
      const double number = std::stod(text_.substr(at_), &length);
      at_ += length;
      return builder_.constant(number);
    }
    const std::string name = word();
    if (name.empty()) fail("a value");
    if (accept("(")) return call(name);
    if (name == "pi") return builder_.constant(std::numbers::pi);
    if (variables_.count(name) != 0) return variables_[name];
    if (scope_.numbers.count(name) != 0) return builder_.constant(scope_.numbers.at(name));
    fail("a known name, not " + name);
  }
  std::vector<Value> arguments() {
    std::vector<Value> values{disjunction()};
    builder_.enter_later_argument();
    while (accept(",")) values.push_back(disjunction());
    builder_.leave_later_argument();
    expect(")");
    return values;
  }
  Value call(const std::string& name) {
    if (name == "select") return select();
    if (name == "sum" || name == "prod") return loop(name == "prod");
    const std::vector<Value> a = arguments();
    if (name == "degrees") return builder_.degrees(a.at(0));
    if (name == "radians") return builder_.radians(a.at(0));
    if (const BuiltIn* f = built_in(name)) {
      if (f->arity == 1) return builder_.op(f->op, a.at(0));
      Value v = a.at(0);
      for (std::size_t i = 1; i < a.size(); ++i) v = builder_.op(f->op, v, a[i]);
      return v;
    }
    if (scope_.functions.count(name) != 0) {
      const std::vector<Value> r = builder_.call(scope_.functions.at(name), a);
      return accept(".") ? builder_.member(r, member_named(word()).value()) : r.at(0);
    }
    for (std::size_t i = 0; i < internal_functions.size(); ++i) {
      if (internal_functions[i].name == name) return builder_.internal(static_cast<int>(i), a);
    }
    fail("a known function, not " + name);
  }
  Value select() {
    const Value condition = disjunction();
    expect(",");
    builder_.select_begin(condition);
    do builder_.select_next(disjunction());
    while (accept(","));
    expect(")");
    return builder_.select_end();
  }
  Value loop(bool is_product) {
    const std::string name = word();
    expect(",");
    const Value from = disjunction();
    expect(",");
    const Value to = disjunction();
    expect(",");
    const auto outer = variables_;
    variables_[name] = builder_.loop_begin(is_product, from, to);
    const Value body = disjunction();
    variables_ = outer;
    expect(")");
    return builder_.loop_end(body);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  FunctionBuilder builder_;
  const TestScope& scope_;
  std::map<std::string, Value> variables_;
};

}  // namespace

Function parse_function(const std::string& body, const std::vector<std::string>& parameters,
                        const TestScope& scope) {
  return Reader(body, parameters, scope).read();
}
FunctionRef parse_function_ref(const std::string& body, const std::vector<std::string>& parameters,
                               const TestScope& scope) {
  return std::make_shared<const Function>(parse_function(body, parameters, scope));
}

}  // namespace durer::functions
