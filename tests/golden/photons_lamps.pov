// golden: +W96 +H72 -A; psnr >= 35; where single photons fall is random in the oracle
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.03 } }
camera { location <0, 7, -7> look_at 0 angle 45 }
#declare Ball = sphere {
  0, 0.7 translate y
  pigment { rgbt 1 } interior { ior 1.4 }
  photons { target refraction on collect off }
}
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 } }
// Each ball has a lamp of its own kind, and one of a colour that does not want photons.
object { Ball translate <-2, 0, 1.5> }
light_source { <-3, 6, 2>, <0.5, 0.2, 0.2> parallel point_at <-2, 0, 1.5> }
object { Ball translate <2, 0, 1.5> }
light_source { <3, 4, 3>, <0.2, 0.5, 0.2> spotlight point_at <2, 1, 1.5> radius 8 falloff 12 }
object { Ball translate <-2, 0, -1.5> }
light_source {
  <-3, 4, -3>, <0.2, 0.2, 0.6>
  area_light x, z, 3, 3 jitter fade_distance 5 fade_power 2
  photons { area_light }
}
object { Ball translate <2, 0, -1.5> photons { reflection off } }
light_source { <0, 5, -5>, <0.2, 0.2, 0.1> photons { refraction off reflection off } }
light_source { <4, 5, -1.5>, <0.4, 0.2, 0.5> cylinder point_at <2, 0.8, -1.5> radius 0.5 falloff 0.9 }
