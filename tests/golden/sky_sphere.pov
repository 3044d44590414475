// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen directly, in a mirror, through glass; layered, turned, and with rays that go below the horizon.
camera { location <0, 1, -5> look_at <0, 1.3, 0> angle 70 }
light_source { <-4, 6, -6> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [0.4 rgb <0.3, 0.5, 0.8>] [1 rgb <0.1, 0.2, 0.5>] } }
  pigment { radial color_map { [0.45 rgbt 1] [0.5 rgbt <1, 1, 0.8, 0.3>] [0.55 rgbt 1] } rotate -90*y }
  rotate 10*z
}
sphere { <-1.2, 1, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <1.2, 1, 0>, 0.9 pigment { rgbt 0.95 } finish { ambient 0 diffuse 0.05 } interior { ior 1.4 } }
box { <-4, -0.2, -2>, <4, 0, 2> pigment { checker rgb 0.8, rgb 0.3 } }
