// golden: +W128 +H96 -A; psnr >= 42; roots by another solver, and shadows within 1e-2 of the surface
#version 3.7;
global_settings { assumed_gamma 1 }
// Balls and rods, negative ones, moved components, textures that melt, and one in solid geometry.
camera { location <0.3, 5, -9> look_at <0, 0.3, -0.2> angle 42 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
blob { threshold 0.6 sphere { -0.5*x, 1, 1 } sphere { 0.5*x, 1, strength 1 } cylinder { -y, y, 0.5, -0.5 } texture { Two } rotate 20*y translate <-2.3, 0.4, 1.4> }
blob { threshold 0.5
  cylinder { -x, x, 0.7, 1 pigment { rgb <0.9, 0.2, 0.2> } }
  cylinder { -y, y, 0.7, 1 texture { pigment { checker rgb 1 rgb <0.2, 0.2, 0.7> scale 0.2 } } rotate 20*x }
  sphere { 0, 1, 0.8 scale <1, 0.3, 1.4> translate <0.3, 0.2, 0> texture { pigment { rgb <0.2, 0.9, 0.3> } finish { phong 0.8 } } }
  sphere { <0.9, 0.6, -0.3>, 0.6, 1.5 }
  pigment { rgb <0.9, 0.8, 0.3> } rotate <-10, 20, 0> translate <0.4, 0.4, 1.6> }
blob { threshold 0.4 component 1, 0.8, <0, 0, 0> component 1.2, 0.9, <0.8, 0.2, 0> component -0.8, 0.5, <0.4, 0.3, -0.6>
  sturm pigment { rgb <0.4, 0.8, 0.4> } translate <2.3, 0.2, 0> }
difference {
  blob { threshold 0.3 sphere { 0, 1.2, 1 } cylinder { 0, <0.8, 0.9, 0>, 0.5, 1 } pigment { rgb <0.9, 0.4, 0.7> } }
  blob { threshold 0.5 sphere { <-0.3, 0.3, -0.8>, 0.7, 1 } sphere { <0.3, 0.3, -0.8>, 0.7, 1 } texture { Two } }
  plane { x, -0.6 }
  translate <-0.5, 0.2, -1.4>
}
plane { y, -0.7 pigment { rgb 0.7 } }
