// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 } }
camera { location <0, 5, -6> look_at 0 angle 45 }
light_source { <0, 8, 2>, 0.7 }
plane {
  y, 0
  texture { pigment { rgb <0.8, 0.8, 0.7> } finish { ambient 0 } }
  texture { pigment { gradient x color_map { [0.5 rgbt 1] [0.5 rgbt <0.3, 0.4, 0.8, 0.4>] } } finish { ambient 0 brilliance 3 } }
}
sphere {
  <-1.5, 1, 0>, 0.8
  texture {
    gradient y scale 0.4
    texture_map {
      [0.5 pigment { rgbt 1 }]
      [0.5 pigment { rgbf <1, 0.5, 0.3, 0.9> } finish { reflection 0.3 }]
    }
  }
  interior { ior 1.3 }
  photons { target refraction on reflection on }
}
sphere {
  <1.5, 1, 0>, 0.8
  texture { pigment { rgbf <0.8, 0.9, 1, 1> } normal { bumps 0.3 scale 0.2 } finish { reflection { 0.5 } conserve_energy } }
  interior { ior 1.2 }
  photons { target refraction on reflection on }
}
