#include "image/oiio_file.h"

#include <dlfcn.h>

#include <filesystem>
#include <mutex>

#include "image/oiio_module.h"

namespace durer::image {
namespace {

namespace fs = std::filesystem;

/// The module lies in lib/durer of a folder above the program: of the build, or of where it is
/// installed.
fs::path module_path() {
  std::error_code error;
  fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int level = 0; level < 5 && !error; ++level) {
    const fs::path candidate = folder / "lib" / "durer" / "durer_openimageio.so";
    if (fs::exists(candidate, error)) return candidate;
    folder = folder.parent_path();
  }
  return "durer_openimageio.so";
}

struct Loaded {
  const OiioModule* module = nullptr;
  std::string error;
};

/// Loads the module once; it stays.
const Loaded& module() {
  static Loaded loaded;
  static std::once_flag once;
  std::call_once(once, [] {
    void* const handle = ::dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle != nullptr) {
      loaded.module = static_cast<const OiioModule*>(::dlsym(handle, "durer_oiio_module"));
    }
    if (loaded.module == nullptr) {
      const char* why = ::dlerror();
      loaded.error =
          std::string("the OpenImageIO module cannot be loaded: ") + (why != nullptr ? why : "");
    }
  });
  return loaded;
}

}  // namespace

Encoded file_of_codes(const char* plugin, const Image& size, const Codes& codes,
                      Attributes attributes) {
  const Loaded& m = module();
  if (m.module == nullptr) return {.bytes = {}, .error = m.error};
  return m.module->codes(plugin, size, codes, std::move(attributes));
}

Encoded file_of_samples(const char* plugin, const Image& size, const Samples& samples, bool half,
                        Attributes attributes) {
  const Loaded& m = module();
  if (m.module == nullptr) return {.bytes = {}, .error = m.error};
  return m.module->samples(plugin, size, samples, half, std::move(attributes));
}

PictureRead picture_of_file(const std::string& path, const std::string& kind) {
  const Loaded& m = module();
  if (m.module == nullptr) return {nullptr, m.error};
  return m.module->read(path, kind);
}

Attributes curve_attributes(const GammaCurve& curve) {
  switch (curve.kind) {
    case GammaCurve::Kind::linear: return {{"oiio:ColorSpace", "Linear"}};
    case GammaCurve::Kind::srgb: return {{"oiio:ColorSpace", "sRGB"}};
    case GammaCurve::Kind::power: break;
  }
  return {{"oiio:ColorSpace", "GammaCorrected"}, {"oiio:Gamma", curve.gamma}};
}

}  // namespace durer::image
