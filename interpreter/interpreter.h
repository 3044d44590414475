// The interpreter's one class: an environment, a stack of frames, and readers for every block.
// Its members are spread over files by subject; this header is private to the folder.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/diagnostic.h"
#include "functions/evaluate.h"
#include "grammar/ast.h"
#include "grammar/vocabulary.h"
#include "interpreter/environment.h"
#include "interpreter/formula.h"
#include "interpreter/interpret.h"
#include "interpreter/plain_look.h"
#include "interpreter/statements.h"
#include "interpreter/stream.h"
#include "interpreter/value.h"
#include "scene/scene.h"

namespace durer::interpreter {

/// Moves everything in a medium that has a place.
void move_densities(scene::Media& media, const Transform& by);

class Font;
struct PictureFile;
class MeshBuilder;

/// Before one more comes into a list that may grow long. Moving what it holds costs more than room
/// that is never touched.
template <typename T>
void make_room(std::vector<T>& list) {
  constexpr std::size_t least = 64;
  if (list.size() == list.capacity()) list.reserve(4 * list.size() + least);
}

/// "1 argument", "3 arguments"; for messages.
[[nodiscard]] std::string argument_count(std::size_t n);

/// Unwinds the interpreter after an error has been reported; never leaves `interpret`. `final`: the
/// rest of the scene is not even looked at.
struct Failure {
  bool final = false;
};

class Interpreter {
 public:
  Interpreter(SourceMap& sources, const scene::Registry& registry, const Options& options,
              Diagnostics& diagnostics);

  /// Runs a whole scene; empty if an error was reported.
  [[nodiscard]] std::optional<scene::Scene> run(FileId main_file);

 private:
  // ---- stream.cpp: the pull stream
  Token next();
  const Token& peek();
  /// What is written next, without executing anything: kind `end` if only executing would tell.
  [[nodiscard]] Token raw_next() const;
  bool accept_raw_punct(char c);
  void unread(const Token& token);
  bool step(Token& token);
  bool step_item(Token& token);
  bool step_end(Token& token);
  bool step_expansion(Token& token);
  bool step_literals(Token& token);
  void push_literals(const ast::Tree& tree, const ast::Item& item);
  [[nodiscard]] Token literal_token(const double* v, int width, Span span);
  [[nodiscard]] bool at_literals() const;
  Frame* literals_ahead(int width);
  template <typename Take>
  std::size_t take_literals(Frame& frame, std::size_t most, Take&& take);
  void expand(const ast::Tree& tree, ast::ExprId id, bool flatten);
  void push_pieces(const ast::Tree& tree, ast::ExprId id, bool flatten);
  [[nodiscard]] bool needs_expansion(const ast::Tree& tree, ast::ExprId id,
                                     bool alone = false) const;
  [[nodiscard]] bool operand_expands(const ast::Tree& tree, ast::ExprId id) const;
  [[nodiscard]] bool is_macro_call(const ast::Tree& tree, ast::ExprId id) const;
  [[nodiscard]] const MacroRef* macro_named(SymbolId name) const;
  [[nodiscard]] const MacroRef* macro_of(const ast::Tree& tree, ast::ExprId callee) const;
  Frame& push(Frame::Kind kind, Span call);
  void push(const Frame& frame);
  void pop();
  void break_out(Span span);

  /// Reads a delimited part with a nested reader: everything pulled while it lives comes from that
  /// part, then `end`.
  class Nested {
   public:
    /// `whole` is where errors are told if there are no items.
    Nested(Interpreter& in, const ast::Tree& tree, ast::Range items, Span whole = {});
    Nested(Interpreter& in, const ast::Tree& tree, ast::ExprId expr);
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    ~Nested() { in_.close_barrier(depth_, unread_base_, declare_depth_); }
    /// Error unless everything has been read.
    void finish(std::string_view what);

   private:
    void open(const ast::Tree& tree);
    Interpreter& in_;
    std::size_t depth_;
    std::size_t unread_base_;
    std::size_t declare_depth_;
  };
  friend class Nested;
  void close_barrier(std::size_t depth, std::size_t unread_base, std::size_t declare_depth);

  // ---- execute.cpp, directives/: what directives do
  /// How running a statement ended. `broken`: a #break left it and looks for what to end.
  enum class Flow : std::uint8_t { normal, broken };
  void execute(const ast::Tree& tree, const ast::Item& item);
  /// While it lives, a loop is running that no frame stands for.
  struct Repeating {
    explicit Repeating(Interpreter& in) : in_(in) { ++in_.repeats_; }
    Repeating(const Repeating&) = delete;
    Repeating& operator=(const Repeating&) = delete;
    ~Repeating() { --in_.repeats_; }
    Interpreter& in_;
  };
  Flow run_directive(const ast::Tree& tree, const ast::Directive& d);
  /// Runs items that are statements all (ast::Body::Shape), without delivering anything.
  Flow run_statements(const ast::Tree& tree, ast::Range items);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Declare& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Undef& node);
  Flow run(const ast::Tree& tree, const ast::Directive& d, const ast::If& node);
  Flow run(const ast::Tree& tree, const ast::Directive& d, const ast::While& node);
  Flow run(const ast::Tree& tree, const ast::Directive& d, const ast::For& node);
  Flow run(const ast::Tree& tree, const ast::Directive& d, const ast::Switch& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Macro& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Include& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Version& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Message& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Simple& node);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Unknown& node);
  bool loop_again(Frame& frame);
  bool next_turn(const ast::Directive& d, const ast::For& node, double limit, double step);
  /// Counts a loop turn or macro call against the limits.
  void tick(Span span) {
    if (++turns_ >= next_check_) check_limits(span);
  }
  void check_limits(Span span);
  void check_stack(Span span);
  void check_depth(const scene::Object& object, std::uint32_t depth);
  bool condition(const ast::Tree& tree, ast::ExprId id);
  bool is_defined(const ast::Tree& tree, ast::ExprId id);
  void call_macro(const ast::Tree& tree, ast::ExprId call, bool flatten);
  void count_call(const ast::Macro& macro, Span call);
  Frame& open_macro(const MacroRef& ref, ast::Range items, Span call, std::size_t first);
  void enter_macro(const ast::Tree& tree, ast::ExprId call, const MacroRef& ref, ast::Range items,
                   bool flatten);
  [[nodiscard]] bool adds_up(const ast::Tree& tree, ast::ExprId id);
  void add_argument(const ast::Tree& tree, ast::ExprId arg, bool optional = false);
  void add_argument(const ast::Tree& tree, const CallPlan::Argument& argument);
  void read_open_arguments(const ast::Tree& tree, ast::Range items, const MacroRef& ref);
  [[nodiscard]] const MacroRef* value_macro(const ast::Tree& tree, ast::ExprId id,
                                            bool alone) const;
  template <typename Read>
  auto macro_value(const ast::Tree& tree, ast::ExprId id, const MacroRef& ref, Read read);
  void bind_argument(Slot& slot, const ast::Tree& tree, ast::ExprId arg);
  struct Subscript {
    double value;
    Span span;
  };
  /// The subscripts of one access: five dimensions, and arrays of arrays. Lives on the stack,
  /// because array accesses stand in every hot loop.
  class Subscripts {
   public:
    static constexpr std::size_t capacity = 20;
    bool add(Subscript s) {
      if (count_ == capacity) return false;
      items_[count_++] = s;
      return true;
    }
    [[nodiscard]] std::size_t size() const { return count_; }
    const Subscript& operator[](std::size_t i) const { return items_[i]; }

   private:
    std::array<Subscript, capacity> items_;  // NOLINT: filled up to count_
    std::size_t count_ = 0;
  };
  Subscript read_subscript(const ast::Tree& tree, ast::ExprId id);
  Subscripts read_subscripts(const ast::Tree& tree, ast::Range list);
  /// The same of an Index or OpenGroup(index).
  Subscripts read_subscripts(const ast::Tree& tree, ast::ExprId id);
  Value* element(SymbolId name, const Subscripts& subscripts, Span span, bool for_writing,
                 bool must_exist = true);
  std::size_t flat_index(const Subscripts& subscripts, const Array& array, Span span,
                         std::size_t& used);
  /// The array that an Index or OpenGroup(index) names; none for other expressions.
  [[nodiscard]] static std::optional<SymbolId> array_of(const ast::Expr& e) {
    if (const auto* index = std::get_if<ast::Index>(&e.node)) return index->name;
    if (const auto* g = std::get_if<ast::OpenGroup>(&e.node);
        g != nullptr && g->kind == ast::OpenGroup::Kind::index) {
      return g->name;
    }
    return std::nullopt;
  }
  void missing_semicolon(const ast::Declare& node, const Num& n);
  bool quick_assign(const ast::Tree& tree, const ast::Declare& node);
  bool quick_assign(const ast::Declare& node, Formula& formula);
  [[nodiscard]] static bool assigns_variable(const ast::Declare& node);
  static void store_number(Value& target, Num n);
  void check_kind(const Value* first, const Array& array, const Value& value, Span span);
  void store(Value& target, Value value, bool is_element, const Array* array, Span span);
  void default_block();
  void set_version(double v, Span span);

  // ---- statements.cpp, statement_plans.cpp: statements that were met before
  void run_ahead(std::vector<scene::ObjectId>* children);
  bool run_ahead_once(std::vector<scene::ObjectId>* children);
  bool leave_ahead();
  Statement& statement_at(const ast::Tree& tree, std::uint32_t pos) {
    const auto& known = statements_of_[tree.file];
    return known.empty() || known[pos] == nullptr ? new_statement(tree, pos) : *known[pos];
  }
  Statement& new_statement(const ast::Tree& tree, std::uint32_t pos);
  std::unique_ptr<SwitchPlan> plan_switch(const ast::Tree& tree, const ast::Directive& d);
  bool run_switch(const ast::Tree& tree, const SwitchPlan& plan);
  void prepare(Statement& s, const ast::Tree& tree, std::uint32_t pos);
  std::unique_ptr<CallPlan> plan_call(const ast::Tree& tree, ast::ExprId id);
  std::unique_ptr<ObjectPlan> plan_object(const ast::Tree& tree, std::uint32_t pos);
  bool plan_operands(ObjectPlan& plan, const Frame& block, std::uint32_t& pos);
  bool plan_step(ObjectPlan& plan, const Frame& block, std::uint32_t& pos);
  bool plan_colour(ObjectPlan::Step& step, const ast::Tree& tree, ast::Range items);
  bool run_call(const ast::Tree& tree, const CallPlan& plan);
  bool run_object(Span word, const ObjectPlan& plan, std::vector<scene::ObjectId>* children);
  bool work_out_operands(const ObjectPlan& plan, std::span<double> args);
  struct PlannedLook;
  bool work_out_steps(const ObjectPlan& plan, std::span<Operand> values, PlannedLook& look);
  void take_colour(scene::Object& o, const ObjectPlan::Step& step, const Operand& value,
                   PlannedLook& look);

  // ---- places.cpp, additions.cpp: dictionaries and what else is new in 3.8
  enum class Access : std::uint8_t { read, probe, write };
  /// Where a value is kept; `array` if it is an element of one.
  struct Place {
    Value* value = nullptr;
    Array* array = nullptr;
  };
  Place place(const ast::Tree& tree, ast::ExprId id, Access access);
  Place scope_entry(SymbolId scope, SymbolId name, Span span, Access access);
  Place step_into(Place from, const ast::Tree& tree, ast::Range subscripts, Span span,
                  Access access);
  Place dictionary_entry(Value& dictionary, const Text& key, Span span, Access access);
  [[noreturn]] void no_entry(const Dictionary& dictionary, const Text& key, Span span);
  Value* entry(const ast::Tree& tree, ast::ExprId id, bool must_exist);
  [[nodiscard]] bool leads_to_entry(const ast::Tree& tree, ast::ExprId id) const;
  void refer(const ast::Tree& tree, ast::ExprId id, Slot& slot);
  void refer_into(const ast::Tree& tree, ast::Range list, Slot& slot, Span span);
  [[nodiscard]] Slot* scope_slot(SymbolId scope, SymbolId name);
  [[nodiscard]] bool is_scope(SymbolId name) const;
  [[nodiscard]] bool in_dictionary(SymbolId name) const;
  [[nodiscard]] bool starts_dictionary(const Token& token) const;
  Value read_dictionary();
  void assign(const ast::Tree& tree, const ast::Declare& node, Value value, std::uint32_t scope,
              Slot* existing, const Subscripts* at = nullptr);
  void assign_place(const ast::Tree& tree, const ast::Declare& node, Value value);
  void assign_target(const ast::Tree& tree, const ast::Tuple& node, ast::ExprId target,
                     Value value);
  void run(const ast::Tree& tree, const ast::Directive& d, const ast::Tuple& node);
  void declare_additions();
  void check_new_name(SymbolId name, Span span);

  // ---- files.cpp: data files
  SymbolId read_name(std::string_view what);
  DataFile& file_named(SymbolId name, Span span);
  void open_file(Span span);
  void close_file();
  void write_file();
  void read_file();
  template <typename Body>
  void in_parentheses(std::string_view what, Body body);

  // ---- file_access.cpp: which files, and where they are
  [[nodiscard]] std::vector<std::filesystem::path> search_folders(Span span) const;
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;
  [[nodiscard]] bool may_write(const std::filesystem::path& path) const;
  /// Every file that a scene reads is found here; `suffixes` (".inc") may be left out in scenes.
  [[nodiscard]] std::optional<std::string> find_file(
      const std::string& name, Span span, std::span<const std::string_view> suffixes = {},
      bool tolerant = true);
  [[noreturn]] void missing_file(const std::string& name, Span span,
                                 std::span<const std::string_view> suffixes = {});
  void check_writable(const std::string& path, Span span);

  // ---- pictures.cpp, images.cpp, density_files.cpp
  PictureFile read_picture_file();
  std::shared_ptr<const Picture> load_picture(const std::string& path, const std::string& kind,
                                              Span span);
  std::shared_ptr<const Picture> read_function_picture(double columns, double rows, Span span);
  functions::FunctionRef read_picture_function(Span span);
  void sample_numbers(const functions::Function& function, Picture& picture);
  void read_image(scene::Pattern& pattern, const Token& word, float* bump_size);
  void read_image_source(scene::Image& image, bool is_map);
  void set_curves(scene::Image& image, const PictureFile& file, bool is_map) const;
  bool image_setting(scene::Image& image, const Token& t, SymbolId block);
  void image_kind(scene::Image& image, const Token& t, SymbolId block);
  void palette_setting(scene::Image& image, const Token& t);
  std::shared_ptr<const scene::Voxels> read_voxels();
  void read_object_pattern(scene::Pattern& pattern, Span span);

  // ---- include.cpp: files
  const ast::Tree& load(const std::string& name, Span span);
  void forget_text(const std::string& path);
  void include(const std::string& name, Span span);

  /// Takes back what is drawn from random streams while it lives, unless it is to be kept: an
  /// expression that is looked at will be worked out again.
  class Peek {
   public:
    explicit Peek(Interpreter& in) : in_(in), outer_(in.peek_) { in.peek_ = &draws_; }
    Peek(const Peek&) = delete;
    Peek& operator=(const Peek&) = delete;
    ~Peek() {
      in_.peek_ = outer_;
      if (keep_) {
        if (outer_ != nullptr) outer_->insert(outer_->end(), draws_.begin(), draws_.end());
        return;
      }
      for (std::size_t i = draws_.size(); i-- > 0;) {
        in_.streams_[draws_[i].stream] = draws_[i].before;
      }
    }
    void keep() { keep_ = true; }

   private:
    Interpreter& in_;
    std::vector<Draw>* outer_;
    std::vector<Draw> draws_;
    bool keep_ = false;
  };
  friend class Peek;

  // ---- evaluate.cpp: closed expressions
  /// `length`: the number of components that the place wants (language §2.4); 1 also means "any".
  Num evaluate(const ast::Tree& tree, ast::ExprId id, int length);
  /// Full level: a result of one component fills all `length` slots.
  Num evaluate_full(const ast::Tree& tree, ast::ExprId id, int length);
  /// The same in place: `v` has room for five components, zero at first; returns how many count.
  int work_out(const ast::Tree& tree, ast::ExprId id, int want, double* v);
  /// The compiled way to a value (formula.h), valid until the next; null if there is none here.
  const Operand* quick(const ast::Tree& tree, ast::ExprId id, int want);
  const Operand* run_formula(Formula& formula, int want) {
    if (formula.calls_functions) workspace_.context.noise_generator = noise_generator();
    const Operand* result = machine_.run(formula, want);
    if (result == nullptr) return note_failure(formula);
    turns_ += formula.calls;
    if (peek_ != nullptr) machine_.tell_draws(*peek_);
    return result;
  }
  static const Operand* note_failure(Formula& formula);
  Formula* formula_of(const ast::Tree& tree, ast::ExprId id);
  Formula& new_formula(const ast::Tree& tree, ast::ExprId id);
  int work_out_full(const ast::Tree& tree, ast::ExprId id, int want, double* v);
  double work_out_float(const ast::Tree& tree, ast::ExprId id, std::string_view what);
  int work_out_closed(const ast::Tree& tree, const ast::Expr& e, int want, double* v);
  int work_out_operand(const ast::Tree& tree, const ast::Expr& e, int want, double* v);
  int work_out_relation(const ast::Tree& tree, const ast::Expr& e, int want, double* v);
  int work_out_conditional(const ast::Tree& tree, const ast::Expr& e, int want, double* v);
  int work_out_vector(const ast::Tree& tree, const ast::Vector& list, Span span, double* v);
  int work_out_call(const ast::Tree& tree, const ast::Expr& e, const ast::Call& call, int want,
                    double* v);
  int take_name(SymbolId name, Span span, int want, double* v);
  int take_value(const Value& value, Span span, int want, double* v);
  int take_member(double* v, int n, SymbolId name, Span span, int want);
  int apply_binary(ast::Op op, double* v, int n, double* r, int m, Span span);
  void warn_division(Span span);
  Num evaluate_open(const ast::Tree& tree, const ast::Expr& e, const ast::OpenGroup& g, int length);
  Num binary(ast::Op op, Num left, Num right, Span span);
  Num unary(ast::Op op, Num operand);
  Num member(Num object, SymbolId member, Span span, int length);
  Value evaluate_value(const ast::Tree& tree, ast::ExprId id);
  Value take_result(const Operand& result);
  [[nodiscard]] bool is_text(const ast::Tree& tree, ast::ExprId id);
  Text evaluate_text(const ast::Tree& tree, ast::ExprId id, bool file_name = false);
  void note_use(const Slot* slot, Span span);
  Value* lookup(const ast::Tree& tree, ast::ExprId id, bool must_exist);
  Num read_components(const ast::Tree& tree, ast::Range components, Span span);
  const Value& callee(const ast::Tree& tree, ast::ExprId id);
  Num call_value(const Value& v, const ast::Tree& tree, const ast::Expr& call, int length);
  [[nodiscard]] static Value copy_of(const Value& v);
  void check_copyable(const Value& v, SymbolId name, Span span);
  void append_text(const ast::Tree& tree, ast::ExprId id, Text& out, bool file_name = false);
  [[nodiscard]] static SymbolId text_function(const ast::Tree& tree, ast::ExprId id);
  void decode_literal(std::string_view bytes, Span span, bool file_name, Text& out);
  [[noreturn]] void unknown_name(SymbolId name, Span span);

  // ---- functions.cpp, function_body.cpp, function_calls.cpp, splines.cpp
  class FunctionReader;
  friend class FunctionReader;
  Value read_function(Span span);
  void check_may_change(Slot* slot, Span span, bool local = false);
  [[nodiscard]] bool in_library(Span span) const;
  [[noreturn]] void function_stays(SymbolId name, Span span);
  std::vector<SymbolId> read_parameters();
  functions::FunctionRef read_scene_function(std::span<const SymbolId> parameters);
  Value read_internal_function(Span span);
  Value read_special_function(Span span);
  scene::Pigment read_pattern(const Token& word);
  functions::Function compile_function(std::span<const SymbolId> parameters);
  Num call_function(const UserFunction& f, const ast::Tree& tree, const ast::Expr& e, int length);
  std::size_t read_arguments(const ast::Tree& tree, const ast::Expr& e, std::span<double> out);
  [[nodiscard]] int noise_generator() const;
  std::shared_ptr<const functions::Spline> read_spline(Span span);
  Num call_spline(const functions::Spline& spline, const ast::Tree& tree, const ast::Expr& e);

  // ---- builtins.cpp: the functions of the language
  class Args;
  friend class Args;
  Num call_builtin(const ast::Tree& tree, const ast::Expr& e, SymbolId function,
                   std::span<const ast::ExprId> args, const ast::OpenGroup* open, int length);
void append_text_call(const ast::Tree& tree, const ast::Expr& e, SymbolId function,
                        std::span<const ast::ExprId> args, const ast::OpenGroup* open, Text& out);
  scene::ObjectId object_argument(const ast::Tree& tree, ast::ExprId id, Span call);
  [[nodiscard]] static double days_since_2000();

  // ---- read.cpp: expressions and values from the stream
  [[nodiscard]] static bool ends_expression(const Frame& f, std::uint32_t pos, bool full);
  ast::ExprId take_plain(const ast::Tree*& tree, bool full);
  Num read_num(int length);   // additive level
  Num read_full(int length);  // relations, logic, ?:
  Num read_full_in_place(int length);
  double read_float();
  double read_scalar(std::string_view what);
  dvec3 read_vector();
  const Num& fit(const Num& n, int length);
  Num read_product(int length);
  Num read_factor(int length);
  bool at_operator();
  bool at_full_operator();
  [[nodiscard]] bool in_declared_value() const;
  void leave_ended_frames();
  Token next_operator();
  Num continue_product(Num n);
  Num continue_sum(Num n);
  [[nodiscard]] bool flatten_context() const;
  Text read_text(bool file_name = false);
  bool read_switch(bool fallback);  // an optional float: absent means on
  bool starts_number(const Token& token);
  [[nodiscard]] static bool starts_colour(const Token& token);
  void check_components(const Num& n, int wanted, SymbolId word, Span span);
  std::optional<Colour> quick_colour_block();
  Colour read_colour();  // with or without the word `color`
  Num read_colour_num(bool strict = false);
  void continue_colour(Num& c);
  vec3 read_rgb();     // where only rgb is wanted
  Value read_value();  // the right side of a declare, an argument, an element
  std::shared_ptr<Array> read_array(Span span);
  void read_array_level(Array& array, std::size_t level, std::size_t first, bool lenient,
                        Span span);
  void add_size(Array& array, double written, std::size_t& total, Span span);
  void grow(Array& array, double subscript, Span span);
  void optional_comma();
  bool argument_comma();
  void accept_raw_comma_or_peek();
  [[nodiscard]] std::string describe(const Token& token) const;
  bool accept(SymbolId word);
  bool accept_punct(char c);
  void expect_open(std::string_view block);
  void expect_close(std::string_view block, Span opened);
  [[noreturn]] void unexpected(const Token& token, std::string_view expected);
  /// What stands where a setting of `block` should: names the nearest of `settings`, which are
  /// separated by blanks.
  [[noreturn]] void bad_setting(const Token& token, std::string_view block, Span opened,
                                std::string_view settings);
  /// Skips to the end of the block whose opening brace has been read.
  void skip_block();
  Value skip_unsupported(std::string_view feature, Span span);

  // ---- predefined.cpp, macro_trace.cpp
  void predefine();
  void trace_call(const Frame& frame, const ast::Tree& tree, const ast::Macro& macro);
  void trace_return(const Frame& frame);

  // ---- blocks: scene things
  void top_level();
  // ---- versions.cpp: what old versions did otherwise
  void obsolete_directive(const Token& word, std::string_view name);
  [[nodiscard]] std::string assumptions() const;
  void decode_high_bytes(std::string_view bytes, std::size_t& at, Span span, Text& out);
  std::optional<Transform> read_transformation(const Token& token);
  Transform transformation(SymbolId word, dvec3 by, Span span);
  Transform read_transform_block();
  Transform read_matrix(const Token& word);
  std::size_t read_numbers(std::span<double> out);
  void read_exponents(std::array<std::size_t, 3>& power, Span span);
  scene::Object read_polynomial(std::uint32_t type, const Token& word);
  using Reader = scene::Object (Interpreter::*)(std::uint32_t type, const Token& word);
  [[nodiscard]] static Reader reader_of(SymbolId word);
  scene::ObjectId read_object(const Token& word);
  bool starts_object(const Token& token) const;
  void check_operands(const scene::TypeInfo& info, std::span<const double> args,
                      const Token& word);
  scene::Object primitive(std::uint32_t type, const Token& word);
  scene::Object read_primitive(std::uint32_t type, const Token& word);
  // ---- quick_objects.cpp
  [[nodiscard]] Frame* plain_items();
  [[nodiscard]] bool is_operand(const Frame& f, std::uint32_t pos) const;
  bool quick_operands(const scene::TypeInfo& info, std::vector<double>& args, const Token& word);
  bool quick_modifier(scene::Object& o);
  void read_operand(const scene::Param& param, double* out);
  /// What is known of the operands of a type before any is read.
  struct OperandPlan {
    std::vector<double> fallback;
    std::vector<std::uint16_t> offsets;  // by parameter
    std::size_t positional = 0;          // parameters up to the last positional one
    bool has_words = false;
    bool simple = true;  // the positional ones: floats and vectors, none of which may be left out
  };
  const OperandPlan& operand_plan(const scene::TypeInfo& info);
  std::vector<double> read_operands(const scene::TypeInfo& info, const Token& word);
  void read_cylinder_type(CameraSpec& c, Span span);
  void read_blur_samples(scene::Lens& lens, Span span);
  void read_mesh_camera(CameraSpec& c, Span span);
  bool read_camera_functions(const CameraSpec& c, std::array<functions::FunctionRef, 3>& out);

  // ---- function_objects.cpp
  static constexpr int most_traces = 10;  // of max_trace (objects §3)
  scene::Object read_isosurface(std::uint32_t type, const Token& word);
  scene::Object read_parametric(std::uint32_t type, const Token& word);
  scene::Container read_container();
  double read_positive(const Token& word, double fallback);
  int read_max_trace(const Token& word);
  void read_precompute(const Token& word);

  // ---- curves.cpp
  friend class ObjectReader;
  scene::Object read_text_object(std::uint32_t type, const Token& word);
  std::shared_ptr<Font> open_font(const std::string& name, Span span);
  scene::Object read_listed(std::uint32_t type, const Token& word);
  // ---- meshes.cpp
  scene::Object read_mesh(std::uint32_t type, const Token& word);
  scene::Object read_mesh2(std::uint32_t type, const Token& word);
  void read_mesh_triangle(MeshBuilder& builder, const Token& word);
  void read_mesh2_vectors(MeshBuilder& builder, const Token& word);
  void read_mesh2_faces(MeshBuilder& builder, const Token& word);
  void read_mesh2_textures(MeshBuilder& builder, std::size_t face);
  void read_mesh2_indices(MeshBuilder& builder, const Token& word);
  scene::Object finish_mesh(std::uint32_t type, const Token& word, MeshBuilder& builder);
  template <typename Start, typename Read>
  void read_counted(std::string_view block, Start&& start, Read&& read);
  template <typename Start, typename Take>
  void read_vectors(int width, std::string_view block, Start&& start, Take&& take);
  dvec2 read_uv();
  scene::Triple to_triple(const double* v, std::size_t limit, std::string_view what, Span span);
  std::uint32_t to_index(double value, std::size_t limit, std::string_view what, Span span);
  scene::TextureId read_listed_texture();
  bool starts_float(const Token& token);
  [[noreturn]] void missing_indices(std::string_view block, const Token& word);

  scene::Object read_csg(scene::NodeKind kind, const Token& word);
  scene::ObjectId read_object_modifiers(scene::Object object, const Token& word, Span opened);
  void settle_texture(scene::Object& object);
  bool object_modifier(scene::Object& object, const Token& token);
  void transform_object(scene::Object& object, const Transform& t);
  void read_clips(scene::Object& object, bool clip);
  scene::ObjectId read_light(const Token& word);
  void read_light_items(scene::Object& object, scene::Light& light, const Token& word);
  bool aiming_setting(scene::Light& light, const Token& token);
  bool area_setting(scene::Light& light, const Token& token);
  void read_area(scene::Light& light, Span span);
  void check_circular(const scene::LightArea& area, Span span);
  void settle_oriented(scene::Light& light, Span span);
  scene::Object start_only_object(const Token& word, Span& opened);
  void read_looks_like(scene::Object& object, const scene::Light& light, const Token& word);
  [[nodiscard]] static vec3 sum_of_colours(const ColourMap& map);
  scene::ObjectId read_light_group(const Token& word);
  void add_root(scene::ObjectId id);
  scene::ObjectId add_object(scene::Object object);

  scene::TextureId read_texture(std::string_view block);
  scene::Texture materialize(const scene::TextureUse& use);
  void edit_texture(scene::TextureUse& use, const Token& word);
  /// Changes the texture in use by `edit`, in place if this statement has made it.
  template <typename Edit>
  void change_texture(scene::TextureUse& use, Edit&& edit) {
    const bool own = use.texture == own_texture_ && own_texture_ != scene::none;
    if (!own) {
      scene::Texture t = materialize(use);
      edit(t);
      use = {add_texture(std::move(t)), {}};
      own_texture_ = use.texture;
      return;
    }
    // Nobody else has seen it.
    scene::Texture t = std::move(scene_.textures[use.texture]);
    if (!use.transform.is_identity()) transform_texture(t, use.transform);
    edit(t);
    scene_.textures[use.texture] = std::move(t);
    use.transform = {};
  }
  void add_layers(scene::TextureUse& use, scene::TextureId layers);
  void transform_texture(scene::Texture& texture, const Transform& t);
  void edit_layer(scene::Layer& layer, const Token& word);
  scene::TextureId read_texture_body(Token::Kind last);
  void read_texture_items(scene::Texture& texture, Span span, Token::Kind last);
  void read_texture_part(scene::Texture& texture, const Token& token, Span span);
  void read_pattern_texture(scene::Texture& texture, const Token& word, Token::Kind last);
  void read_texture_list(scene::Texture& texture, int size);
  void read_materials(scene::Texture& texture, scene::Pattern& pattern, Span span);
  void read_tiles(scene::Texture& texture, Span span);
  scene::Layer& top_layer(scene::Texture& texture, Span span);
  void keep_bump_scale(scene::Texture& texture);
  TextureMap read_texture_map(bool weights);
  scene::TextureId add_texture(scene::Texture texture);
  void share_texture(scene::TextureUse& use);
  [[nodiscard]] static bool is_plain(const scene::Texture& texture);
  bool quick_pigment(scene::TextureUse& use);
  [[nodiscard]] bool takes_paint(scene::TextureId texture);
  void give_finish(scene::TextureUse& use, const Boxed<scene::Finish>& finish);
  scene::TextureId painted(scene::TextureId base, const Colour& colour, Span written);
  bool dress(scene::TextureUse& use, const Colour& colour, const Boxed<scene::Finish>& finish,
             Span written);
  void paint(scene::TextureUse& use, const Colour& colour, Span written);
  scene::Pigment read_pigment(scene::Pigment start);
  void read_pigment_body(scene::Pigment& pigment, Token::Kind last);
  void start_pigment_pattern(scene::Pigment& pigment, std::uint32_t index, const Token& word);
  bool pigment_modifier(scene::Pigment& pigment, const Token& token);
  void read_colour_list(scene::Pigment& pigment, const scene::PatternInfo& info);
  ColourMap read_colour_map();
  ColourMap read_pigment_map(bool weights);
  // ---- maps.h
  template <typename Map, typename ReadEntry>
  void read_map(std::string_view name, Map& map, bool weights, ReadEntry read_entry);
  void check_pattern(const scene::Pattern& pattern, bool none, std::string_view map);
  [[noreturn]] void bad_map(const Token& word, const scene::PatternInfo* info);
  // ---- normals.cpp
  [[nodiscard]] const scene::Normal& default_normal() const;
  scene::Normal read_normal(scene::Normal start);
  void read_normal_body(scene::Normal& normal, Token::Kind last);
  void start_normal_pattern(scene::Normal& normal, std::uint32_t index, const Token& word);
  bool normal_modifier(scene::Normal& normal, const Token& token);
  static void keep_bump_scale(scene::Normal& normal);
  NormalMap read_normal_map(bool weights);
  SlopeMap read_slope_map();
  // ---- patterns.cpp
  [[nodiscard]] bool is_pattern_word(SymbolId word) const;
  void choose_pattern(scene::Pattern& pattern, std::uint32_t index);
  void read_pattern_operands(scene::Pattern& pattern, const Token& word,
                             float* bump_size = nullptr);
  void open_list(scene::Pattern& pattern, const Token& word);
  void close_list(const scene::Pattern& pattern, const Token& word);
  bool pattern_modifier(scene::Pattern& pattern, const Token& token);
  void read_turbulence(scene::Pattern& pattern, const Token& word);
  void read_magnet(scene::Pattern& pattern, Span span);
  void read_slope(scene::Pattern& pattern, Span span);
  void read_noise_generator(scene::Pattern& pattern, const Token& word);
  void read_warp(scene::Pattern& pattern, Span span);
  void skip_to(Token::Kind last);
  scene::Finish read_finish(scene::Finish start);
  // ---- constant_blocks.cpp
  const ast::Group* constant_block();
  [[nodiscard]] bool is_constant_block(const ast::Tree& tree, const ast::Group& group);
  [[nodiscard]] const Boxed<scene::Finish>* known_finish(const ast::Group& block,
                                                         const Boxed<scene::Finish>& start) const;
  Boxed<scene::Finish> read_shared_finish(const Boxed<scene::Finish>& start);
  void read_reflection(scene::Finish& finish);
  scene::InteriorId read_interior();
  static void put_interior(scene::Object& object, scene::InteriorId interior);
  // ---- media.cpp
  scene::Media read_media(Span span);
  bool sampling_setting(scene::Media& media, const Token& token);
  void read_scattering(scene::Media& media);
  scene::Pigment read_density();
  void read_density_body(scene::Pigment& density, Token::Kind last);
  void start_density_pattern(scene::Pigment& density, std::uint32_t index, const Token& word);
  bool density_modifier(scene::Pigment& density, const Token& token);
  DensityMap read_density_map(bool weights);
  scene::InteriorId moved_interior(scene::InteriorId id, const Transform& by);
  Material read_material();
  Shared<CameraSpec> read_camera(Span span);
  scene::Camera finish_camera(const CameraSpec& spec);
  void read_global_settings(Span span);
  void read_background();
  scene::SkySphere read_sky_sphere(Span span);
  void read_radiosity(const Token& word);
  double read_radiosity_number(const Token& word, double lo, bool lo_excluded, double hi);
  void read_radiosity_count(scene::Radiosity& r, const Token& word);
  void check_reuse(scene::Radiosity& r, bool minimum_given, bool maximum_given, Span span);
  float read_importance(const Token& word);
  // ---- subsurface.cpp
  void read_subsurface(const Token& word);
  void read_translucency(scene::Finish& finish, const Token& word);
  // ---- photons.cpp
  void read_photons(const Token& word);
  void read_photon_file(scene::Photons& photons, const Token& word);
  void read_photon_radii(scene::Photons& photons);
  double read_photon_number(const Token& word, double least, bool least_excluded = false);
  void read_object_photons(scene::ObjectPhotons& photons, const Token& word);
  void settle_pass_through(scene::ObjectPhotons& photons, grammar::SymbolId last, Span span);
  void read_light_photons(scene::LightPhotons& photons, const Token& word);
  scene::Fog read_fog(Span span);
  bool fog_setting(scene::Fog& fog, const Token& token);
  scene::Rainbow read_rainbow(Span span);
  void check_rainbow(scene::Rainbow& rainbow, Span span);
  void read_max_trace_level(const Token& word);
  void read_assumed_gamma(const Token& word);
  void finish_settings();
  void finish();

  // ---- messages
  [[noreturn]] void fail(Code code, Span span, std::string message, std::string help = {},
                         std::string at = {});
  [[noreturn]] void fail(Diagnostic d);
  void warn(Code code, Span span, std::string message, std::string help = {});
  void add_trace(Diagnostic& d) const;

  // ---- recovery.cpp: several errors in one run
  static constexpr std::size_t no_reader = SIZE_MAX;
  [[nodiscard]] const ast::Flaw* flaw_at(Loc loc) const;
  [[nodiscard]] bool follows_from_earlier(const Diagnostic& d) const;
  void label_declaration(Diagnostic& d) const;
  void report(Diagnostic d);
  [[noreturn]] void stop_here(bool final);
  void poison(SymbolId name, std::uint32_t scope, bool overwrite);
  void poison_declared(const ast::Tree& tree, ast::Range items, bool locals, std::uint32_t scope);
  void poison_declared(const ast::Tree& tree, const ast::Directive& directive, bool locals,
                       std::uint32_t scope);
  void poison_what_is_skipped();
  [[nodiscard]] std::size_t resume_frame() const;
  bool recover(const Failure& failure);
  void skip_to_statement();

  void remember(const ast::Tree& tree);
  [[noreturn]] void not_supported(std::string_view feature, Span span);
  scene::OriginId origin(Span span);
  scene::OriginId call_origin();
  [[nodiscard]] std::string_view name_of(SymbolId id) const { return symbols_.text(id); }
  [[nodiscard]] int version() const { return declared_version_; }
  /// Before version 1.5 operands end where a factor ends: the shorter ways know nothing of that.
  [[nodiscard]] bool takes_shortcuts() const {
    return options_.shortcuts && declared_version_ >= 150;
  }

  SourceMap& sources_;
  FileId main_file_ = 0;
  const scene::Registry& registry_;
  const Options& options_;
  Diagnostics& diagnostics_;
  grammar::SymbolTable symbols_;
  Environment env_;

  std::vector<Frame> frames_;
  std::vector<Piece> pieces_;
  Value component_;  // what place() found last, if it was part of a vector
  std::vector<Slot*> arguments_;  // of macro calls whose scope is not open yet
  std::vector<Token> unread_;
  ast::Tree literal_tree_;  // the last few elements of long lists, as expressions
  std::uint32_t literal_slot_ = 0;
  std::size_t unread_base_ = 0;    // tokens below belong to an outer reader
  std::size_t declare_depth_ = 0;  // frames when the value of a #declare is being read
  std::size_t macro_depth_ = 0;
  std::size_t repeats_ = 0;  // loops and macros that are running: what they hold may come again
  std::uint64_t turns_ = 0;       // of loops, and macro calls
  std::uint64_t next_check_ = 0;  // turns at which the limits are looked at again
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::size_t nesting_ = 0;

  std::unordered_map<std::string, std::unique_ptr<const ast::Tree>> trees_;
  std::vector<std::unique_ptr<const ast::Tree>> main_trees_;
  std::vector<const ast::Tree*> tree_of_;  // by file
  std::vector<std::vector<Formula*>> formulas_of_;  // by file, expression
  std::deque<Formula> formulas_;
  std::vector<std::vector<std::unique_ptr<Statement>>> statements_of_;  // by file, first item
  Formula no_formula_;
  std::unordered_set<std::uint64_t> warned_;
  std::unordered_set<Loc> reported_;  // places of errors
  bool failed_ = false;               // an error has been reported: there will be no scene
  bool names_are_missing_ = false;    // a whole file could not be read
  std::size_t reading_depth_ = no_reader;  // frames when the statement being read began

  // Reserved word → index into the registry.
  std::unordered_map<SymbolId, std::uint32_t> primitive_words_;
  std::unordered_map<SymbolId, std::uint32_t> pattern_words_;
  std::unordered_map<SymbolId, std::uint32_t> warp_words_;
  std::unordered_map<SymbolId, std::uint32_t> param_words_;
  std::unordered_map<const scene::TypeInfo*, OperandPlan> operand_plans_;

  std::unordered_map<std::string, std::shared_ptr<Font>> fonts_;  // by name
  std::vector<std::uint32_t> streams_;  // states of rand()
  std::vector<Draw>* peek_ = nullptr;   // what the innermost Peek has seen drawn
  functions::Workspace workspace_;      // of calls of functions
  FormulaMachine machine_{env_, streams_, workspace_};
  scene::Scene scene_;
  std::map<std::string, PictureRead> pictures_;  // by path
  std::map<std::string, std::shared_ptr<const scene::Voxels>> voxels_;
  std::vector<std::uint16_t> object_depths_;  // by object: 1 + that of its deepest child
  scene::TextureId default_texture_ = scene::none;
  bool reading_default_ = false;  // a normal may have settings and no pattern yet
  /// Textures of one plain colour: objects that look alike share one.
  KnownLooks plain_textures_;
  std::unordered_map<const ast::Group*, bool> constant_;  // blocks, as far as known
  struct FinishKey {
    const ast::Group* block;
    const void* start;
    int version;
    friend auto operator<=>(const FinishKey&, const FinishKey&) = default;
  };
  struct KnownFinish {
    Boxed<scene::Finish> start;
    Boxed<scene::Finish> made;
  };
  std::map<FinishKey, KnownFinish> finishes_;
  scene::TextureId plain_base_ = scene::none;  // the last one that was found to be plain
  std::vector<double> operands_;  // of the primitive that is being read the quick way
  scene::TextureId own_texture_ = scene::none;  // made by the object statement being read
  std::shared_ptr<const CameraSpec> default_camera_;
  float default_importance_ = 1;  // of objects, for radiosity
  std::shared_ptr<const CameraSpec> camera_;
  int declared_version_ = 370;
  bool version_given_ = false;
  std::string_view version_source_ = " (no #version)";
  bool native_ = false;     // a `.scene`: 3.8 and linear colours unless it says otherwise
  bool additions_ = false;  // 3.8 is or was in force: there may be dictionaries
  bool assumed_gamma_given_ = false;
  /// What bytes above 127 in string literals mean (language §1.4).
  enum class Charset : std::uint8_t { ascii, utf8, system };
  Charset charset_ = Charset::ascii;
  Span last_span_;
};

}  // namespace durer::interpreter
