// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Every way to write a colour.
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 5, -9> rgb 1 }
#default { finish { ambient 0.3 diffuse 0.6 } }
#declare Rust = color red 0.7 green 0.3 blue 0.1;
#declare Patches = array[12] {
  rgb <0.9, 0.5, 0.1>, rgb 0.5, color red 0.8, color green 0.6 blue 0.9, Rust, Rust*0.5,
  srgb <0.9, 0.5, 0.1>, rgb x + 0.5*y, color rgb <0.2, 0.4, 0.8>, rgb <Rust.blue, Rust.green, Rust.red>,
  rgb Rust + <0, 0.3, 0.3>, colour rgb <0.5, 0.5, 1>*0.8
}
#for (I, 0, 11)
  sphere { <mod(I, 4) - 1.5, 1 - div(I, 4), 0>, 0.45 pigment { color Patches[I] } }
#end
