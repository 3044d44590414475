// golden: +W96 +H72 -A; psnr >= 45; roots of high degree differ in the last digits at silhouettes
#version 3.7;
global_settings { assumed_gamma 1 }
// A torus written as a quartic, and a cubic surface, solved by two methods.
camera { location <0, 2.5, -6> look_at 0 angle 44 }
light_source { <-4, 6, -6> rgb 1 }
quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.82, 0, 0, 0, 0, 1, 0, -2.18, 0, 0.8281>
  clipped_by { box { -1.6, 1.6 } } rotate -40*x scale 0.9 translate -1.3*x pigment { rgb <0.9, 0.5, 0.3> }
}
cubic {
  <1, 0, 0, 0.4, 0, 0, 0, 0.6, 0, -1, 0, 0, 0, 0, 0.8, 0, 0, 0, 0.5, -0.05> sturm
  clipped_by { sphere { 0, 1.1 } } rotate <20, 40, 0> translate 1.3*x pigment { rgb <0.3, 0.6, 0.9> }
}
plane { y, -1.2 pigment { rgb 0.7 } }
