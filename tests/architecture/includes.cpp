// The house's one-way streets: which folder may include which, where a third party may enter, and
// which headers a folder shows to the others.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/catch.h"

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string_view>;

struct Folder {
  std::string_view name;
  Names may_include;  // besides itself
  Names shown;        // headers that others may include; empty: all
};

const std::vector<Folder> house{
    {"base", {}, {}},
    {"functions", {"base"}, {}},
    {"scene", {"base", "functions"}, {}},
    {"grammar", {"base"}, {"grammar/ast.h", "grammar/parse.h", "grammar/vocabulary.h"}},
    {"interpreter", {"base", "functions", "scene", "grammar"}, {"interpreter/interpret.h"}},
    {"image", {"base"}, {"image/image.h"}},
    {"tracer",
     {"base", "functions", "scene", "image"},
     {"tracer/compile.h", "tracer/object_queries.h", "tracer/render.h"}},
    {"cli",
     {"base", "functions", "scene", "grammar", "interpreter", "image", "tracer", "stdlib"},
     {}},
    {"stdlib", {"base"}, {}},
};

/// A library of others: where its headers may be named. A place is a file, or a folder with '/'.
struct Guest {
  std::string_view prefix;
  Names places;
};

const std::vector<Guest> guests{
    {"tao/",
     {"grammar/parse.cpp", "grammar/tokens.h", "grammar/expressions.h", "grammar/items.h",
      "grammar/directives.h", "grammar/messages.h", "grammar/actions.h"}},
    {"embree", {"tracer/accel/"}},
    {"tbb/", {"tracer/film/"}},
    {"oneapi/", {"tracer/film/"}},
    {"OpenImageIO/", {"image/"}},
    {"CLI/", {"cli/"}},
};

struct Include {
  std::string file;  // relative to the root
  std::string what;
  bool angled = false;
  int line = 0;
};

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

std::vector<std::string> sources() {
  std::vector<std::string> all;
  const fs::path root = DURER_SOURCE_DIR;
  for (const Folder& folder : house) {
    if (!fs::exists(root / folder.name)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder.name)) {
      if (is_source(entry.path())) all.push_back(fs::relative(entry.path(), root).generic_string());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Include> includes_of(const std::string& file) {
  std::vector<Include> all;
  std::ifstream in(fs::path(DURER_SOURCE_DIR) / file);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (text.rfind("#include ", 0) != 0) continue;
    const auto open = text.find_first_of("\"<");
    const auto close = text.find_last_of("\">");
    if (open == std::string::npos || close <= open) continue;
    all.push_back({file, text.substr(open + 1, close - open - 1), text[open] == '<', line});
  }
  return all;
}

std::string_view folder_of(std::string_view path) { return path.substr(0, path.find('/')); }
bool is_in(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}
std::string place(const Include& i) { return i.file + ":" + std::to_string(i.line) + " " + i.what; }

/// Every offence as a line of text, so that one run names them all.
template <typename Allowed>
std::vector<std::string> offences(Allowed&& allowed) {
  std::vector<std::string> all;
  for (const std::string& file : sources()) {
    for (const Include& i : includes_of(file)) {
      if (!allowed(i)) all.push_back(place(i));
    }
  }
  return all;
}

const Folder* find_folder(std::string_view name) {
  const auto at =
      std::find_if(house.begin(), house.end(), [name](const Folder& f) { return f.name == name; });
  return at == house.end() ? nullptr : &*at;
}

}  // namespace

TEST_CASE("architecture: folders include only those below them", "[architecture]") {
  REQUIRE(sources().size() > 50);
  const auto wrong = offences([](const Include& i) {
    if (i.angled) return true;
    const std::string_view from = folder_of(i.file);
    const std::string_view to = folder_of(i.what);
    return from == to || is_in(to, find_folder(from)->may_include);
  });
  CHECK(wrong == std::vector<std::string>{});
}

TEST_CASE("architecture: a folder's inner headers stay inside", "[architecture]") {
  const auto wrong = offences([](const Include& i) {
    const Folder* to = find_folder(folder_of(i.what));
    if (i.angled || to == nullptr || to->name == folder_of(i.file)) return true;
    return to->shown.empty() || is_in(i.what, to->shown);
  });
  CHECK(wrong == std::vector<std::string>{});
}

TEST_CASE("architecture: each third party has its place", "[architecture]") {
  const auto wrong = offences([](const Include& i) {
    return std::all_of(guests.begin(), guests.end(), [&](const Guest& guest) {
      if (i.what.rfind(guest.prefix, 0) != 0) return true;
      return std::any_of(guest.places.begin(), guest.places.end(), [&](std::string_view allowed) {
        return allowed.back() == '/' ? i.file.rfind(allowed, 0) == 0 : i.file == allowed;
      });
    });
  });
  CHECK(wrong == std::vector<std::string>{});
}

TEST_CASE("architecture: headers guard themselves and open no namespaces", "[architecture]") {
  std::vector<std::string> wrong;
  for (const std::string& file : sources()) {
    if (fs::path(file).extension() != ".h") continue;
    std::ifstream in(fs::path(DURER_SOURCE_DIR) / file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (text.find("#pragma once") == std::string::npos) wrong.push_back(file + " has no guard");
    if (text.find("\nusing namespace ") != std::string::npos) wrong.push_back(file + " opens");
  }
  CHECK(wrong == std::vector<std::string>{});
}
