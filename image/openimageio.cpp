// The module that holds OpenImageIO. It is loaded when a picture needs it (oiio_file.cpp): the
// library brings some 250 others along, a fifth of a second and a hundred megabytes at every start.
#include "image/oiio_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>

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

template <typename Sample>
bool take(OIIO::ImageInput& in, int channels, OIIO::TypeDesc type, std::vector<Sample>& out) {
  out.resize(in.spec().image_pixels() * static_cast<std::size_t>(channels));
  return in.read_image(0, 0, 0, channels, type, out.data());
}

/// Bytes of RGBE files stand for the middle of an interval; OpenImageIO takes its lower end.
void centre_mantissas(Picture& picture) {
  for (std::size_t i = 0; i + 2 < picture.samples.size(); i += picture.channels) {
    float* const c = &picture.samples[i];
    const float most = std::max({c[0], c[1], c[2]});
    if (!(most > 0)) continue;
    int exponent = 0;
    std::frexp(most, &exponent);
    const float half = std::ldexp(0.5F, exponent - 8);
    for (int k = 0; k < 3; ++k) c[k] += half;
  }
}

/// TIFF files are read as libtiff shows them: in bytes, multiplied by alpha.
void as_premultiplied_bytes(Picture& picture, bool straight) {
  if (picture.bits == 16) {
    for (std::uint16_t& c : picture.codes) c = static_cast<std::uint16_t>((c + 128U) / 257U);
    picture.bits = 8;
  }
  if (picture.channels % 2 != 0) return;
  picture.premultiplied = true;
  if (!straight) return;
  const std::size_t n = picture.channels;
  for (std::size_t i = 0; i + n <= picture.codes.size(); i += n) {
    const unsigned alpha = picture.codes[i + n - 1];
    for (std::size_t k = i; k + 1 < i + n; ++k) {
      picture.codes[k] = static_cast<std::uint16_t>((picture.codes[k] * alpha + 127) / 255);
    }
  }
}

PictureRead read_file(const std::string& path, const std::string& kind) {
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);  // do not multiply
  as_stored.attribute("oiio:RawColor", 1);
  auto in = OIIO::ImageInput::open(path, &as_stored);
  if (!in && !kind.empty()) {
    in = OIIO::ImageInput::create(kind);
    OIIO::ImageSpec found;
    if (in && !in->open(path, found, as_stored)) return {nullptr, failure(in->geterror()).error.value_or("")};
  }
  if (!in) return {nullptr, failure(OIIO::geterror()).error.value_or("")};
  const OIIO::ImageSpec& spec = in->spec();
  auto picture = std::make_shared<Picture>();
  picture->width = static_cast<std::uint32_t>(spec.width);
  picture->height = static_cast<std::uint32_t>(spec.height);
  const int channels = std::clamp(spec.nchannels, 1, 4);
  picture->channels = static_cast<std::uint32_t>(channels);
  bool whole = false;
  if (spec.format.is_floating_point()) {
    picture->bits = 32;
    whole = take(*in, channels, OIIO::TypeDesc::FLOAT, picture->samples);
  } else if (spec.format.basesize() > 1) {
    picture->bits = 16;
    whole = take(*in, channels, OIIO::TypeDesc::UINT16, picture->codes);
  } else {
    std::vector<std::uint8_t> bytes;
    whole = take(*in, channels, OIIO::TypeDesc::UINT8, bytes);
    picture->codes.assign(bytes.begin(), bytes.end());
  }
  if (!whole) return {nullptr, failure(in->geterror()).error.value_or("")};
  const std::string_view format = in->format_name();
  if (format == "hdr") centre_mantissas(*picture);
  if (format == "openexr") picture->premultiplied = channels % 2 == 0;
  if (format == "tiff" && !picture->is_real()) {
    as_premultiplied_bytes(*picture, spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0);
  }
  return {std::move(picture), {}};
}

}  // namespace
}  // namespace durer::image

extern "C" const durer::image::OiioModule durer_oiio_module;
const durer::image::OiioModule durer_oiio_module = {durer::image::codes_file,
                                                    durer::image::samples_file,
                                                    durer::image::read_file};
