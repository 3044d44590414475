// bench: +W320 +H240 +A0.3; focal blur
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 2.5, -8> look_at <0, 0.6, 0> angle 40
  aperture 0.5 blur_samples 20 focal_point <0, 0.5, -1> variance 1/5000 confidence 0.9
}
light_source { <-6, 8, -5> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 0.9] [1 rgb <0.2, 0.4, 0.8>] } } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.4, 0.45, 0.5> } }
#declare R = seed(11);
#for (I, 0, 299)
  sphere { <14 * rand(R) - 7, 0.25, 16 * rand(R) - 6>, 0.25
    pigment { rgb <rand(R), rand(R), rand(R)> } finish { phong 0.6 reflection 0.1 } }
#end
