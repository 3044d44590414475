// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 radius 0.15 } }
camera { location <0, 5, -6> look_at 0 angle 45 }
light_source { <0, 8, 2>, 0.7 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 } }
#macro Ball(X)
  sphere {
    <X, 1, 0>, 0.6
    pigment { rgbt 1 } interior { ior 1.35 }
    photons { target refraction on reflection on collect off }
  }
#end
// Below a pane that lets photons pass, below one that stops them, and in the open.
Ball(-2)
box { <-2.8, 2, -0.8>, <-1.2, 2.05, 0.8> pigment { rgbf <1, 0.6, 0.6, 0.9> } photons { pass_through } }
Ball(0)
box { <-0.8, 2, -0.8>, <0.8, 2.05, 0.8> pigment { rgbf <0.6, 1, 0.6, 0.9> } }
Ball(2)
// It shows none.
box { <1.6, 0, -0.3>, <2.2, 0.05, 0.3> pigment { rgb <0.6, 0.6, 1> } photons { collect off } }
