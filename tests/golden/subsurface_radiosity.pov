// golden: +W64 +H48 -A; psnr >= 35; where light goes in is random in both
#version 3.7;
global_settings {
  assumed_gamma 1 mm_per_unit 10
  subsurface { samples 100, 20 radiosity on }
  radiosity { count 100 error_bound 0.5 recursion_limit 1 }
}
camera { location <0, 2, -4> look_at <0, 0.7, 0> angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.7>] [1 rgb <0.4, 0.6, 1>] } } }
plane { y, 0 pigment { rgb <0.6, 0.5, 0.4> } finish { ambient 0 } }
sphere {
  <0, 0.8, 0>, 0.8
  pigment { rgb <0.9, 0.8, 0.8> }
  finish { ambient 0 diffuse 0.9 subsurface { translucency 1 } }
  interior { ior 1.3 }
}
