// golden: +W128 +H96 -A; psnr >= 40; roots by another solver; the oracle loses single rays
#version 3.7;
global_settings { assumed_gamma 1 }
// Straight, cubic and B-spline ways, growing and shrinking balls, and one in solid geometry.
camera { location <0.3, 6, -9> look_at <0, 0, -0.2> angle 46 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
sphere_sweep { linear_spline 4, <-1, 0, 0>, 0.5, <0.5, 0.5, 0>, 0.2, <1, -0.2, 0.4>, 0.4, <0.6, 0, -0.6>, 0.1 texture { Two } translate <-2.5, 0.3, 1.6> }
sphere_sweep { cubic_spline 6, <-1.5, 0, 0>, 0.2, <-1, 0, 0>, 0.4, <0, 0.8, 0.3>, 0.2, <1, 0, 0>, 0.5, <0.5, 0, -0.8>, 0.1, <0, 0, 0>, 0.2
  tolerance 1e-4 pigment { rgb <0.8, 0.3, 0.3> } rotate 20*y translate <0.6, 0.2, 1.6> }
sphere_sweep { b_spline 6, <-1, 0, 0>, 0.3, <-1, 1, 0>, 0.5, <0, 0, 0>, 0.3, <1, 1, 0>, 0.6, <1, 0, -1>, 0.3, <0, 0, -1>, 0.2
  pigment { rgb <0.4, 0.8, 0.4> } scale <1, 0.8, 1.2> rotate 20*x translate <2.5, 0.2, 0> }
difference {
  sphere { 0, 1 pigment { rgb <0.9, 0.4, 0.7> } }
  sphere_sweep { linear_spline 3, <-1, 0.5, -0.6>, 0.3, <0, 0, -1>, 0.2, <0.8, 0.7, -0.5>, 0.3 texture { Two } }
  translate <-0.8, 0.2, -1.4>
}
plane { y, -0.7 pigment { rgb 0.7 } }
