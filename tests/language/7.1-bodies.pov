// Language §7.1: how bodies are built.
#version 3.7;
global_settings { assumed_gamma 1 }

//= positional operands, then modifiers
sphere { 0, 1 } box { -1, 1 scale 2 } cylinder { 0, y, 1 open } cone { 0, 1, y, 0 open } torus { 1, 0.2 sturm } plane { y, -1 } disc { 0, y, 1 }
#debug concat("fine", "\n")
// expect: fine

//= switch words with and without values
sphere { 0, 1 hollow } sphere { 0, 1 hollow on } sphere { 0, 1 hollow off } sphere { 0, 1 no_image no_reflection double_illuminate }
#debug concat("fine", "\n")
// expect: fine

//= no_shadow takes no value
sphere { 0, 1 no_shadow on }
// error: D0201 at 1:25

//= nested blocks
sphere { 0, 1 pigment { rgb 1 } finish { phong 1 } interior { ior 1.5 } }
#debug concat("fine", "\n")
// expect: fine

//= a name first
#declare P = pigment { rgb 1 } #declare T = texture { pigment { P } } #declare O = sphere { 0, 1 } #declare M = color_map { [0 rgb 0] [1 rgb 1] }
sphere { 0, 1 pigment { P scale 2 } } object { O texture { T finish { phong 1 } } } sphere { 0, 1 pigment { gradient x color_map { M } } }
#debug concat("fine", "\n")
// expect: fine

//= colour lists
sphere { 0, 1 pigment { checker rgb 1, rgb 0 } } sphere { 0, 1 pigment { checker rgb 1 } } sphere { 0, 1 pigment { hexagon rgb 1 rgb 0 rgb x } } sphere { 0, 1 pigment { brick rgb 1, rgb 0 } }
#debug concat("fine", "\n")
// expect: fine

//= transform by name and by block
#declare T = transform { scale 2 } sphere { 0, 1 transform T } sphere { 0, 1 transform { T translate x } }
#debug concat("fine", "\n")
// expect: fine

//= texture without braces
#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 texture T }
// error: D0201 at 1:66

//= an object name at the top level
#declare O = sphere { 0, 1 } O
#debug concat("fine", "\n")
// expect: fine

//= an object name inside of a union
#declare O = sphere { 0, 1 } union { O O }
// beyond

//= a union of one
union { sphere { 0, 1 } }
#debug concat("fine", "\n")
// expect: fine

//= objects of objects
object { sphere { 0, 1 } translate x } object { union { sphere { 0, 1 } box { 0, 1 } } }
#debug concat("fine", "\n")
// expect: fine

//= an unknown setting
sphere { 0, 1 finish { difuse 0.5 } }
// error: D0214 at 1:24

//= a missing operand
sphere { 0 }
// error: D0202 at 1:12

//= objects of every kind: @
@ #debug "fine\n"
// each: 'sphere { 0, 1 }' 'box { 0, 1 }' 'cone { 0, 1, y, 0 }' 'cylinder { 0, y, 1 }' 'torus { 1, 0.2 }' 'plane { y, 0 }' 'disc { 0, y, 1 }' 'triangle { 0, x, y }' 'smooth_triangle { 0, z, x, z, y, z }' 'quadric { <1,1,1>, 0, 0, -1 }' 'superellipsoid { <0.5, 0.5> }'
// each: 'mesh { triangle { 0, x, y } }' 'mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,2> } }' 'cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> }' 'poly { 2, <1,0,0,0,1,0,0,1,0,-1> }' 'quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> }'
// each: 'union { sphere { 0, 1 } box { 0, 1 } }' 'merge { sphere { 0, 1 } box { 0, 1 } }' 'intersection { sphere { 0, 1 } box { 0, 1 } }' 'difference { sphere { 0, 1 } box { 0, 1 } }' 'light_source { 0, rgb 1 }'
// expect: fine

//= numbers of operands first: @
@ #debug "fine\n"
// each: 'polygon { 4, 0, x, x+y, y }' 'polygon { 4 0 x x+y y }' 'triangle { 0 x y }' 'mesh2 { vertex_vectors { 3 0 x y } face_indices { 1 <0,1,2> } }'
// expect: fine

//= keyword @ takes an expression
camera { @ } #debug "fine\n"
// each: 'location 0' 'location <1,2,3>' 'look_at x' 'angle 30+5' 'right 1.33*x' 'up y' 'direction z' 'sky y' 'orthographic' 'perspective'
// expect: fine

//= switch word @ has an optional value
sphere { 0, 1 @ } sphere { 0, 1 @ on } sphere { 0, 1 @ off } sphere { 0, 1 @ 0.5 } sphere { 0, 1 @ (1=1) } #debug "fine\n"
// each: hollow no_image no_reflection double_illuminate no_radiosity
// expect: fine

//= switch word @ has no value
sphere { 0, 1 @ } #debug "fine\n"
// each: inverse no_shadow
// expect: fine

//= @ takes no value
sphere { 0, 1 @
on }
// each: inverse no_shadow
// error: D0201 at 2:1

//= a cylinder is open without a value
cylinder { 0, y, 1 open on }
// error: D0201 at 1:25

//= light word @
light_source { 0, rgb 1 @ } #debug "fine\n"
// each: shadowless parallel 'parallel point_at x' 'spotlight point_at x radius 10 falloff 20 tightness 3' cylinder 'area_light x, y, 2, 2' 'area_light x, y, 2, 2 adaptive 1 jitter circular orient' 'fade_distance 3 fade_power 2' 'media_interaction off' 'media_attenuation on' 'looks_like { sphere { 0, 1 } }' 'translate x'
// expect: fine

//= leading names of @
#declare O = sphere { 0, 1 } #declare T = texture { pigment { rgb 1 } } #declare P = pigment { rgb 1 } #declare F = finish { phong 1 } #declare N = normal { bumps } #declare C = camera { location 0 } #declare L = light_source { 0, rgb 1 } #declare M = color_map { [0 rgb 0] [1 rgb 1] } #declare R = transform { scale 2 } #declare I = interior { ior 1.5 } #declare A = material { texture { T } }
@ #debug "fine\n"
// each: 'object { O translate x }' 'sphere { 0, 1 texture { T scale 2 } }' 'sphere { 0, 1 pigment { P rotate x } }' 'sphere { 0, 1 finish { F ambient 1 } }' 'sphere { 0, 1 normal { N scale 2 } }' 'camera { C translate x }' 'light_source { L translate x }' 'sphere { 0, 1 pigment { gradient x color_map { M } } }' 'sphere { 0, 1 transform { R } }' 'sphere { 0, 1 transform R }' 'sphere { 0, 1 interior { I } }' 'sphere { 0, 1 material { A } }' 'O' 'object { L }'
// expect: fine

//= leading words of @
sphere { 0, 1 @ } #debug "fine\n"
// each: 'pigment { bozo turbulence 1 }' 'normal { bumps 0.5 scale 2 }' 'normal { ripples frequency 3 }' 'pigment { agate agate_turb 0.5 }' 'pigment { gradient x }' 'pigment { wood warp { turbulence 1 } }' 'pigment { marble warp { repeat x } }' 'pigment { granite warp { black_hole 0, 1 } }'
// expect: fine

//= pattern @ in pigments
sphere { 0, 1 pigment { @ color_map { [0 rgb 0] [1 rgb 1] } } } #debug "fine\n"
// each: agate boxed bozo bumps cells crackle cylindrical dents granite leopard marble onion planar radial ripples spherical spotted waves wood wrinkles 'gradient x' 'spiral1 3' 'spiral2 3' 'quilted control0 0 control1 1' 'julia <0.3,0.4>, 20' 'mandel 20' 'magnet 1 mandel 20' 'magnet 2 julia <0.1,0.2>, 20' 'aoi' 'slope y' 'function { x }' 'pavement' 'tiling 3'
// expect: fine

//= pattern @ with colours
sphere { 0, 1 pigment { @ } } #debug "fine\n"
// each: 'checker rgb 1, rgb 0' 'checker' 'hexagon rgb 1, rgb 0, rgb 0.5' 'hexagon' 'brick rgb 1, rgb 0' 'brick' 'square rgb 1, rgb 0, rgb x, rgb y' 'triangular rgb 1, rgb 0, rgb x, rgb y, rgb z, rgb 1' 'checker pigment { rgb 1 } pigment { rgb 0 }' 'object { sphere { 0, 1 } rgb 1, rgb 0 }' 'cubic rgb 1, rgb 0'
// expect: fine

//= pattern modifier @
sphere { 0, 1 pigment { bozo @ } } #debug "fine\n"
// each: 'turbulence 0.5' 'octaves 3' 'omega 0.3' 'lambda 3' 'frequency 2' 'phase 0.5' ramp_wave sine_wave triangle_wave scallop_wave cubic_wave 'poly_wave 2' 'noise_generator 1' 'scale 2' 'quick_color rgb 1' 'quick_colour rgb 1' 'warp { turbulence 0.5 octaves 2 }'
// expect: fine

//= finish word @
sphere { 0, 1 finish { @ } } #debug "fine\n"
// each: 'ambient 0.5' 'ambient rgb 0.5' 'diffuse 0.5' 'diffuse 0.5, 0.2' 'diffuse albedo 0.5' 'brilliance 2' 'phong 1' 'phong_size 20' 'phong albedo 0.5' 'specular 0.5' 'specular albedo 0.5' 'roughness 0.02' 'metallic' 'metallic 0.5' 'reflection 0.5' 'reflection { 0.1, 0.5 }' 'reflection { 0.5 falloff 2 exponent 1 metallic }' 'reflection_exponent 1' 'crand 0.1' 'emission 0.5' 'conserve_energy' 'irid { 0.2 thickness 0.5 turbulence 0.1 }'
// expect: fine

//= fog and rainbow words @
@ #debug "fine\n"
// each: 'fog { distance 10 rgb 0.5 }' 'fog { fog_type 2 distance 10 rgb 0.5 fog_offset 1 fog_alt 2 }' 'fog { distance 10 rgb 0.5 turbulence 0.5 turb_depth 0.3 }' 'rainbow { direction z angle 40 width 5 distance 100 color_map { [0 rgb 0] [1 rgb 1] } }' 'rainbow { direction z angle 40 width 5 distance 100 color_map { [0 rgb 0] [1 rgb 1] } arc_angle 90 falloff_angle 30 jitter 0.1 }'
// expect: fine

//= interior words @
sphere { 0, 1 hollow interior { @ } } #debug "fine\n"
// each: 'ior 1.5' 'fade_distance 1 fade_power 2' 'fade_color rgb 0.5' 'fade_colour rgb 0.5' 'caustics 0.5' 'dispersion 1.02' 'dispersion_samples 10' 'media { emission 1 }'
// expect: fine

//= switch words of some shapes: @
@ #debug "fine\n"
// each: 'torus { 1, 0.2 sturm }' 'torus { 1, 0.2 sturm off }' 'quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> sturm on }' 'mesh { triangle { 0, x, y } hierarchy off }' 'mesh { triangle { 0, x, y } hierarchy }'
// expect: fine

//= a sphere has no @
sphere { 0, 1 @ }
// each: sturm hierarchy
// error: D0214 at 1:15

//= media words @
media { @ } #debug "fine\n"
// each: '' 'method 1' 'method 2' 'method 3' 'intervals 3' 'samples 4' 'samples 4, 9' 'samples 4 9' 'confidence 0' 'variance -1' 'ratio 0.5' 'jitter 0.4' 'aa_threshold 0.2' 'aa_level 1' 'absorption 0.5' 'emission rgb 0.5' 'scattering { 1, rgb 1 }' 'scattering { 5 1 eccentricity 0.2 extinction 0.5 }' 'collect' 'collect off' 'density { bozo }' 'translate x' 'scale 2' 'rotate 30*x' 'transform { scale 2 }'
// expect: fine

//= densities @
media { density { @ } } #debug "fine\n"
// each: '' 'rgb 0.5' 'spherical' 'spherical scale 2 turbulence 0.4' 'gradient x color_map { [0 rgb 0] [1 rgb 1] }' 'gradient x density_map { [0 rgb 0] [1 bozo scale 2] }' 'average density_map { [1 bozo] [2 spherical] }' 'checker density { rgb 1 } density { bozo }' 'spherical warp { turbulence 0.3 }'
// expect: fine

//= names of media and densities
#declare D = density { spherical scale 2 }
#declare M = media { emission 1 density { D turbulence 0.3 } }
#declare I = interior { media { M absorption 1 } media { M } }
media { M density { D } } sphere { 0, 1 hollow interior { I } }
#debug "fine\n"
// expect: fine

//= media that make no sense: @
media { @ }
// each: 'method 4' 'intervals 0' 'samples 0' 'samples 3, 2' 'confidence 1' 'confidence -0.1' 'aa_threshold 0' 'aa_level 0'
// error: D0302 at 1:9

//= eccentricity of another type
media { scattering { 1, 1 eccentricity 0.2 } }
// error: D0201 at 1:27

//= a density takes no @
media { density { spherical @ } }
// each: 'pigment_map { [0 rgb 0] [1 rgb 1] }' 'quick_color rgb 1'
// error: D0214 at 1:29

//= nothing moves inside of an interior
sphere { 0, 1 interior { media { emission 1 } scale 2 } }
// error: D0214 at 1:47
