// bench: +W1024 +H768 -A; images as pigments and as bumps, interpolated and not, on a floor, balls and a sky
// input: bench_map.ppm
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.4, 0> angle 44 }
light_source { <-8, 12, -6> rgb 1 }
sky_sphere { pigment { image_map { ppm "bench_map.ppm" map_type 1 interpolate 2 } } }
#for (I, -2, 2)
  sphere { 0, 0.6
    pigment { image_map { ppm "bench_map.ppm" map_type 1 } }
    normal { bump_map { ppm "bench_map.ppm" map_type 1 interpolate 2 bump_size 3 } }
    rotate 50*I*y translate <I*1.4, 0.6, 0>
    finish { specular 0.4 }
  }
  torus { 0.4, 0.2 pigment { image_map { ppm "bench_map.ppm" map_type 5 interpolate 4 } } scale 1.2 rotate 60*x translate <I*1.4, 0.6, 1.8> }
#end
plane { y, 0
  pigment { image_map { ppm "bench_map.ppm" interpolate 2 } rotate 90*x scale 2 }
  normal { bump_map { ppm "bench_map.ppm" interpolate 3 bump_size 5 } rotate 90*x scale 2 }
}
