// golden: +W128 +H96 -A; psnr >= 45; sides by another solver; rays through vertices may see a cap or not
#version 3.7;
global_settings { assumed_gamma 1 }
// Each kind of spline and sweep, holes, open ends, and two in solid geometry.
camera { location <0.3, 6, -9> look_at <0, 0, -0.2> angle 46 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
prism { 0, 0.6, 11, <-1, -1>, <1, -1>, <1.1, 1>, <-1, 1>, <-1, -1>,
  <-0.5, -0.5>, <0.5, -0.5>, <0.6, 0.4>, <0, 0.7>, <-0.5, 0.5>, <-0.5, -0.5>
  texture { Two } rotate 20*y translate <-2.6, 0, 1.6> }
prism { quadratic_spline 0.5, 0, 7, <-1, 0.5>, <0, -1>, <1, 0>, <0.4, 0.8>, <-0.6, 0.8>, <-1, 0>, <0, -1>
  pigment { rgb <0.8, 0.3, 0.3> } rotate <-30, 0, 10> translate <0, 0.3, 1.8> }
prism { cubic_spline 0, 1, 8, <-0.3, 0.8>, <-0.8, 0>, <0, -0.9>, <0.9, 0.1>, <0.2, 0.3>, <-0.3, 0.8>, <-0.8, 0>, <0, -0.9> open
  texture { pigment { rgb <0.4, 0.8, 0.4> } finish { specular 0.5 } } interior_texture { pigment { rgb <0.8, 0.8, 0.2> } }
  scale <1.1, 0.7, 1> rotate 15*z translate <2.6, 0.3, 1.4> }
prism { bezier_spline conic_sweep 0.3, 1, 8, <-1, 0>, <-1, -1>, <1, -1>, <1, 0>, <1, 0>, <1, 1>, <-1, 1>, <-1, 0>
  sturm texture { Two } rotate 180*x translate <-2.4, 1, -1.5> }
prism { linear_spline conic_sweep -0.5, 0.8, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>
  pigment { rgb <0.5, 0.7, 0.9> } rotate <10, 25, 0> translate <2.5, 0.6, -1.5> }
difference {
  prism { cubic_spline 0, 0.8, 13, <0.2, -1.1>, <-1, 0>, <0, 1>, <1, 0.2>, <0.2, -1.1>, <-1, 0>, <0, 1>,
    <0.4, 0.1>, <0, 0.3>, <-0.3, -0.2>, <0.4, 0.1>, <0, 0.3>, <-0.3, -0.2> pigment { rgb <0.9, 0.4, 0.7> } }
  prism { -1, 1, 4, <-1.5, -1.5>, <-0.2, -1.5>, <-0.8, 0.3>, <-1.5, -1.5> rotate 20*x texture { Two } translate 0.2*y }
  translate <0, 0, -1.4>
}
plane { y, -0.2 pigment { rgb 0.7 } }
