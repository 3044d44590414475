// golden: +W96 +H48 -A; psnr >= 34; photons draw other random numbers
#version 3.7;
// Photons end where the square of what is left of them falls below adc_bailout: the first two mirrors throw
// light on the wall, the third, with nearly as much reflection, throws none.
global_settings { assumed_gamma 1 max_trace_level 6 photons { spacing 0.04 autostop 0 } }
camera { location <0, 3, -12> look_at <0, 1.2, 0> angle 34 right 2*x }
#macro Mirror(X, R)
  light_source { <X, 6, -3> rgb 20/R spotlight radius 6 falloff 9 point_at <X, 0, 0> photons { reflection on refraction off } }
  box { <-0.5, -0.05, -0.5>, <0.5, 0, 0.5> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection R } translate X*x photons { target collect off } }
#end
Mirror(-2.5, 0.3)
Mirror(0, 0.07)
Mirror(2.5, 0.055)
plane { -z, -1.5 pigment { rgb 0.02 } }
plane { y, -0.2 pigment { rgb 0.01 } }
