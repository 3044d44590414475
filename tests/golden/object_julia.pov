// golden: +W128 +H96 -A; psnr >= 35; rays walk in steps, and rims are as thin as they
#version 3.7;
global_settings { assumed_gamma 1 }
// Quaternions and hypercomplex numbers, slices, functions, and one in solid geometry.
camera { location <0.3, 5, -9> look_at <0, 0.2, -0.2> angle 40 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 texture { Two } translate <-2, 0.3, 1.6> }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion cube max_iteration 6 precision 20 pigment { rgb <0.8, 0.4, 0.3> } rotate 30*y translate <0.6, 0.4, 1.6> }
julia_fractal { <-0.083, 0, -0.83, -0.025> hypercomplex sqr max_iteration 8 precision 15 pigment { rgb <0.4, 0.8, 0.4> } scale 0.8 translate <2.6, 0.3, 0> }
julia_fractal { <-0.2, 0.3, 0.1, 0.2> hypercomplex cube max_iteration 6 precision 15 pigment { rgb <0.5, 0.7, 0.9> } scale 0.5 translate <-2.2, 0.2, -1.8> }
julia_fractal { <0.2, 0.3, -0.4, 0.1> slice <0.1, 0.2, 0, 1>, 0.2 max_iteration 10 precision 30 pigment { rgb <0.9, 0.8, 0.4> } scale 0.7 translate <2, 0.2, -2.4> }
difference {
  julia_fractal { <-0.6, 0.1, 0.2, 0> max_iteration 7 precision 20 pigment { rgb <0.9, 0.4, 0.7> } }
  plane { z, -0.1 rotate 30*y texture { Two } }
  translate <-0.1, 0.2, -1.4>
}
plane { y, -0.9 pigment { rgb 0.7 } }
