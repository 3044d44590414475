// Files of gathered light, as the oracle writes them: one sample in a line
// (participating-and-global §2.10).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/transport/irradiance_cache.h"

namespace durer::tracer {

/// Points with six digits, directions with a degree or so; quality is not kept.
[[nodiscard]] std::string encode_samples(std::span<const IrradianceSample> samples);

/// What a text says; nothing if any line of it is no sample. Samples that are read have quality 1.
[[nodiscard]] std::optional<std::vector<IrradianceSample>> decode_samples(std::string_view text);

}  // namespace durer::tracer
