#include "interpreter/value.h"

#include <algorithm>
#include <iterator>

namespace durer::interpreter {

std::string_view kind_name(const Value& value) {
  struct Visitor {
    std::string_view operator()(std::monostate) const { return "nothing"; }
    std::string_view operator()(const Num& n) const {
      switch (n.length) {
        case 1: return "a float";
        case 2: return "a uv-vector";
        case 3: return "a vector";
        case 4: return "a four-vector";
        default: return "a colour";
      }
    }
    std::string_view operator()(const Shared<Text>&) const { return "a string"; }
    std::string_view operator()(const std::shared_ptr<Array>&) const { return "an array"; }
    std::string_view operator()(MacroRef) const { return "a macro"; }
    std::string_view operator()(const Shared<Thing>& thing) const {
      return std::visit(*this, *thing);
    }
    std::string_view operator()(ObjectRef) const { return "an object"; }
    std::string_view operator()(TextureRef) const { return "a texture"; }
    std::string_view operator()(const Shared<scene::Pigment>&) const { return "a pigment"; }
    std::string_view operator()(const Shared<scene::Finish>&) const { return "a finish"; }
    std::string_view operator()(const Shared<scene::Normal>&) const { return "a normal"; }
    std::string_view operator()(const Shared<ColourMap>&) const { return "a colour map"; }
    std::string_view operator()(const Shared<NormalMap>&) const { return "a normal map"; }
    std::string_view operator()(const Shared<SlopeMap>&) const { return "a slope map"; }
    std::string_view operator()(const Shared<TextureMap>&) const { return "a texture map"; }
    std::string_view operator()(InteriorRef) const { return "an interior"; }
    std::string_view operator()(const Shared<Material>&) const { return "a material"; }
    std::string_view operator()(const Shared<Transform>&) const { return "a transform"; }
    std::string_view operator()(const Shared<CameraSpec>&) const { return "a camera"; }
    std::string_view operator()(const Shared<scene::SkySphere>&) const { return "a sky sphere"; }
    std::string_view operator()(const std::shared_ptr<DataFile>&) const { return "an open file"; }
    std::string_view operator()(const Shared<UserFunction>&) const { return "a function"; }
    std::string_view operator()(const Shared<functions::Spline>&) const { return "a spline"; }
    std::string_view operator()(const Shared<Unsupported>& u) const { return u->feature; }
    std::string_view operator()(const std::shared_ptr<Dictionary>&) const { return "a dictionary"; }
    std::string_view operator()(Poison) const { return "nothing"; }
  };
  return std::visit(Visitor{}, value.node);
}

bool same_alternative(const Value& a, const Value& b) {
  if (a.node.index() != b.node.index()) return false;
  const auto* x = std::get_if<Shared<Thing>>(&a.node);
  return x == nullptr || (*x)->index() == (*std::get_if<Shared<Thing>>(&b.node))->index();
}

namespace {
/// Arrays of arrays are taken apart level by level: a loop may have put millions inside one another,
/// and destructors would call each other as deep.
void take_apart(std::vector<Value>& pending) {
  const auto inner = [](Value& v) -> std::vector<Value>* {
    auto* array = v.get<std::shared_ptr<Array>>();
    return array != nullptr && array->use_count() == 1 ? &(*array)->elements : nullptr;
  };
  if (std::none_of(pending.begin(), pending.end(), [&](Value& v) { return inner(v) != nullptr; })) {
    return;
  }
  while (!pending.empty()) {
    Value v = std::move(pending.back());
    pending.pop_back();
    if (std::vector<Value>* elements = inner(v)) {
      std::move(elements->begin(), elements->end(), std::back_inserter(pending));
      elements->clear();
    }
  }
}
}  // namespace

Array::~Array() { take_apart(elements); }

}  // namespace durer::interpreter
