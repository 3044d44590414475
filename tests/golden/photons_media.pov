// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.04 media 100, 1 } }
camera { location <0, 2, -9> look_at <0, 1.6, 0> angle 40 }
light_source { <0, 8, 0>, 1.5 spotlight point_at 0 radius 20 falloff 25 }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0 } }
box {
  <-3, 0.01, -2>, <3, 5, 2> hollow
  pigment { rgbt 1 }
  interior { media { scattering { 1, 0.15 extinction 0.6 } method 3 samples 12 } }
  photons { pass_through }
}
sphere {
  <0, 3, 0>, 0.8
  pigment { rgbt 1 } interior { ior 1.5 }
  photons { target refraction on reflection off collect off }
}
