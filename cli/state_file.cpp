// The format, numbers in the byte order of the machine: `Header`, a byte for each block (1: done),
// then the four floats of every pixel in rows from the top (0 in blocks that are not done), then a
// hash of all before it.
#include "cli/state_file.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "scene/dump.h"

namespace durer::cli {
namespace {

/// FNV-1a over words of eight bytes. It tells accidents, not attacks.
class Hash {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (; size >= 8; bytes += 8, size -= 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes, 8);
      mix(word);
    }
    for (; size > 0; ++bytes, --size) mix(*bytes);
  }
  template <typename T>
  void add(const T& value) {
    add(&value, sizeof value);
  }
  [[nodiscard]] std::uint64_t value() const { return h_; }

 private:
  void mix(std::uint64_t word) {
    h_ = (h_ ^ word) * 0x100000001B3U;
    h_ ^= h_ >> 29;
  }
  std::uint64_t h_ = 0xCBF29CE484222325U;
};

struct Header {
  char magic[16] = "durer state  1\n";
  std::uint64_t fingerprint = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint64_t blocks = 0;
};

std::uint64_t hash_of(const std::vector<unsigned char>& bytes, std::size_t size) {
  Hash hash;
  hash.add(bytes.data(), size);
  return hash.value();
}

template <typename T>
void append(std::vector<unsigned char>& bytes, const T* data, std::size_t count) {
  const auto* first = reinterpret_cast<const unsigned char*>(data);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

constexpr const char* damaged = "is damaged";

std::optional<std::string> decode(const std::vector<unsigned char>& bytes,
                                  std::uint64_t fingerprint, tracer::Checkpoint::State& state) {
  Header header;
  const Header expected;
  std::uint64_t stored = 0;
  if (bytes.size() < sizeof header + sizeof stored) return damaged;
  std::memcpy(&header, bytes.data(), sizeof header);
  std::memcpy(&stored, &bytes[bytes.size() - sizeof stored], sizeof stored);
  if (std::memcmp(header.magic, expected.magic, sizeof header.magic) != 0) {
    return "is not a state file of this version";
  }
  if (stored != hash_of(bytes, bytes.size() - sizeof stored)) return damaged;
  if (header.fingerprint != fingerprint) return "belongs to another scene or other options";
  state.done.resize(header.blocks);
  state.image = image::Image(static_cast<int>(header.width), static_cast<int>(header.height));
  const std::size_t pixels = state.image.pixels.size() * sizeof(float);
  if (bytes.size() != sizeof header + header.blocks + pixels + sizeof stored) return damaged;
  std::memcpy(state.done.data(), &bytes[sizeof header], header.blocks);
  std::memcpy(state.image.pixels.data(), &bytes[sizeof header + header.blocks], pixels);
  return std::nullopt;
}

}  // namespace

std::string state_path(const std::string& output) {
  return output.empty() || output == "-" ? "" : output + ".state";
}

std::uint64_t fingerprint(const scene::Scene& scene, const scene::Registry& registry,
                          const tracer::RenderOptions& o) {
  Hash hash;
  for (const int n : {o.width, o.height, o.antialias ? o.aa_depth : 0, o.block_size, o.first_column,
                      o.end_column, o.first_row, o.end_row, o.alpha ? 1 : 0, o.samples, o.samples > 0 ? o.paths.max_bounces : 0}) {
    hash.add(n);
  }
  for (const float x : {o.aa_threshold, o.aa_jitter, o.aa_gamma}) hash.add(o.antialias ? x : 0.0F);
  scene::dump(scene, registry, nullptr, scene::DumpStyle::json,
              [&](std::string_view text) { hash.add(text.data(), text.size()); });
  return hash.value();
}

std::optional<std::string> write_state(const std::string& path, std::uint64_t fingerprint,
                                       const tracer::Checkpoint::State& state) {
  Header header;
  header.fingerprint = fingerprint;
  header.width = static_cast<std::uint32_t>(state.image.width);
  header.height = static_cast<std::uint32_t>(state.image.height);
  header.blocks = state.done.size();
  std::vector<unsigned char> bytes;
  bytes.reserve(sizeof header + header.blocks + state.image.pixels.size() * sizeof(float) + 8);
  append(bytes, &header, 1);
  append(bytes, state.done.data(), state.done.size());
  append(bytes, state.image.pixels.data(), state.image.pixels.size());
  const std::uint64_t hash = hash_of(bytes, bytes.size());
  append(bytes, &hash, 1);
  return image::write_file(path, bytes);
}

StateRead read_state(const std::string& path, std::uint64_t fingerprint) {
  StateRead result;
  std::ifstream in(path, std::ios::binary);
  const std::vector<unsigned char> bytes(std::istreambuf_iterator<char>(in), {});
  if (const auto why = decode(bytes, fingerprint, result.state)) {
    result.error = fmt::format("`{}` {}", path, *why);
  }
  return result;
}

}  // namespace durer::cli
