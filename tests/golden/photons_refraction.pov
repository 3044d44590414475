// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 } }
camera { location <0, 4, -6> look_at <0, 0.4, 0> angle 45 }
light_source { <4, 8, 3>, 0.6 }
background { rgb <0.1, 0.15, 0.2> }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.6 } finish { ambient 0 } }
sphere {
  <-1, 1, 0>, 1
  pigment { rgbf <0.95, 1, 0.9, 0.9> }
  finish { ambient 0 diffuse 0.1 specular 0.6 reflection { 0.02, 0.9 } }
  interior { ior 1.5 fade_distance 3 fade_power 2 fade_color <0.2, 0.8, 0.4> }
  photons { target reflection on refraction on }
}
box {
  <0.8, 0, -1>, <1.6, 1.2, 0.2> rotate 20*y
  pigment { rgbt <0.4, 0.6, 1, 0.8> }
  interior { ior 1.3 }
  photons { target 1.5 refraction on collect off }
}
