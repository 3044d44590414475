// golden: +W128 +H96 -A; psnr >= 45; roots by another solver
#version 3.7;
global_settings { assumed_gamma 1 }
// Each kind of spline, an open bowl seen from inside, two in solid geometry, surface coordinates.
camera { location <0.3, 5, -9> look_at <0, 0.6, -0.2> angle 46 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
lathe { linear_spline 5, <0, 0>, <0.8, 0>, <1, 0.5>, <0.3, 1.2>, <0, 1> texture { Two } translate <-2.7, 0, 1.6> }
lathe { quadratic_spline 6, <0.4, -1>, <0.8, 0>, <0.3, 0.6>, <0.7, 1.2>, <0.5, 1.7>, <0.2, 2>
  sturm  // without it the oracle loses parts of the surface
  pigment { rgb <0.8, 0.3, 0.3> } rotate <20, 0, 15> translate <-0.3, 0, 2> }
lathe { cubic_spline 7, <0.5, -1>, <0.1, 0>, <0.9, 0.6>, <1.1, 1.1>, <1, 1.15>, <0.7, 0.6>, <0.3, 0.3>
  texture { pigment { rgb <0.4, 0.8, 0.4> } finish { specular 0.5 } }
  interior_texture { pigment { rgb <0.8, 0.8, 0.2> } } rotate <-15, 0, 0> translate <2.4, 0, 1.2> }
lathe { bezier_spline 8, <0.6, 0>, <1.2, 0>, <1.2, 0.7>, <0.8, 0.7>, <0.8, 0.7>, <0.4, 0.7>, <0.2, 0.1>, <0.6, 0>
  sturm uv_mapping pigment { checker rgb 1 rgb <0.2, 0.2, 0.6> scale 1/8 } rotate -10*x translate <-2.2, 0, -1.6> }
difference {
  lathe { cubic_spline 7, <0, -1>, <0, 0>, <0.9, 0.3>, <0.6, 0.9>, <0.8, 1.3>, <0, 1.6>, <0, 2> pigment { rgb <0.9, 0.4, 0.7> } }
  lathe { linear_spline 4, <0, 0>, <0.4, 0.2>, <0.5, 2>, <0, 2> translate <0.2, 0.2, -0.2> texture { Two } }
  box { <0, -1, -2>, <2, 3, 0> rotate 30*y pigment { rgb 0.9 } }
  translate <0.3, 0, -1.8>
}
plane { y, -0.2 pigment { rgb 0.7 } }
