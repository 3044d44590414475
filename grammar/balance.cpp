#include "grammar/balance.h"

#include <fmt/format.h>

#include <algorithm>

namespace durer::grammar {
namespace {

char partner(char bracket) {
  switch (bracket) {
    case '{': return '}';
    case '(': return ')';
    case '[': return ']';
    case '}': return '{';
    case ')': return '(';
    default: return '[';
  }
}

}  // namespace

void Balance::open(char bracket, std::size_t at) { marks_.push_back({bracket, at, false}); }

void Balance::close(char bracket, std::size_t at) {
  Region& region = regions_.back();
  const char wanted = partner(bracket);
  std::size_t i = marks_.size();
  while (i > region.first_mark && marks_[i - 1].bracket != wanted) --i;
  if (i > region.first_mark) {
    while (marks_.size() > i) {
      leave_open(marks_.back(), span(at, 1));
      marks_.pop_back();
    }
    if (marks_.back().borrowed) {
      strays_.push_back(at);
    } else if (bracket == '}' && suspect_.begin == 0) {
      compare_indentation(marks_.back().at, at);
    }
    marks_.pop_back();
    return;
  }
  strays_.push_back(at);
  if (region.kind != Kind::file) {
    region.closes += bracket;
  } else if (bracket != '}' || (last_unknown_call_ == 0 && !included_)) {
    report(span(at, 1), fmt::format("no matching `{}`", wanted), "closes nothing");
  }
}

// An opening bracket turns out to have no partner.
void Balance::leave_open(const Mark& mark, Span noticed) {
  if (mark.borrowed) return;
  strays_.push_back(mark.at);
  if (regions_.back().kind != Kind::file) return;
  if (mark.bracket == '{' && (last_unknown_call_ > mark.at || included_)) return;
  const char missing = partner(mark.bracket);
  Diagnostic& d = report(noticed, fmt::format("no matching `{}`", missing),
                         fmt::format("expected `{}` before this", missing),
                         {span(mark.at, 1), fmt::format("this `{}` is still open", mark.bracket)});
  if (mark.bracket == '{' && suspect_.begin > d.labels[0].span.begin) {
    d.labels.push_back({suspect_, "the `}` that closes this one is indented otherwise"});
  }
}

// A missing brace shows in the indentation long before the end of the file.
void Balance::compare_indentation(std::size_t open, std::size_t close) {
  constexpr std::size_t far = 200;  // a line that long is not indented by hand
  const auto line_of = [this](std::size_t at) {
    std::size_t start = at;
    while (start > 0 && at - start < far && text_[start - 1] != '\n') --start;
    return text_.substr(start, at - start);
  };
  const std::string_view before_close = line_of(close);
  const std::string_view before_open = line_of(open);
  if (before_close.data() == before_open.data()) return;
  const std::size_t indent = before_open.find_first_not_of(" \t");
  const bool alone = before_close.find_first_not_of(" \t") == std::string_view::npos;
  const bool blank = indent == std::string_view::npos;
  if (!alone || before_close == before_open.substr(0, blank ? before_open.size() : indent)) return;
  suspect_ = span(open, 1);
}

void Balance::directive(std::string_view word, std::size_t at, std::size_t size) {
  const Span here = span(at, size);
  if (word == "if" || word == "ifdef" || word == "ifndef") {
    begin(Kind::conditional, here);
  } else if (word == "switch") {
    begin(Kind::switch_, here);
  } else if (word == "while" || word == "for") {
    begin(Kind::loop, here);
  } else if (word == "macro") {
    begin(Kind::macro, here);
  } else if (word == "else" || word == "elseif") {
    next_branch(Kind::conditional, word, here);
  } else if (word == "case" || word == "range") {
    next_branch(Kind::switch_, word, here);
  } else if (word == "end") {
    end(here);
  } else if (word == "include") {
    last_unknown_call_ = at + 1;
  }
}

void Balance::begin(Kind kind, Span head) {
  Region region;
  region.kind = kind;
  region.head = head;
  region.first_mark = marks_.size();
  regions_.push_back(std::move(region));
}

void Balance::next_branch(Kind expected, std::string_view word, Span at) {
  Region& region = regions_.back();
  const bool fits = region.kind == expected || (word == "else" && region.kind == Kind::switch_);
  if (!fits) {
    report(at,
           fmt::format("`#{}` without `#{}`", word, expected == Kind::switch_ ? "switch" : "if"),
           {}, {region.head, "the innermost open directive"});
    return;
  }
  end_branch(region);
}

// The branch with the greatest effect stands for all: usually there is one, or one of two branches
// is absent, or they agree.
void Balance::end_branch(Region& region) {
  Effect effect{std::move(region.closes), {}};
  region.closes.clear();
  while (marks_.size() > region.first_mark) {
    const Mark& mark = marks_.back();
    effect.opens += mark.bracket;
    leave_open(mark, {});
    marks_.pop_back();
  }
  std::reverse(effect.opens.begin(), effect.opens.end());
  if (effect.size() > region.effect.size()) region.effect = std::move(effect);
}

void Balance::end(Span at) {
  if (regions_.size() == 1) {
    report(at, "`#end` without a directive to end", {});
    return;
  }
  end_branch(regions_.back());
  const Region region = std::move(regions_.back());
  regions_.pop_back();
  if (region.kind == Kind::macro) {
    macros_[region.macro] = region.effect;
    return;
  }
  apply(region.effect, at.begin - base_);
  // A loop may do so any number of times.
  if (region.kind == Kind::loop && region.effect.size() > 0) last_unknown_call_ = at.begin + 1;
}

void Balance::apply(const Effect& effect, std::size_t at) {
  for (const char bracket : effect.closes) apply_close(bracket);
  for (const char bracket : effect.opens) marks_.push_back({bracket, at, true});
}

void Balance::apply_close(char bracket) {
  Region& region = regions_.back();
  if (marks_.size() == region.first_mark || marks_.back().bracket != partner(bracket)) {
    if (region.kind != Kind::file) region.closes += bracket;
    return;
  }
  if (!marks_.back().borrowed) strays_.push_back(marks_.back().at);
  marks_.pop_back();
}

void Balance::call(std::string_view name, std::size_t at) {
  const SymbolId id = symbols_->find(name);
  if (id != SymbolTable::none && symbols_->reserved(id)) return;
  const auto known = macros_.find(name);
  if (known == macros_.end()) {
    last_unknown_call_ = at + 1;
  } else if (known->second.size() > 0) {
    apply(known->second, at);
  }
}

bool Balance::finish(std::size_t size) {
  const Span end_of_file = span(size, 0);
  while (regions_.size() > 1) {
    const Region& region = regions_.back();
    report(end_of_file, "no matching `#end`", "expected `#end` before the end of the file",
           {region.head, "this directive is still open"});
    marks_.resize(region.first_mark);
    regions_.pop_back();
  }
  while (!marks_.empty()) {
    leave_open(marks_.back(), end_of_file);
    marks_.pop_back();
  }
  std::sort(strays_.begin(), strays_.end());
  for (Diagnostic& d : found_) diagnostics_->report(std::move(d));
  return found_.empty();
}

bool Balance::is_stray(std::size_t at) const {
  return std::binary_search(strays_.begin(), strays_.end(), at);
}

Diagnostic& Balance::report(Span at, std::string message, std::string words, Label related) {
  Diagnostic d;
  d.code = Code::unbalanced;
  d.span = at;
  d.message = std::move(message);
  d.at = std::move(words);
  if (related.span.begin != 0) d.labels.push_back(std::move(related));
  constexpr std::size_t enough = 20;
  if (found_.size() == enough) found_.pop_back();
  return found_.emplace_back(std::move(d));
}

}  // namespace durer::grammar
