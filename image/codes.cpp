#include "image/codes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/colour.h"
#include "image/code_table.h"

namespace durer::image {

namespace {

// In single precision throughout: then all 65,536 values of a 16-bit ramp get the oracle's codes;
// with a double product one in five hundred differs by one.
float greatest_code(Depth depth) { return static_cast<float>((1U << depth.bits) - 1); }

float clamped(float x) { return x > 0 ? std::min(x, 1.0F) : 0.0F; }  // NaN → 0

unsigned rounded(float stored_value, Depth depth) {
  return static_cast<unsigned>(std::floor(clamped(stored_value) * greatest_code(depth) + 0.5F));
}

std::uint16_t widened(unsigned code, Depth depth) {
  if (depth.bits == depth.sample_bits) return static_cast<std::uint16_t>(code);
  const int shift = depth.sample_bits - depth.bits;
  return static_cast<std::uint16_t>(code << shift | code >> (depth.bits - shift));
}

/// One channel of a pixel. `to_file` and `to_working` are the curve and its reverse.
template <typename ToFile, typename ToWorking>
std::uint16_t code_of(float c, int channel, Depth depth, Ditherer& dither, ToFile to_file,
                      ToWorking to_working) {
  if (dither.idle()) return widened(rounded(to_file(c), depth), depth);
  const float max = greatest_code(depth);
  c += dither.offset(channel);
  const unsigned code = rounded(to_file(c) + dither.threshold() / max, depth);
  dither.spread(channel, clamped(c) - to_working(static_cast<float>(code) / max));
  return widened(code, depth);
}

glm::vec3 rgb_of(std::span<const float, 4> pixel) { return {pixel[0], pixel[1], pixel[2]}; }

/// Alpha as it goes into the file: highlights on glass stay visible (shading §1.7, step 1).
float lifted_alpha(float alpha, float luminance) {
  return luminance > alpha ? std::min(1.0F, luminance) : alpha;
}

}  // namespace

Depth depth_for(int bits) { return {bits, bits <= 8 ? 8 : 16}; }

GammaCurve stored_curve(const Encoding& encoding) {
  return encoding.encode ? encoding.file : GammaCurve::srgb();
}

float stored(const Encoding& encoding, float working) {
  return encoding.encode ? transcode(encoding.working, encoding.file, working) : working;
}

float working(const Encoding& encoding, float stored) {
  return encoding.encode ? transcode(encoding.file, encoding.working, stored) : stored;
}

Coder::Coder(const Image& image, const Encoding& encoding, Depth depth, bool alpha)
    : image_(&image),
      encoding_(encoding),
      depth_(depth),
      alpha_(alpha),
      colours_(encoding.greyscale ? 1 : 3),
      dither_(encoding.dither, image.width) {
  constexpr std::size_t worth_a_table = 50'000;  // numbers of a picture
  if (dither_.idle() && depth.bits == 8 && image.pixels.size() > worth_a_table) {
    table_ = std::make_unique<const CodeTable>(
        [&](float v) { return rounded(stored(encoding, v), depth); });
    if (!table_->exact()) table_.reset();
  }
}

Coder::~Coder() = default;

void Coder::row(int y, std::span<std::uint16_t> out) {
  each_code(y, [next = out.data()](unsigned code) mutable {
    *next++ = static_cast<std::uint16_t>(code);
  });
}

void Coder::row_bytes(int y, std::span<unsigned char> out) {
  unsigned char* next = out.data();
  if (depth_.sample_bits == 8) {
    each_code(y, [next](unsigned code) mutable { *next++ = static_cast<unsigned char>(code); });
  } else {
    each_code(y, [next](unsigned code) mutable {
      *next++ = static_cast<unsigned char>(code >> 8);
      *next++ = static_cast<unsigned char>(code & 0xFF);
    });
  }
}

template <typename Put>
void Coder::each_code(int y, Put put) {
  if (table_ && colours_ == 3 && !alpha_) {
    const CodeTable& table = *table_;
    const float* pixel = image_->at(0, y).data();
    glm::vec3 last(0.0F);
    std::array<unsigned, 3> codes{};  // of `last`
    for (int x = 0; x < image_->width; ++x, pixel += 4) {
      const glm::vec3 here(pixel[0], pixel[1], pixel[2]);
      if (here != last || x == 0) {  // much of many a picture is flat
        last = here;
        for (int i = 0; i < 3; ++i) codes[i] = table.code_of(here[i]);
      }
      for (const unsigned code : codes) put(code);
    }
    return;
  }
  const auto to_file = [this](float v) { return stored(encoding_, v); };
  const auto to_working = [this](float v) { return working(encoding_, v); };
  const auto as_it_is = [](float v) { return v; };
  for (int x = 0; x < image_->width; ++x) {
    if (!dither_.idle()) dither_.enter(x, y);
    const auto pixel = image_->at(x, y);
    glm::vec3 c = rgb_of(pixel);
    const float luminance = grey(c);
    const float a = lifted_alpha(pixel[3], luminance);
    if (encoding_.greyscale) c = glm::vec3(luminance);
    if (alpha_) c /= a == 0 ? 1e-6F : a;
    for (int i = 0; i < colours_; ++i) {
      put(table_ ? table_->code_of(c[i]) : code_of(c[i], i, depth_, dither_, to_file, to_working));
    }
    if (alpha_) put(code_of(a, colours_, depth_, dither_, as_it_is, as_it_is));
  }
}

Codes to_codes(const Image& image, const Encoding& encoding, Depth depth, bool alpha) {
  Coder coder(image, encoding, depth, alpha);
  const std::size_t samples = static_cast<std::size_t>(image.width) * coder.channels();
  Codes out{.channels = coder.channels(), .sample_bits = depth.sample_bits, .values = {}};
  out.values.resize(samples * image.height);
  for (int y = 0; y < image.height; ++y) {
    coder.row(y, std::span(out.values).subspan(samples * y, samples));
  }
  return out;
}

Samples to_linear(const Image& image, const Encoding& encoding, bool greyscale, bool alpha) {
  const GammaCurve curve = encoding.encode ? encoding.working : GammaCurve::srgb();
  const int colours = greyscale ? 1 : 3;
  Samples out{.channels = colours + (alpha ? 1 : 0), .values = {}};
  out.values.reserve(image.pixels.size() / 4 * out.channels);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = image.at(x, y);
      glm::vec3 c = rgb_of(pixel);
      if (greyscale) c = glm::vec3(grey(c));
      c = curve.decode(c);
      for (int i = 0; i < colours; ++i) out.values.push_back(c[i]);
      if (alpha) out.values.push_back(pixel[3]);
    }
  }
  return out;
}

}  // namespace durer::image
