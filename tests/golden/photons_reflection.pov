// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 autostop 0 } }
camera { location <0, 5, -5> look_at 0 angle 40 }
light_source { <3, 5, -4>, 0.7 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 phong 0.5 } }
// A ring throws its heart-shaped light into itself.
difference {
  cylinder { 0, 0.6*y, 1.5 }
  cylinder { -y, y, 1.4 }
  pigment { rgb <1, 0.8, 0.4> }
  finish { ambient 0 diffuse 0.2 reflection { 0.8 metallic } }
  photons { target reflection on refraction off }
}
sphere {
  <-0.3, 0.3, 0.2>, 0.3
  pigment { rgb <0.8, 0.3, 0.3> }
  finish { ambient 0 diffuse 0.8 }
}
