// Operands that the table of a type describes, and long lists of numbers.
#include <fmt/format.h>

#include "interpreter/interpreter.h"

namespace durer::interpreter {
namespace {

/// "the centre" for "centre" and for "the centre".
std::string with_article(std::string_view doc) {
  return doc.starts_with("the ") ? std::string(doc) : fmt::format("the {}", doc);
}

}  // namespace

/// One operand, behind its word if it has one.
void Interpreter::read_operand(const scene::Param& p, double* out) {
  last_span_ = peek().span;
  switch (p.kind) {
    case scene::ArgKind::number: *out = read_scalar(p.doc); break;
    case scene::ArgKind::flag: *out = 1; break;
    case scene::ArgKind::pair:
      out[0] = read_scalar(p.doc);
      optional_comma();
      if (starts_number(peek())) out[1] = read_scalar(p.doc);
      break;
    case scene::ArgKind::vector2:
    case scene::ArgKind::vector: {
      const int n = p.kind == scene::ArgKind::vector ? 3 : 2;
      const Num v = fit(read_num(n), n);
      for (int k = 0; k < n; ++k) out[k] = v.v[static_cast<std::size_t>(k)];
      break;
    }
  }
}

const Interpreter::OperandPlan& Interpreter::operand_plan(const scene::TypeInfo& info) {
  const auto [known, is_new] = operand_plans_.try_emplace(&info);
  OperandPlan& plan = known->second;
  if (!is_new) return plan;
  for (std::size_t i = 0; i < info.params.size(); ++i) {
    const scene::Param& p = info.params[i];
    plan.offsets.push_back(static_cast<std::uint16_t>(plan.fallback.size()));
    plan.fallback.insert(plan.fallback.end(), p.fallback.begin(),
                         p.fallback.begin() + scene::width(p.kind));
    if (p.positional) plan.positional = i + 1;
    plan.has_words |= !p.positional;
    plan.simple &= !p.positional || (!p.optional && (p.kind == scene::ArgKind::number ||
                                                     p.kind == scene::ArgKind::vector));
  }
  return plan;
}

/// The operands of a primitive, pattern or warp: positional ones in order, then flags and keyword
/// ones.
std::vector<double> Interpreter::read_operands(const scene::TypeInfo& info, const Token& word) {
  const OperandPlan& plan = operand_plan(info);
  std::vector<double> args = plan.fallback;
  const auto put = [&](std::size_t i) { read_operand(info.params[i], &args[plan.offsets[i]]); };
  for (std::size_t i = 0; i < plan.positional; ++i) {
    const scene::Param& p = info.params[i];
    if (!p.positional) continue;
    const Token& t = peek();
    const bool here = t.kind == Token::Kind::expr || t.kind == Token::Kind::punct;
    if (!here && p.optional) continue;
    if (!here) {
      Diagnostic d;
      d.code = Code::missing_argument;
      d.span = t.span;
      d.message =
          fmt::format("expected {} of this `{}`, found {}", with_article(p.doc), info.name,
                      describe(t));
      d.labels.push_back({word.span, "in this block"});
      fail(std::move(d));
    }
    put(i);
    // A comma after the last operand is an error in the language (language §1.8).
    if (i + 1 < plan.positional) optional_comma();
  }
  for (bool again = plan.has_words; again;) {
    again = false;
    const Token t = peek();
    if (t.kind != Token::Kind::word) break;
    for (std::size_t i = 0; i < info.params.size(); ++i) {
      if (info.params[i].positional || info.params[i].name != name_of(t.word)) continue;
      next();
      put(i);
      again = true;
      break;
    }
  }
  check_operands(info, args, word);
  return args;
}

/// What the type itself says about complete operands.
void Interpreter::check_operands(const scene::TypeInfo& info, std::span<const double> args,
                                 const Token& word) {
  if (info.validate != nullptr) {
    if (const auto problem = info.validate(args)) fail(Code::degenerate, word.span, *problem);
  }
  if (info.doubt != nullptr) {
    if (const auto doubt = info.doubt(args)) warn(Code::degenerate, word.span, *doubt);
  }
}

/// A long vector `< … >` into `out`; returns how many numbers there were.
std::size_t Interpreter::read_numbers(std::span<double> out) {
  const Token t = next();
  std::size_t n = 0;
  const auto take = [&] {
    while (peek().kind != Token::Kind::end) {
      const double x = read_scalar("number");
      if (n < out.size()) out[n] = x;
      ++n;
      optional_comma();
    }
  };
  if (const auto* v = t.node<ast::Vector>(); v != nullptr) {
    for (std::uint32_t i = 0; i < v->components.count; ++i) {
      const Nested part(*this, *t.tree, t.tree->expr_lists[v->components.first + i]);
      take();
    }
  } else if (const auto* g = t.node<ast::OpenGroup>();
             g != nullptr && g->kind == ast::OpenGroup::Kind::vector) {
    const Nested part(*this, *t.tree, g->items);
    take();
  } else {
    unexpected(t, "`<` and a list of numbers");
  }
  return n;
}

}  // namespace durer::interpreter
