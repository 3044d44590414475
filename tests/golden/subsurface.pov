// golden: +W96 +H72 -A; psnr >= 35; where light goes in is random in both
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 400, 100 } }
camera { location <0, 2.5, -5> look_at <0, 0.7, 0> angle 45 }
light_source { <-4, 6, -3>, 0.8 }
light_source { <3, 2, 5>, <0.4, 0.5, 0.6> spotlight point_at <1, 0.7, 0> radius 20 falloff 30 }
plane { y, 0 pigment { checker rgb 0.7 rgb 0.4 } finish { ambient 0 } }
#default { finish { ambient 0 } }
sphere {
  <-1, 0.8, 0>, 0.8
  pigment { rgb <0.9, 0.7, 0.5> }
  finish { diffuse 0.9 specular 0.5 reflection { 0.05, 0.4 fresnel } subsurface { translucency <2, 1, 0.5> } }
  interior { ior 1.4 }
}
// Thin enough to be seen through.
box {
  <0.6, 0, -0.1>, <1.8, 1.4, 0.1> rotate 20*y
  pigment { agate color_map { [0.4 rgb <0.8, 0.9, 0.8>] [1 rgb <0.4, 0.5, 0.3>] } scale 0.4 }
  finish { diffuse 0.8 subsurface { translucency <3, 4, 3> } }
  interior { ior 1.3 }
}
