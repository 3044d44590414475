// Running prepared statements, where objects are wanted: at the top level and in CSG.
#include "interpreter/statements.h"

#include "interpreter/interpreter.h"

namespace durer::interpreter {

namespace w = grammar::words;

/// Runs what comes next as far as it is prepared; what is left is to be pulled. Only for who wants
/// objects and nothing else: they go into `children`, or become roots if there are none.
void Interpreter::run_ahead(std::vector<scene::ObjectId>* children) {
  while (unread_.size() == unread_base_ && takes_shortcuts()) {
    const Frame& f = frames_.back();
    if (!f.has_items() || f.flatten) return;
    const bool went_on = f.pos < f.end ? run_ahead_once(children) : leave_ahead();
    if (!went_on) return;
  }
}

/// At the end of a frame: leaves it, or begins it anew. False if that is for who reads it.
bool Interpreter::leave_ahead() {
  Frame& f = frames_.back();
  switch (f.kind) {
    case Frame::Kind::file:
    case Frame::Kind::group:
    case Frame::Kind::barrier: return false;
    case Frame::Kind::macro:
    case Frame::Kind::branch: pop(); return true;
    default: {
      Token none;
      step_end(none);
      return true;
    }
  }
}

/// The next item of the innermost frame.
bool Interpreter::run_ahead_once(std::vector<scene::ObjectId>* children) {
  Frame& f = frames_.back();
  const ast::Tree& tree = *f.tree;
  const ast::Item& item = tree.items[f.pos];
  if (repeats_ == 0) {  // not worth preparing
    if (item.kind != ast::ItemKind::directive) return false;
    ++f.pos;
    execute(tree, item);
    return true;
  }
  constexpr std::uint8_t enough = 50;
  Statement& s = statement_at(tree, f.pos);
  switch (s.kind) {
    case Statement::Kind::unknown:
    case Statement::Kind::general: return false;
    case Statement::Kind::object:
      if (run_object(item.span, *s.object, children)) return true;
      if (++s.failures == enough) s.kind = Statement::Kind::general;
      return false;
    case Statement::Kind::call: return run_call(tree, *s.call);
    case Statement::Kind::leave:
      ++f.pos;
      break_out(tree.directives[item.ref].span);
      return true;
    case Statement::Kind::choice:
      if (run_switch(tree, *s.choice)) return true;
      break;
    case Statement::Kind::assign:
      if (!quick_assign(*s.declare, *s.formula)) break;
      ++f.pos;
      return true;
    case Statement::Kind::directive: break;
  }
  ++f.pos;
  execute(tree, item);
  return true;
}

namespace {

/// What type, if any, is wrong with operands, or doubtful.
bool is_unusual(const scene::TypeInfo& info, std::span<const double> operands) {
  return (info.validate != nullptr && info.validate(operands)) ||
         (info.doubt != nullptr && info.doubt(operands));
}

}  // namespace

bool Interpreter::work_out_operands(const ObjectPlan& plan, std::span<double> args) {
  std::copy(plan.fallback->begin(), plan.fallback->end(), args.begin());
  for (const ObjectPlan::Operand& operand : plan.operands) {
    const int most = operand.scalar ? 1 : 3;
    const Operand* result = run_formula(*operand.formula, most);
    if (result == nullptr || result->is_text() || result->length > most) return false;
    double* const out = &args[operand.offset];
    out[0] = result->v[0];
    if (operand.scalar) continue;
    out[1] = result->v[1];
    out[2] = result->v[2];
  }
  return !is_unusual(*plan.info, args);
}

/// What is known of an object's looks before it is made.
struct Interpreter::PlannedLook {
  const Boxed<scene::Finish>* finish = nullptr;  // that a finish makes of the default
  bool shared = false;                           // it looks like an earlier object
};

/// What the formulas of the steps come to, in order; false if anything is unusual.
bool Interpreter::work_out_steps(const ObjectPlan& plan, std::span<Operand> values,
                                 PlannedLook& look) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const ObjectPlan::Step& step = plan.steps[i];
    const bool moves = step.word != w::pigment && step.word != w::finish;
    if (!moves && !takes_paint(default_texture_)) return false;
    if (step.finish != nullptr) {
      const scene::Layer& layer = scene_.textures[default_texture_].layers[0];
      look.finish = known_finish(*step.finish, layer.finish);
      if (look.finish == nullptr) return false;
    }
    if (step.formula == nullptr) continue;
    const int wanted = moves ? 3 : step.strict ? 1 : step.form.components();
    const Operand* result = run_formula(*step.formula, wanted);
    if (result == nullptr || result->is_text()) return false;
    if (moves && result->length > 3) return false;
    if (step.strict && result->length != 5) return false;
    values[i] = *result;
  }
  return true;
}

void Interpreter::take_colour(scene::Object& o, const ObjectPlan::Step& step, const Operand& value,
                              PlannedLook& look) {
  Num n = value.number();
  if (n.length == 1) n = Num::filled(n.v[0], step.form.components());
  if (step.keyword != nullptr) {
    check_components(n, step.form.wanted, step.keyword->ref, step.keyword->span);
  }
  const Colour colour = to_colour(n, step.form).colour();
  if (step.finish != nullptr) {
    look.shared = dress(o.texture, colour, *look.finish, step.span);
  } else {
    o.texture = {default_texture_, {}};
    paint(o.texture, colour, step.span);
  }
}

/// Makes the object that was planned, whose word and block come next; false, with nothing done, if
/// anything about it is unusual now.
bool Interpreter::run_object(Span word, const ObjectPlan& plan,
                             std::vector<scene::ObjectId>* children) {
  Peek peek(*this);
  std::array<double, ObjectPlan::most_operands> args;   // NOLINT: filled as far as used
  std::array<Operand, ObjectPlan::most_values> values;  // NOLINT: likewise
  const std::span operands(args.data(), plan.fallback->size());
  PlannedLook look;
  if (!work_out_operands(plan, operands) || !work_out_steps(plan, values, look)) return false;
  peek.keep();

  // Nothing fails from here on, so the object is made where it stays.
  frames_.back().pos += 2;
  const auto id = static_cast<scene::ObjectId>(scene_.objects.size());
  object_depths_.push_back(1);
  scene::Object& o = scene_.objects.emplace_back();
  o.kind = scene::NodeKind::primitive;
  o.type = plan.type;
  o.origin = origin(word);
  o.args = std::span<const double>(operands);
  if (default_importance_ != 1) o.importance = default_importance_;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const ObjectPlan::Step& step = plan.steps[i];
    if (step.word == w::pigment) {
      take_colour(o, step, values[i], look);
    } else if (step.word == w::finish) {
      give_finish(o.texture, *look.finish);
    } else {
      const std::array<double, 5>& v = values[i].v;
      transform_object(o, transformation(step.word, {v[0], v[1], v[2]}, step.span));
    }
  }
  settle_texture(o);
  if (look.shared) o.texture.transform = {};  // as settle_texture does
  if (children != nullptr) {
    children->push_back(id);
  } else {
    add_root(id);
  }
  return true;
}

}  // namespace durer::interpreter
