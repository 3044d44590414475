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
    std::string_view operator()(const Boxed<scene::Pigment>&) const { return "a pigment"; }
    std::string_view operator()(const Boxed<scene::Finish>&) const { return "a finish"; }
    std::string_view operator()(const Boxed<scene::Normal>&) const { return "a normal"; }
    std::string_view operator()(const Shared<ColourMap>&) const { return "a colour map"; }
    std::string_view operator()(const Shared<NormalMap>&) const { return "a normal map"; }
    std::string_view operator()(const Shared<SlopeMap>&) const { return "a slope map"; }
    std::string_view operator()(const Shared<TextureMap>&) const { return "a texture map"; }
    std::string_view operator()(const Shared<Density>&) const { return "a density"; }
    std::string_view operator()(const Shared<DensityMap>&) const { return "a density map"; }
    std::string_view operator()(const Shared<scene::Media>&) const { return "a medium"; }
    std::string_view operator()(InteriorRef) const { return "an interior"; }
    std::string_view operator()(const Shared<Material>&) const { return "a material"; }
    std::string_view operator()(const Shared<Transform>&) const { return "a transform"; }
    std::string_view operator()(const Shared<CameraSpec>&) const { return "a camera"; }
    std::string_view operator()(const Shared<scene::SkySphere>&) const { return "a sky sphere"; }
    std::string_view operator()(const Shared<scene::Fog>&) const { return "a fog"; }
    std::string_view operator()(const Shared<scene::Rainbow>&) const { return "a rainbow"; }
    std::string_view operator()(const std::shared_ptr<DataFile>&) const { return "an open file"; }
    std::string_view operator()(const Shared<UserFunction>&) const { return "a function"; }
    std::string_view operator()(const Shared<functions::Spline>&) const { return "a spline"; }
    std::string_view operator()(const Shared<Unsupported>& u) const { return u->feature; }
    std::string_view operator()(const std::shared_ptr<Dictionary>&) const { return "a dictionary"; }
    std::string_view operator()(Poison) const { return "nothing"; }
  };
  return std::visit(Visitor{}, value.node);
}

Array* own_array(Value& v) {
  auto* array = v.get<std::shared_ptr<Array>>();
  if (array == nullptr) return nullptr;
  if (array->use_count() > 1) *array = std::make_shared<Array>(**array);
  return array->get();
}

Dictionary* own_dictionary(Value& v) {
  const auto* dictionary = v.get<std::shared_ptr<Dictionary>>();
  if (dictionary == nullptr) return nullptr;
  const bool sole =
      dictionary->use_count() == 1 && std::get<Shared<Thing>>(v.node).use_count() == 1;
  if (!sole) v = Value(std::make_shared<Dictionary>(**dictionary));
  return v.get<std::shared_ptr<Dictionary>>()->get();
}

int component_slot(grammar::SymbolId member) {
  namespace w = grammar::words;
  switch (member) {
    case w::x:
    case w::u:
    case w::red: return 0;
    case w::y:
    case w::v:
    case w::green: return 1;
    case w::z:
    case w::blue: return 2;
    case w::t:
    case w::filter: return 3;
    case w::transmit: return 4;
    default: return -1;
  }
}

bool same_alternative(const Value& a, const Value& b) {
  if (a.node.index() != b.node.index()) return false;
  const auto* x = std::get_if<Shared<Thing>>(&a.node);
  return x == nullptr || (*x)->index() == (*std::get_if<Shared<Thing>>(&b.node))->index();
}

namespace {

/// True if the value holds others that go with it.
bool owns_others(const Value& v) {
  if (const auto* array = v.get<std::shared_ptr<Array>>()) return array->use_count() == 1;
  const auto* dictionary = v.get<std::shared_ptr<Dictionary>>();
  return dictionary != nullptr && dictionary->use_count() == 1 &&
         std::get<Shared<Thing>>(v.node).use_count() == 1;
}

/// Arrays and dictionaries in one another are taken apart level by level: a loop may have put
/// millions inside each other, and destructors would call each other as deep.
void take_apart(std::vector<Value>& pending) {
  if (std::none_of(pending.begin(), pending.end(), owns_others)) return;
  while (!pending.empty()) {
    const Value v = std::move(pending.back());
    pending.pop_back();
    if (!owns_others(v)) continue;
    if (const auto* array = v.get<std::shared_ptr<Array>>()) {
      std::vector<Value>& elements = (*array)->elements;
      std::move(elements.begin(), elements.end(), std::back_inserter(pending));
      elements.clear();
    } else {
      auto& entries = (*v.get<std::shared_ptr<Dictionary>>())->entries;
      for (auto& [key, value] : entries) pending.push_back(std::move(value));
      entries.clear();
    }
  }
}

}  // namespace

Dictionary::~Dictionary() {
  std::vector<Value> values;
  for (auto& [key, value] : entries) values.push_back(std::move(value));
  take_apart(values);
}

Array::~Array() { take_apart(elements); }

}  // namespace durer::interpreter
