// Settings of indirect diffuse light (participating-and-global §2.1).
#pragma once

namespace durer::scene {

/// `radiosity { … }` of `global_settings`. Distances that are fractions are relative to the distance
/// from the camera; errors are relative, without unit.
struct Radiosity {
  int count = 35;         // gather rays per sample
  int pool = 1600;        // directions that they are taken from; at least `count`
  int recursion_limit = 2;  // 1…20 bounces
  double error_bound = 1.8;
  double low_error_factor = 0.5;  // times error_bound while the cache is filled
  int nearest_count = 5;          // 1…20 samples that a reuse needs
  int adaptive_count = 0;         // below nearest_count; above 0: stop filling where this is reached
  double minimum_reuse = 0.015;   // fractions: how near and how far a sample counts
  double maximum_reuse = 0.2;
  double gray_threshold = 0;  // 0…1: how much of the light's hue is lost
  double brightness = 1;      // factor at every bounce
  double max_sample = -1;     // greatest component of one gather ray; not positive: any
  double adc_bailout = 0.01;
  double pretrace_start = 0.08;  // spacings of points, fractions of the picture's longer side
  double pretrace_end = 0.04;
  bool always_sample = false;
  bool normal = false;  // bumps count
  bool media = false;   // gather rays see media and fog
  bool subsurface = false;
  /// Importance of what lies beyond all objects: that of `#default`.
  double background_importance = 1;

  friend bool operator==(const Radiosity&, const Radiosity&) = default;
};

}  // namespace durer::scene
