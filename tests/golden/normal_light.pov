// golden: +W128 +H96 -A; psnr >= 50; what bumps do to reflection, refraction, layers and textures
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> angle 50 }
light_source { <-20, 30, -30> rgb 0.9 }
plane { y, -0.6 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.6> scale 0.5 } normal { ripples 0.2 scale 0.3 } finish { reflection 0.3 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.8, 0.9>] [1 rgb <0.2, 0.3, 0.8>] } } }
sphere {
  <-1.3, 0, 0>, 0.6
  pigment { rgbt <0.9, 1, 0.9, 0.9> }
  normal { bumps 0.3 scale 0.15 }
  finish { phong 0.7 reflection 0.1 }
  interior { ior 1.5 caustics 0.5 }
}
sphere {
  <0.1, 0, 0.3>, 0.6
  texture { pigment { rgb <0.8, 0.4, 0.3> } normal { wrinkles 0.8 scale 0.3 } finish { specular 0.6 } }
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.5 rgbt <0.2, 0.3, 0.8, 0.3>] } scale 0.2 } normal { dents 1.4 scale 0.1 } finish { phong 0.8 reflection 0.2 } }
}
box {
  -0.5, 0.5
  texture {
    checker
    texture { pigment { rgb <0.7, 0.7, 0.2> } normal { bumps 0.5 scale 0.3 } finish { phong 0.5 } }
    texture { pigment { slope { <0, 1, 0> } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } } normal { waves 0.4 scale 0.2 } }
    scale <0.25, 0.35, 0.25>
  }
  rotate <20, 40, 0>
  translate <1.5, 0, -0.2>
}
