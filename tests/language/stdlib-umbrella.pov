// The standard includes: files that bring others.
#version 3.7;
global_settings { assumed_gamma 1 }


//= stdinc.inc brings them all
#include "stdinc.inc"
#debug concat(str(e, 0, 9), "\n")
#ifdef (Red) #ifdef (Disk_X) #ifdef (RdmA) #ifdef (MATH_INC_TEMP) #ifdef (TRANSFORMS_INC_TEMP) #debug "all\n" #end #end #end #end #end
// expect: 2.718281828
// expect: all

//= stones.inc, stoneold.inc
#include "colors.inc"
#include "stones.inc"
#include "stoneold.inc"
#ifdef (T_Stone44) #ifdef (Grnt29) #ifdef (T_Grnt0a) #debug "all\n" #end #end #end
// expect: all

//= stage1.inc
#include "stage1.inc"
#ifdef (Camera1) #debug "there\n" #end
// expect: there

//= stdcam.inc
#include "colors.inc"
#include "stdcam.inc"
#include "stdcam.inc"
#debug "twice\n"
// expect: twice

//= guards are numbers
#include "math.inc"
#debug #if (MATH_INC_TEMP > 3 & Functions_Inc_Temp > 3) "yes\n" #else "no\n" #end
// expect: yes

//= the version stays
#include "shapes3.inc"
#include "woods.inc"
#debug concat(str(version, 0, 9), "\n")
// expect: 3.700000000

//= e and o are names like others
#include "consts.inc"
#declare e = 5;
#debug concat(str(e, 0, 9), "\n")
// expect: 5.000000000
