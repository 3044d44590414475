// bench: +W1920 +H1440 -A; noise: granite with wrinkles as its normal, over the whole picture
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y direction z }
light_source { <-8, 12, -20> rgb 1 }
plane {
  z, 0
  pigment {
    granite
    color_map { [0 rgb <0.2, 0.15, 0.15>] [0.3 rgb <0.5, 0.4, 0.4>] [0.6 rgb <0.8, 0.7, 0.6>] [1 rgb 1] }
    rotate <20, 35, 10> scale 1.3
  }
  normal { wrinkles 0.6 scale 0.3 }
  finish { specular 0.4 }
}
