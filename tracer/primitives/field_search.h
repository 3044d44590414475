// Where a line meets the zeros of a function field: no root is missed, and none is looked for where
// bounds say that there is none.
#pragma once

#include <array>
#include <optional>

#include "tracer/primitives/container.h"
#include "tracer/primitives/crossing.h"
#include "tracer/primitives/function_field.h"

namespace durer::tracer {

/// One search along one line. Crossings come in ascending order; each depends on the line and the
/// field only, not on the range that is asked for.
class FieldSearch {
 public:
  /// Looks for t_from <= t < t_to, in units of |ray.d|. Parts of the surface shorter than `least`
  /// (object units) along the line may be overlooked, if the line only grazes them.
  FieldSearch(const FunctionField& field, const Ray& ray, double t_from, double t_to, double least);

  /// Calls take(t, sign) for each change of sign inside the stretch, `sign` being the one that
  /// follows (+1: outside), and once at its beginning, if the range holds it. It returns true to
  /// end the search. The sign at the end is the result; 0 if it was not reached.
  template <typename Take>
  int run(const Stretch& stretch, Take take) {
    begin(stretch, take);
    if (stretch.to <= t_from_ || stretch.from >= t_to_) return 0;
    walk(stretch.from, stretch.to);
    return done_ ? 0 : sign_;
  }
  /// The same between two places of the line, where the function has values `from` and `to` (less
  /// the threshold), if along the line its slope is within `slope`. `sign`: what is known to hold in
  /// front, else 0.
  template <typename Take>
  int run_between(const Stretch& stretch, double from, double to, Interval slope, int sign,
                  Take take) {
    begin(stretch, take);
    sign_ = sign;
    started_ = sign != 0;
    follow(*field_.function());
    settle(from <= 0 ? -1 : 1, stretch.from);
    if (!done_) resolve({stretch.from, from, stretch.to, to, slope});
    return done_ ? 0 : sign_;
  }

 private:
  template <typename Take>
  void begin(const Stretch& stretch, Take& take) {
    stretch_ = stretch;
    context_ = &take;
    take_ = [](void* context, double t, int sign) {
      return (*static_cast<Take*>(context))(t, sign);
    };
  }
  /// From now on, values are those of `tape`.
  void follow(const functions::Function& tape) {
    if (tape_ == &tape) return;
    tape_ = &tape;
    evaluator_.emplace(tape, workspace_);
  }
  /// A sign that is known to hold from t on.
  void settle(int sign, double t);
  [[nodiscard]] double value(double t);
  /// The linear function of a cell along the line, at + t · slope, and its error.
  struct Line {
    double at, slope, error;
  };
  [[nodiscard]] Line line_in(const FieldCell& cell) const;
  [[nodiscard]] bool grazes(const FieldDetail& cell, const Line& line) const;
  [[nodiscard]] bool enter(const FieldCell& cell, FieldLink& link, double t0, double t1);
  void examine(const FieldDetail& cell, const Line& line, double t0, double t1);
  struct Band {
    double begin, end;  // where a root may lie
    double limit;       // the same as `end`, if the cell went on
    double middle;      // where it is likely
    double slope;       // likely slope along the line
    bool empty;
  };
  Band clip(const Line& line, double t0, double t1);
  /// Part of the line with the values at its ends and the slopes between them.
  struct Piece {
    double a, ga;
    double b, gb;
    Interval slope;
  };
  void resolve(Piece piece);
  [[nodiscard]] static bool stays_clear(const Piece& piece);
  struct Rise {
    double begin, end;     // where to look
    double limit;          // the root, if there is one, lies before
    double first;          // first guess
    double slope, spread;  // of the function along the line, times `direction`
    double direction;      // +1 if it rises
  };
  [[nodiscard]] std::optional<double> solve(const Rise& rise);
  [[nodiscard]] double bracketed_root(const Piece& piece);

  void walk(double t0, double t1);
  void report(double t, int sign) { done_ = done_ || take_(context_, t, sign); }

  const FunctionField& field_;
  Ray ray_;
  dvec3 from_centre_;  // of the field to the origin of the line
  double t_from_;
  double t_to_;
  double least_;  // along the line, in units of |d|
  double fine_;   // what counts as nothing, likewise
  functions::Workspace& workspace_;
  const functions::Function* tape_ = nullptr;
  std::optional<functions::Evaluator<double>> evaluator_;
  /// The value at the end of the last piece, where the next one may begin.
  double last_t_ = std::numeric_limits<double>::quiet_NaN();
  double last_g_ = 0;
  const functions::Function* last_tape_ = nullptr;
  Stretch stretch_{};
  bool (*take_)(void* context, double t, int sign) = nullptr;
  void* context_ = nullptr;
  int sign_ = 0;  // in front of what comes next; 0: not known
  bool started_ = false;
  bool done_ = false;
};

}  // namespace durer::tracer
