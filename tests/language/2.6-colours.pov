// Language §2.6: colours.
#version 3.7;
global_settings { assumed_gamma 1 }

//= rgb
#declare C = rgb <.1,.2,.3>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.000,0.000

//= rgbf
#declare C = rgbf <.1,.2,.3,.4>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.400,0.000

//= rgbt
#declare C = rgbt <.1,.2,.3,.4>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.000,0.400

//= rgbft
#declare C = rgbft <.1,.2,.3,.4,.5>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.400,0.500

//= color and colour before them
#declare C = color rgb <.1,.2,.3>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.000,0.000

//= colour before them
#declare C = colour rgbt <.1,.2,.3,.4>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.000,0.400

//= rgb with four components
#declare C = rgb <1,2,3,4>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000,4.000,0.000

//= rgb with five
#declare C = rgb <1,2,3,4,5>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000,4.000,5.000

//= rgbt with three
#declare C = rgbt <1,2,3>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000,0.000,0.000

//= rgbt with five
#declare C = rgbt <1,2,3,4,5>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000,0.000,4.000

//= rgbf with two
#declare C = rgbf <1,2>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,0.000,0.000,0.000

//= rgb with a uv-vector
#declare C = rgb <1,2>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,2.000,0.000,0.000,0.000

//= floats
#declare C = rgb 0.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.000,0.000

//= rgbf of a float
#declare C = rgbf 0.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.500,0.000

//= rgbt of a float
#declare C = rgbt 0.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.000,0.500

//= rgbft of a float
#declare C = rgbft 0.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.500,0.500

//= color of a float
#declare C = color 0.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.500,0.500

//= a bare vector
#declare C = color <1,.5,.2>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.500,0.200,0.000,0.000

//= a bare four-vector
#declare C = color <1,.5,.2,.4>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.500,0.200,0.400,0.000

//= nothing at all
#declare C = color ; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.000,0.000,0.000,0.000,0.000

//= single components
#declare C = red 1 green .5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.500,0.000,0.000,0.000

//= single components after color
#declare C = color red 1 blue .5 transmit .2; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.000,0.500,0.000,0.200

//= filter and alpha
#declare C = rgb 1 filter .3 alpha .4; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000,0.400,0.000

//= components overwrite
#declare C = rgb <.1,.2,.3> red .9 red .8; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.800,0.200,0.300,0.000,0.000

//= an expression
#declare C = color x*.5+y*.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.500,0.500,0.000,0.000,0.000

//= rgb of an axis
#declare C = rgb x; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.000,0.000,0.000,0.000

//= srgb
#declare C = srgb <1,.5,.25>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.214,0.051,0.000,0.000

//= srgb of a float
#declare C = srgb .5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.214,0.214,0.214,0.000,0.000

//= srgbf
#declare C = srgbf <1,.5,.25,.1>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.214,0.051,0.100,0.000

//= srgbt
#declare C = srgbt <1,.5,.25,.1>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.214,0.051,0.000,0.100

//= srgbft
#declare C = srgbft <1,.5,.25,.1,.2>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,0.214,0.051,0.100,0.200

//= arithmetic before decoding
#declare C = srgb <1,.5,.25>*.5; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.214,0.051,0.014,0.000,0.000

//= srgb, small values
#declare C = srgb <0.04,0.05,2>; 
#debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.003,0.004,4.954,0.000,0.000

//= colour variables
#declare A = rgbft <.1,.2,.3,.4,.5>; #declare B = color A; #declare C = rgb A; #declare D = A; #declare E = color A*.5+A*.5; #declare H = color A filter .9;
#debug concat(vstr(5, B, ",", 0, 3), "\n")
#debug concat(vstr(5, C, ",", 0, 3), "\n")
#debug concat(vstr(5, D, ",", 0, 3), "\n")
#debug concat(vstr(5, E, ",", 0, 3), "\n")
#debug concat(vstr(5, H, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.400,0.500
// expect: 0.100,0.200,0.300,0.400,0.500
// expect: 0.100,0.200,0.300,0.400,0.500
// expect: 0.100,0.200,0.300,0.400,0.500
// expect: 0.100,0.200,0.300,0.900,0.500

//= a bare colour variable takes no words
#declare A = rgb 1; #declare G = A transmit .9;
// error: D0101 at 1:30

//= a second rgb ends the colour
#declare A = array[2] { rgb 1 rgb 0 }
#debug concat(vstr(3, A[0], ",", 0, 3), "\n")
#debug concat(vstr(3, A[1], ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000
// expect: 0.000,0.000,0.000

//= single precision
#declare A = rgb 0.1; #declare B = <0.1,0.1,0.1,0,0>;
#debug concat(str(A.red, 0, 12), "\n")
#debug concat(str(B.red, 0, 12), "\n")
// expect: 0.100000001490
// expect: 0.100000001490

//= rgb is no primary
#declare A = 2*rgb 1;
// error: D0101 at 1:16

//= rgb does not follow an operator
#declare R = rgb 1; #declare A = R + rgb y;
// error: D0101 at 1:38

//= rgb does not stand in parentheses
#declare A = (rgb 1);
// error: D0201 at 1:15

//= a string is no colour
#declare A = rgb "red";
// error: D0204 at 1:18

//= @ in front of a value
#declare C = @ <0.1,0.2,0.3,0.4,0.5>; #debug concat(vstr(3, C, ",", 0, 3), "\n")
// each: rgb rgbf rgbft color colour 'color rgb' 'colour rgbft'
// expect: 0.100,0.200,0.300

//= rgbt moves its fourth value
#declare C = rgbt <0.1,0.2,0.3,0.4>; #debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.000,0.400

//= words of single components in any order
#declare C = color transmit 0.5 blue 0.3 red 0.1 green 0.2 filter 0.4; #debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 0.100,0.200,0.300,0.400,0.500

//= alpha is filter
#declare C = rgb 1 alpha 0.25; #debug concat(vstr(5, C, ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000,0.250,0.000

//= @ takes only red, green and blue
light_source { 0, rgbft <1,1,1,0.5,0.5> } sphere { 0, 1 finish { ambient rgbt <1,1,1,1> } } #debug "fine\n"
// expect: fine

//= expression as operand of a colour
#declare A = <1,0.5,0.25>; #declare C = color A*0.5 + 0.25; #debug concat(vstr(5, C, ",", 0, 4), "\n")
// expect: 0.7500,0.5000,0.3750,0.0000,0.0000

//= @ is no operand
#declare A = 2*@;
// each: 'rgb 1' 'color 1' 'red 1'
// error: D0101 at 1:16

//= @ decodes three components
#declare C = @ <0.5,0.25,1,0.5,0.5>; #debug concat(vstr(3, C, ",", 0, 5), "\n")
// each: srgb srgbft srgbf
// expect: 0.21404,0.05088,1.00000

//= a colour in parentheses
#declare A = (rgb 1);
// error: D0201 at 1:15
