// The standard includes: colors.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"

//= CH2RGB
#debug concat(vstr(3, CH2RGB(-30), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(0), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(59), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(60), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(120), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(121), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(180), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(240), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(300), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(359), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(360), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(400), " ", 0, 9), "\n")
#debug concat(vstr(3, CH2RGB(-400), " ", 0, 9), "\n")
// expect: 1.000000000 0.000000000 0.500000000
// expect: 1.000000000 0.000000000 0.000000000
// expect: 1.000000000 0.983333333 0.000000000
// expect: 1.000000000 1.000000000 0.000000000
// expect: 0.000000000 1.000000000 0.000000000
// expect: 0.000000000 1.000000000 0.016666667
// expect: 0.000000000 1.000000000 1.000000000
// expect: 0.000000000 0.000000000 1.000000000
// expect: 1.000000000 0.000000000 1.000000000
// expect: 1.000000000 0.000000000 0.016666667
// expect: 1.000000000 0.000000000 0.000000000
// expect: 1.000000000 0.666666667 0.000000000
// expect: 1.000000000 0.000000000 0.666666667

//= CRGB2H
#debug concat(str(CRGB2H(rgb <0.2,0.4,0.6>, 0.6, 0.4), 0, 9), "\n")
#debug concat(str(CRGB2H(rgb <1,0,0.5>, 1, 1), 0, 9), "\n")
#debug concat(str(CRGB2H(rgb <1,1,0>, 1, 1), 0, 9), "\n")
#debug concat(str(CRGB2H(rgb <0,1,0.5>, 1, 1), 0, 9), "\n")
#debug concat(str(CRGB2H(rgb 0.5, 0.5, 0), 0, 9), "\n")
// expect: 0.000000000
// expect: -30.000000000
// expect: 60.000000000
// expect: 150.000000000
// expect: 0.000000000

//= CHSL2RGB
#local Out = CHSL2RGB(<210,0.5,0.4>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CHSL2RGB(<210,0.5,0.7,0.1,0.2>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CHSL2RGB(<-30,1,0.5>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CHSL2RGB(<700,0.3,0.5>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.200000003 0.400000006 0.600000024 0.000000000 0.000000000
// expect: 0.549999952 0.699999988 0.850000024 0.100000001 0.200000003
// expect: 1.000000000 0.000000000 0.500000000 0.000000000 0.000000000
// expect: 0.649999976 0.349999994 0.449999988 0.000000000 0.000000000

//= CRGB2HSL
#local Out = CRGB2HSL(<0.2,0.4,0.6>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSL(rgb <0.2,0.4,0.6>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSL(rgbft <0.9,0.4,0.6,0.1,0.2>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSL(rgb 0); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSL(rgb 1); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSL(rgb <1,0.2,0.9>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 210.000000000 0.500000000 0.400000006 0.000000000 0.000000000
// expect: 210.000000000 0.500000000 0.400000006 0.000000000 0.000000000
// expect: -24.000003815 0.714285672 0.649999976 0.100000001 0.200000003
// expect: 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000
// expect: 0.000000000 0.000000000 1.000000000 0.000000000 0.000000000
// expect: -52.500000000 1.000000000 0.600000024 0.000000000 0.000000000

//= CHSV2RGB
#local Out = CHSV2RGB(<210,0.6667,0.6>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CHSV2RGB(<30,0.5,0.7,0.1,0.2>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CHSV2RGB(<30,0,0.7>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.199980006 0.399990022 0.600000024 0.000000000 0.000000000
// expect: 0.699999988 0.524999976 0.349999994 0.100000001 0.200000003
// expect: 0.699999988 0.699999988 0.699999988 0.000000000 0.000000000

//= CRGB2HSV
#local Out = CRGB2HSV(<0.2,0.4,0.6>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSV(rgbft <0.9,0.4,0.6,0.1,0.2>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSV(rgb 0); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = CRGB2HSV(rgb 1); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 210.000000000 0.666666687 0.600000024 0.000000000 0.000000000
// expect: -24.000003815 0.555555522 0.899999976 0.100000001 0.200000003
// expect: 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000
// expect: 0.000000000 0.000000000 1.000000000 0.000000000 0.000000000

//= colours are plain numbers
#local Out = Red; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Clear; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Gray95; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Gray; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = LightGray; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Mica; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = MediumSlateBlue; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = BlueViolet; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = SkyBlue; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Very_Light_Purple; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = OrangeRed; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Feldspar; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 1.000000000 0.000000000 0.000000000 0.000000000 0.000000000
// expect: 1.000000000 1.000000000 1.000000000 1.000000000 0.000000000
// expect: 0.949999988 0.949999988 0.949999988 0.000000000 0.000000000
// expect: 0.752941012 0.752941012 0.752941012 0.000000000 0.000000000
// expect: 0.658824027 0.658824027 0.658824027 0.000000000 0.000000000
// expect: 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000
// expect: 0.498039007 0.000000000 1.000000000 0.000000000 0.000000000
// expect: 0.623520017 0.372548997 0.623529017 0.000000000 0.000000000
// expect: 0.196078002 0.600000024 0.800000012 0.000000000 0.000000000
// expect: 0.939999998 0.810000002 0.990000010 0.000000000 0.000000000
// expect: 1.000000000 0.250000000 0.000000000 0.000000000 0.000000000
// expect: 0.819999993 0.569999993 0.460000008 0.000000000 0.000000000
