// golden: +W128 +H96 -A; psnr >= 42; the oracle's search loses single rays at sharp edges
#version 3.7;
global_settings { assumed_gamma 1 }
// From box to star, turned and scaled, and two in solid geometry.
camera { location <0.3, 6, -9> look_at <0, 0, -0.2> angle 46 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
superellipsoid { <0.25, 0.5> texture { Two } rotate <20, 30, 0> translate <-2.7, 0.4, 1.6> }
superellipsoid { <1.5, 0.7> pigment { rgb <0.8, 0.3, 0.3> } rotate <20, 40, 0> translate <0, 0.4, 1.9> }
superellipsoid { <0.1, 0.1> pigment { rgb <0.4, 0.8, 0.4> } scale <1, 0.6, 1.2> rotate <-25, 20, 15> translate <2.6, 0.3, 1.4> }
superellipsoid { <2.5, 1.5> texture { Two } rotate <60, 20, 0> translate <-2.5, 0.5, -1.5> }
superellipsoid { <0.3, 2.2> pigment { rgb <0.5, 0.7, 0.9> } rotate <50, 25, 0> translate <2.4, 0.5, -1.5> }
difference {
  superellipsoid { <0.4, 1> pigment { rgb <0.9, 0.4, 0.7> } }
  superellipsoid { <0.2, 0.2> scale 0.7 rotate 20*z translate <0.2, 0.7, -0.3> texture { Two } }
  rotate 30*x translate <0, 0.2, -1.4>
}
plane { y, -0.7 pigment { rgb 0.7 } }
