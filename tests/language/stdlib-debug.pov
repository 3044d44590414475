// The standard includes: debug.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "debug.inc"

//= DEBUG
#debug concat(str(DEBUG, 0, 9), "\n")
// expect: 1.000000000

//= Set_Debug
Set_Debug(false) Debug_Message("no\n") Set_Debug(true) Debug_Message("yes\n")
// expect: yes

//= Debug_Message
Debug_Message("told\n")
// expect: told

//= Debug
Debug((1 > 2), "no\n") Debug((2 > 1), "yes\n")
// expect: yes

//= Warning goes on
Warning(true, "careful\n")
#debug "on\n"
// expect: on

//= Error only if its condition holds
Error((1 > 2), "no\n") #debug "on\n"
// expect: on

//= Error ends the run
Error((2 > 1), "over\n")
// before
// error: D0304 at debug.inc:54:5

//= Debug_Inc_Stack tells what is included
Debug_Inc_Stack()
#include "consts.inc"
#include "math.inc"
// expect: including consts.inc
// expect: including math.inc
// expect: including function.inc
