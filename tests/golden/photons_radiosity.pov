// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings {
  assumed_gamma 1
  photons { spacing 0.03 max_trace_level 6 adc_bailout 0.01 expand_thresholds 0.4, 20 }
  radiosity { count 100 error_bound 0.6 }
}
camera { location <0, 2.5, -6> look_at <0, 1.2, 0> angle 45 }
light_source { <0, 3.9, 0>, 0.8 }
box { <-3, 0, -7>, <3, 4, 3> inverse pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.7 } }
sphere {
  <0, 1.6, 0>, 0.7
  pigment { rgbt 1 } interior { ior 1.45 }
  photons { target refraction on reflection off }
}
