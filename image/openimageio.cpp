// The module that holds OpenImageIO. It is loaded when a picture needs it (oiio_file.cpp): the
// library brings some 250 others along, a fifth of a second and a hundred megabytes at every start.
#include "image/oiio_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace durer::image {
namespace {

OIIO::ImageSpec spec_for(const Image& size, int channels, OIIO::TypeDesc type,
                         const Attributes& attributes) {
  OIIO::ImageSpec spec(size.width, size.height, channels, type);
  spec.alpha_channel = channels % 2 == 0 ? channels - 1 : -1;
  for (const auto& [name, value] : attributes) {
    std::visit([&, &key = name](const auto& v) { spec.attribute(key, v); }, value);
  }
  return spec;
}

Encoded failure(std::string reason) {
  while (!reason.empty() && reason.back() == '\n') reason.pop_back();
  return {.bytes = {}, .error = std::move(reason)};
}

/// `type` is that of `samples`; the file's own stands in `spec`.
Encoded to_bytes(const char* plugin, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                 const void* samples) {
  const auto out = OIIO::ImageOutput::create(plugin);
  if (!out) return failure(OIIO::geterror());
  Encoded file;
  OIIO::Filesystem::IOVecOutput memory(file.bytes);
  out->set_ioproxy(&memory);
  // The name is never opened; some formats look at its extension.
  if (!out->open(std::string("picture.") + plugin, spec)) return failure(out->geterror());
  if (!out->write_image(type, samples)) return failure(out->geterror());
  if (!out->close()) return failure(out->geterror());
  return file;
}

Encoded codes_file(const char* plugin, const Image& size, const Codes& codes,
                   Attributes attributes) {
  attributes.emplace_back("oiio:UnassociatedAlpha", 1);  // ours is: do not divide again
  if (codes.sample_bits == 16) {
    const auto spec = spec_for(size, codes.channels, OIIO::TypeDesc::UINT16, attributes);
    return to_bytes(plugin, spec, spec.format, codes.values.data());
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(codes.values.size());
  for (const std::uint16_t v : codes.values) bytes.push_back(static_cast<std::uint8_t>(v));
  const auto spec = spec_for(size, codes.channels, OIIO::TypeDesc::UINT8, attributes);
  return to_bytes(plugin, spec, spec.format, bytes.data());
}

Encoded samples_file(const char* plugin, const Image& size, const Samples& samples, bool half,
                     Attributes attributes) {
  attributes.emplace_back("oiio:ColorSpace", "Linear");
  const auto type = half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
  const auto spec = spec_for(size, samples.channels, type, attributes);
  return to_bytes(plugin, spec, OIIO::TypeDesc::FLOAT, samples.values.data());
}

}  // namespace
}  // namespace durer::image

extern "C" const durer::image::OiioModule durer_oiio_module;
const durer::image::OiioModule durer_oiio_module = {durer::image::codes_file,
                                                    durer::image::samples_file};
