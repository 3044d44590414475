// bench: +W640 +H480 -A; caustics of glasses, balls and a metal ring, from 150,000 photons
#version 3.7;
global_settings {
  assumed_gamma 1
  max_trace_level 10
  photons { count 150000 autostop 0 }
}
camera { location <0, 6, -9> look_at <0, 0.4, 0> angle 42 }
light_source { <-6, 10, 5>, rgb 0.9 }
background { rgb <0.05, 0.07, 0.1> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.75> rgb <0.75, 0.65, 0.5> } finish { ambient 0.02 } }

#macro Glass(Tint)
  material {
    texture {
      pigment { rgbf <Tint.x, Tint.y, Tint.z, 0.95> }
      finish { ambient 0 diffuse 0.05 specular 0.8 roughness 0.002 reflection { 0.03, 0.9 } conserve_energy }
    }
    interior { ior 1.5 }
  }
  photons { target reflection on refraction on }
#end

sphere { <-1.9, 0.8, 0.6>, 0.8 Glass(<0.95, 1, 0.95>) }
sphere { <2.3, 0.5, -1.4>, 0.5 Glass(<1, 0.7, 0.6>) }
// A goblet with thick walls.
lathe {
  cubic_spline
  13,
  <0.0, -0.1>, <0.0, 0.0>, <0.6, 0.02>, <0.62, 0.08>, <0.12, 0.16>, <0.1, 0.7>, <0.55, 1.0>, <0.7, 1.6>, <0.64, 1.62>,
  <0.5, 1.1>, <0.2, 0.95>, <0.0, 0.9>, <0.0, 0.8>
  translate <0.6, 0, 0.8>
  Glass(<1, 1, 1>)
}
// A ring that throws light into itself.
difference {
  cylinder { <0, 0, 0>, <0, 0.5, 0>, 0.9 }
  cylinder { <0, -1, 0>, <0, 1, 0>, 0.84 }
  translate <-0.6, 0, -2>
  pigment { rgb <1, 0.85, 0.5> }
  finish { ambient 0 diffuse 0.2 specular 0.6 metallic reflection { 0.75 metallic } }
  photons { target reflection on refraction off }
}
