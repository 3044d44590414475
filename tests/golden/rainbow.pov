// golden: +W96 +H72 -A; psnr >= 50; rainbows are a formula
#version 3.7;
global_settings { assumed_gamma 1 }
// Two bows, one of them an arc that fades, over sky and far walls; nothing before what is near.
camera { location <0, 1, -4> look_at <0, 2, 4> angle 70 }
light_source { <-6, 9, -6> rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
#declare Bow = color_map {
  [0.0 rgbt <0.8, 0.1, 0.9, 0.95>] [0.3 rgbf <0.1, 0.5, 0.9, 0.3>]
  [0.6 rgbft <0.9, 0.9, 0.1, 0.2, 0.3>] [1 rgbt <0.9, 0.1, 0.1, 0.9>] }
rainbow { angle 24 width 6 distance 20 direction <0, 0.1, 1> up y arc_angle 150 falloff_angle 80 color_map { Bow } }
rainbow { angle 33 width 5 distance 50 direction <0, 0.1, 1> color_map { Bow } }
box { <-5, -1, -1>, <5, -0.9, 40> pigment { checker rgb 0.8, rgb <0.3, 0.35, 0.4> } }
box { <-8, -1, 30>, <-2, 14, 31> pigment { rgb 0.7 } }
box { <1, -1, 4>, <2, 4, 5> pigment { rgb 0.7 } finish { reflection 0.5 } }
