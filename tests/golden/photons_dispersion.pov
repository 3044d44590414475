// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.012 gather 20, 60 } max_trace_level 8 }
camera { location <0, 6, -2> look_at <1, 0, 0> angle 50 }
light_source { <-9, 1.2, 0>, 1.5 spotlight point_at <0, 0.5, 0> radius 3 falloff 5 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.02 } }
plane { x, 4 inverse pigment { rgb 0.9 } finish { ambient 0.02 } }
prism {
  0, 1.2, 4
  <-0.7, -0.4>, <0.7, -0.4>, <0, 0.8>, <-0.7, -0.4>
  pigment { rgbt 1 }
  interior { ior 1.5 dispersion 1.1 dispersion_samples 12 }
  photons { target refraction on reflection off }
}
